"""How much channels are alike, held against a loop over pairs of channels and their pixels."""

import math
import statistics

import numpy as np
import pytest

from sss_ref.capture.resemblance import Columns, resemblance, uncommon

ONE = pytest.approx(1, rel=1e-12)  # the sum of the parts' weights


def orders(share, least):
    return math.log10(min(max(share, least), 1)) / math.log10(least)


def ranks(values):
    return [sum(other < value for other in values) + (values.count(value) + 1) / 2 for value in values]


def correlated(a, b):
    if len(set(a)) == 1 or len(set(b)) == 1:
        return 0.0
    return min(max(statistics.correlation(a, b), 0), 1)


def naive(held, expected, drawn, wanted, tolerance, whole):
    """Half by how near the numbers are, a fifth by a line, a fifth by the order, a tenth by where something is."""
    low, high = np.percentile(expected, (5, 95))
    spread = (high - low) / 2
    apart = [abs(a - b) for a, b in zip(held, expected, strict=True)]
    if whole:
        close = orders(sum(each > off + 1e-4 for each, off in zip(apart, tolerance, strict=True)) / len(held), 1e-4)
    else:
        near = [(each - off) / spread for each, off in zip(apart, tolerance, strict=True)]
        close = sum(orders(each, 1e-4) for each in near) / len(near)
    straight = orders(math.sqrt(1 - correlated(held, expected) ** 2), 1e-2)
    ordered = orders(math.sqrt(1 - min(correlated(ranks(held), ranks(expected)), 1) ** 2), 1e-2)
    both, either = sum(drawn & wanted), sum(drawn | wanted)
    return 0.5 * close + 0.2 * straight + 0.2 * ordered + 0.1 * (both / either), close


@pytest.mark.parametrize("whole", [False, True])
def test_every_pair_of_channels(whole):
    generator = np.random.default_rng(3)
    expected = generator.integers(0, 9, (40, 3)) + np.array([0.0, 0.25, 0.5])
    held = np.stack([expected[:, 1], expected[:, 0] ** 2, -expected[:, 2], expected[:, 2] + 0.01], axis=1)
    drawn, wanted = generator.random((25, 4)) < 0.5, generator.random((25, 3)) < 0.5
    tolerance = generator.choice([0.0, 0.3], held.shape)
    found = resemblance(Columns.of(held, drawn), Columns.of(expected, wanted), tolerance, whole)
    for i, j in np.ndindex(4, 3):
        given = held[:, i].tolist(), expected[:, j].tolist(), drawn[:, i], wanted[:, j], tolerance[:, i]
        total, close = naive(*given, whole)
        assert found.total[i, j] == pytest.approx(total, rel=1e-7)  # near a line, roundings are of 1 - r^2
        assert found.close[i, j] == pytest.approx(close, rel=1e-12)


def test_the_same_is_alike_and_a_squared_distance_in_perfect_order():
    distance = np.linspace(1, 3, 20)[:, None]
    alone = Columns.of(distance, np.ones((9, 1), bool))
    assert resemblance(alone, alone, np.zeros((20, 1)), False).total == pytest.approx(1, abs=1e-9)
    squared = resemblance(Columns.of(distance**2, alone.drawn), alone, np.zeros((20, 1)), False)
    assert 0.3 < squared.total < 0.6 and squared.close < 0.1


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e3])
def test_what_does_not_vary_is_told_by_its_numbers_alone(unit):
    """A hundredth of the value is its spread: 1.0001 is a hundredth of that beside, half of the orders that count."""
    one = Columns.of(np.full((4, 1), unit), np.zeros((9, 1), bool))
    near = Columns.of(np.full((4, 1), 1.0001 * unit), np.zeros((9, 1), bool))
    found = resemblance(near, one, np.zeros((4, 1)), False)
    assert found.close == pytest.approx(0.5) and found.total == pytest.approx(0.9 * 0.5 + 0.1)


def test_the_unit_of_length_is_all_the_same():
    distance = np.linspace(1, 3, 20)[:, None]
    drawn, off = np.ones((9, 1), bool), np.zeros((20, 1))
    totals = [
        resemblance(Columns.of(distance**2 * unit, drawn), Columns.of(distance * unit, drawn), off, False).total
        for unit in (1.0, 1e-9)
    ]
    assert totals[0] == pytest.approx(totals[1], rel=1e-9)


def test_nothing_and_one_pixel_are_pictures_too():
    nothing, dot = np.zeros((9, 1), bool), np.eye(9, 1, dtype=bool)
    assert resemblance(*[Columns.of(np.zeros((4, 1)), nothing)] * 2, np.zeros((4, 1)), False).total == ONE
    assert resemblance(*[Columns.of(np.ones((4, 1)), dot)] * 2, np.zeros((4, 1)), False).total == ONE


def test_one_pixel_beside_nothing_is_not_shaped_like_it():
    same, nothing, dot = np.ones((4, 1)), np.zeros((9, 1), bool), np.eye(9, 1, dtype=bool)
    found = resemblance(Columns.of(same, dot), Columns.of(same, nothing), np.zeros((4, 1)), False)
    assert found.total == pytest.approx(0.9)


@pytest.mark.parametrize(("number", "close"), [(1e-4, 1), (1.001e-4, 0)])
def test_whole_numbers_are_the_same_up_to_a_ten_thousandth(number, close):
    held, expected = (Columns.of(np.full((4, 1), each), np.zeros((9, 1), bool)) for each in (number, 0.0))
    assert resemblance(held, expected, np.zeros((4, 1)), True).close == close


def test_uncommon_is_what_is_not_the_commonest_of_its_channel():
    values = np.array([[0, 5], [0, 6], [1, 6], [2, 6]])
    assert uncommon(values).tolist() == [[False, True], [False, False], [True, False], [True, False]]
