"""How far apart right processors interpolate, against a naive sum of what each of them may have otherwise."""

from itertools import product

import numpy as np
import pytest
from plain_kernels import plain

from sss_ref.raster.primitives import Primitives
from sss_ref.validation.accept.rasterizer import interpolation as kernels
from sss_ref.validation.accept.rasterizer.interpolation import LooseCorner, Uncertain

ROUNDING = 1e-12  # relative: the same sums in another order
PLACES = np.array([(-3.0, -2.0), (7.0, 1.0), (1.0, 5.0)])  # pixels
WEIGHTS = np.float32([0.5, 2.0, 1.25])  # 1/w
VALUES = np.float32([(9, 1.0, -3.0), (9, 4.0, 2.0), (9, 0.5, 7.0)])
ERRORS = np.array([(9, 0.01, 0.25), (9, 0.02, 0.125), (9, 0.005, 0.5)])
OFF = np.array([(0.125, 0.25), (0.0625, 0.03125), (0.5, 0.375)])
SHARES = np.array([0.01, 0.02, 0.005])
PIXEL = (2, 1)
NOTHING = (np.zeros((3, 2)), np.zeros((1, 2)), np.zeros(3))


@pytest.fixture(autouse=True)
def as_python(monkeypatch):
    plain(kernels, monkeypatch)


def slack(off, rounding, shares, places=PLACES, errors=ERRORS):
    """The slack of attributes 1 and 2 at a pixel of the one triangle, which has (1.5, -0.5) there."""
    snapped = np.rint(places * 16).astype(np.int32)
    corners, triangle = np.array([(0, 1, 2)], np.int32), np.zeros(1, np.int32)
    primitives = Primitives(corners, triangle, snapped, np.zeros(3, np.float32), WEIGHTS, VALUES)
    found, own = np.full((1, 2), -1.0), np.array([(1.5, -0.5)])
    known = Uncertain(off, rounding, shares, errors, 16.0)
    kernels.fill_slack(primitives, known, np.array([0]), np.array([PIXEL]), own, 1, found)
    return found[0]


def naive(off, rounding, shares):
    """sum(D_i*|a_i - a|) / (sum(E_i) - sum(D_i)), and what planes lose, over what is left of the sum of weights."""
    seen, weights, changes = PLACES - PIXEL, [], []
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        edge = seen[j, 0] * seen[k, 1] - seen[k, 0] * seen[j, 1]
        moved = sum(
            max(
                abs((seen[p, x] + way * off[p, x]) * (seen[q, y] + other * off[q, y]) - seen[p, x] * seen[q, y])
                for way, other in product((-1, 1), repeat=2)
            )
            for p, x, q, y in ((j, 0, k, 1), (k, 0, j, 1))
        )
        weights.append(edge * WEIGHTS[i])
        changes.append((moved + abs(edge) * shares[i]) * WEIGHTS[i])
    lost = rounding[0, 0] * np.ptp(seen[:, 1]) + rounding[0, 1] * np.ptp(seen[:, 0])
    of_weights = lost * np.ptp(WEIGHTS.astype(float))
    least = abs(sum(weights)) - sum(changes) - of_weights
    found = []
    for column, here in ((1, 1.5), (2, -0.5)):
        values = VALUES[:, column].astype(float)
        apart = sum(change * abs(value - here) for change, value in zip(changes, values, strict=True))
        apart += lost * np.ptp(values * WEIGHTS) + of_weights * abs(here)
        found.append(apart / least + ERRORS[:, column].max())
    return found


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("off", "rounding", "shares"), list(product((0, 1), repeat=3)))
def test_the_slack_is_the_sum_of_what_may_be_otherwise(off, rounding, shares, sign, monkeypatch):
    """In whichever way the triangle turns."""
    monkeypatch.setitem(globals(), "PLACES", PLACES * (sign, 1))
    given = OFF * off, np.array([(0.01, 0.03)]) * rounding, SHARES * shares
    assert np.allclose(slack(*given, places=PLACES), naive(*given), rtol=ROUNDING, atol=0)


def test_without_anything_uncertain_that_of_the_vertices_is_left():
    assert slack(*NOTHING).tolist() == [0.02, 0.5]
    for shifted in (np.roll(ERRORS, 1, axis=0), np.roll(ERRORS, 2, axis=0)):
        assert slack(*NOTHING, errors=shifted).tolist() == [0.02, 0.5]


def test_on_a_sliver_it_is_infinite():
    assert slack(*NOTHING, places=PLACES * (1, 0) + (0, PIXEL[1])).tolist() == [np.inf, np.inf]
    assert slack(np.full((3, 2), 9.0), *NOTHING[1:]).tolist() == [np.inf, np.inf]


def test_a_corner_is_seen_from_a_pixel():
    off, shares = np.array([(0, 0), (0.25, 0.5)]), np.array([0, 0.125])
    found = kernels.corner(np.array([(0, 0), (40, -24)]), np.float32([1, 0.75]), off, shares, 16.0, 1, 3, 2)
    assert found == LooseCorner(40 / 16 - 3, -24 / 16 - 2, 0.25, 0.5, 0.75, 0.125)


@pytest.mark.parametrize(("a", "b", "c"), [(1.0, 5.0, 3.0), (5.0, 3.0, 1.0), (3.0, 1.0, 5.0), (3.0, 5.0, 1.0)])
def test_how_far_three_numbers_lie_apart(a, b, c):
    assert kernels.extent(a, b, c) == 4 and kernels.extent(-a, -b, -c) == 4
