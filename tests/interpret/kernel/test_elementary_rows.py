"""Elementary functions by rows: the bits of the array forms, those in doubt among them."""

import numpy as np
import pytest

from sss_ref.interpret.kernel.elementary_rows import ELEMENTARY_ROWS
from sss_ref.interpret.kernel.modules import address_of
from sss_ref.interpret.kernel.program import STRIP, Program, run
from sss_ref.numerics import elementary

F = np.float32
SPECIAL = np.array([0, -0.0, 1, -1, np.inf, -np.inf, np.nan, 1e-45, 3.4e38, 2, 0.5], F)


def by_rows(name, *arguments):
    program, count = Program(), len(arguments[0])
    rows = program.rows(len(arguments) + 1)
    program.add(address_of(ELEMENTARY_ROWS[name]), rows)
    scratch = np.zeros((program.used, STRIP), F)
    for row, values in zip(rows, arguments, strict=False):
        scratch[row, :count] = values
    run(program.calls, scratch.reshape(-1), count)
    return scratch[rows[-1], :count].copy()


def same(found, expected):
    return (found.view(np.int32) == expected.view(np.int32)) | (np.isnan(found) & np.isnan(expected))


@pytest.mark.parametrize("name", ["exp", "exp2", "log2"])
@pytest.mark.parametrize("count", [1, 11, STRIP])
def test_one_argument(name, count):
    rng = np.random.default_rng(3)
    values = np.concatenate([SPECIAL, rng.normal(scale=20, size=STRIP).astype(F)])[:count]
    assert same(by_rows(name, values), getattr(elementary, f"{name}_array")(values)).all()


@pytest.mark.parametrize("count", [1, 121, STRIP])
def test_pow(count):
    rng = np.random.default_rng(4)
    x = np.concatenate([np.repeat(SPECIAL, len(SPECIAL)), np.exp(rng.normal(scale=3, size=STRIP)).astype(F)])[:count]
    y = np.concatenate([np.tile(SPECIAL, len(SPECIAL)), rng.normal(scale=3, size=STRIP).astype(F)])[:count]
    assert same(by_rows("pow", x, y), elementary.pow_array(x, y)).all()


def test_a_doubtful_element_is_computed_slowly():
    """The square of an odd number of 13 bits lies half-way between two float32: no bracket can settle it."""
    x = np.arange(STRIP).astype(F) + F(4096)
    y = np.full(STRIP, 2, F)
    low, high = elementary.pow_bracket(x.astype(np.float64), y.astype(np.float64))
    assert (low < high).any()
    assert same(by_rows("pow", x, y), elementary.pow_array(x, y)).all()
