"""Rows that are compiled give the bits that NumPy gives, for ordinary numbers and for all others."""

from itertools import product

import numpy as np
import pytest

from sss_ref.numerics import outward
from sss_ref.numerics.bounded import Bounded
from sss_ref.numerics.interval import Interval, point

SPECIAL = (0.0, -0.0, 1.0, -1.0, 0.1, 2.0**-126, 2.0**-127, -(2.0**-140), 1e-300, 3.4028235e38, 3.5e38, -1e300)
NEXT_TO_ONE = (1 + 2.0**-52, 1 - 2.0**-53, 2.0**-60, -(2.0**-60))  # sums of them err, by what changes the rounding
NOT_FINITE = (np.inf, -np.inf, np.nan)
KINDS = [Bounded(), Bounded(relative=2.0**-10, smallest_normal=2.0**-14, largest=65504.0)]


def intervals(seed: int, values: tuple[float, ...]) -> tuple[Interval, Interval]:
    """Two intervals of special numbers, every pair of them, and of random ones of every size."""
    rng = np.random.default_rng(seed)
    pairs = np.array(list(product(values, values))).T
    sizes = rng.standard_normal((2, 600)) * 2.0 ** rng.integers(-40, 40, (2, 600))
    a, b = np.concatenate([pairs, sizes], axis=1)
    with np.errstate(invalid="ignore"):
        width_a, width_b = (np.abs(x) * rng.choice([0, 1e-7, 0.5], len(x)) for x in (a, b))
        return Interval(a, a + width_a), Interval(b, b + width_b)


def same(found: Interval, expected: Interval) -> None:
    for a, b in ((found.low, expected.low), (found.high, expected.high)):
        np.testing.assert_array_equal(np.asarray(a).view(np.int64), np.asarray(b).view(np.int64))


@pytest.mark.parametrize("kind", KINDS, ids=["vulkan", "coarse"])
@pytest.mark.parametrize("values", [SPECIAL + NEXT_TO_ONE, SPECIAL + NOT_FINITE], ids=["finite", "all"])
def test_rows_are_what_numpy_makes_of_them(monkeypatch: pytest.MonkeyPatch, kind: Bounded, values: tuple[float, ...]):
    a, b = intervals(7, values)
    t = Interval(np.float64(0.3), np.float64(0.3)), Interval(np.float64(0.0), np.float64(0.0))
    operations = {
        "add": lambda: kind.add(a, b),
        "add points": lambda: kind.add(point(a.low), point(b.low)),
        "add a number": lambda: kind.add(a, point(np.float64(0.1))),
        "multiply": lambda: kind.multiply(a, b),
        "multiply points": lambda: kind.multiply(point(a.low), point(b.low)),
        "representable": lambda: kind.representable(a),
        "dot": lambda: kind.dot([a, b], [b, a]),
        "bilinear": lambda: kind.bilinear((a, b), (b, a), t),
        "mix": lambda: kind.mix(a, b, point(np.abs(np.sin(a.low)))),
        "divide": lambda: kind.divide(a, b),
    }
    with np.errstate(all="ignore"):
        fast = {name: operation() for name, operation in operations.items()}
        monkeypatch.setattr(outward, "LEAST", len(a.low) + 1)
        for name, operation in operations.items():
            same(fast[name], operation())


@pytest.mark.parametrize("end", ["low", "high"])
@pytest.mark.parametrize("operation", ["add", "multiply", "mix", "divide"])
def test_a_row_with_one_end_out_of_range_is_what_numpy_makes_of_it(monkeypatch, operation, end):
    """Of all ends but one it is known that they are ordinary."""
    low, high = np.ones(300), np.full(300, 2.0)
    (low if end == "low" else high)[150] = -1e-300 if end == "low" else 3e38
    a, b = Interval(low, high), Interval(np.ones(300), np.full(300, 4.0))
    operations = {
        "add": lambda: KINDS[0].add(a, Interval(b.low * 0, b.high * 0.5e38)),
        "multiply": lambda: KINDS[0].multiply(a, b),
        "mix": lambda: KINDS[0].mix(a, point(np.zeros(300)), point(np.zeros(300))),
        "divide": lambda: KINDS[0].divide(a, Interval(b.low * 0.25, b.high)),
    }
    fast = operations[operation]()
    monkeypatch.setattr(outward, "LEAST", 301)
    same(fast, operations[operation]())
    assert (fast.low[0], np.isfinite(fast.high[0])) != (fast.low[150], np.isfinite(fast.high[150]))


ORDINARY = (0.0, -0.0, 1.0, -(2.0**-126), 2.0**-126, float(np.finfo(np.float32).max))
STRANGE = (2.0**-127, -(2.0**-149), 3.5e38, -1e300, np.inf, np.nan)


@pytest.mark.parametrize("value", ORDINARY + STRANGE)
def test_one_strange_number_in_a_row_is_told(value: float):
    """A row whose ends are all ordinary is what an interval keeps; any other goes through NumPy."""
    row, bounds = np.ones(300), (2.0**-126, float(np.finfo(np.float32).max))
    row[150] = value
    zeros = np.zeros_like(row)
    assert outward.are_ordinary(row, *bounds) == (value in ORDINARY)
    for ends in (outward.rounded_down, outward.rounded_up):
        assert ends(row, *bounds)[1] == (value in ORDINARY)
    for ends in (outward.lows, outward.highs, outward.sums_down, outward.sums_up):
        assert ends(row, zeros, *bounds)[1] == (value in ORDINARY)


def test_few_elements_other_types_and_scalars_are_no_rows():
    row = np.zeros(outward.LEAST)
    assert outward.rows_of(row[1:]) is None and outward.rows_of(np.float64(1), np.float64(2)) is None
    assert outward.rows_of(row, row.astype(np.int64)) is None
    first, again, number = outward.rows_of(row, row, np.float64(3)) or []
    assert first is row and again is row and (number == 3).all() and number.shape == row.shape


def test_what_is_no_memory_of_its_own_is_copied():
    row = np.zeros((outward.LEAST, 2))[:, 0]
    for given in (row, np.broadcast_to(np.float64(2), outward.LEAST)):
        (made,) = outward.rows_of(given) or []
        assert made.flags.c_contiguous and made.flags.writeable and np.array_equal(made, given)
