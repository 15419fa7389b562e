import hashlib
import math

import pytest
from pydantic import TypeAdapter, ValidationError

from sss_ref.batch.draws import Values, chances

VALUES = TypeAdapter(Values)
SEED = 7


def drawn(item=0, **given):
    return VALUES.validate_python(given).drawn(chances(SEED, "key", item))


def test_a_chance_is_the_first_53_bits_of_a_hash_of_where_it_is():
    numbers = chances(3, "camera.azimuth", 12)
    for place in range(3):
        text = f"sss_ref draw 1\n3\ncamera.azimuth\n12\n{place}\n"
        assert next(numbers) == int(hashlib.sha256(text.encode()).hexdigest()[:16], 16) // 2**11 / 2**53


def test_no_draw_is_like_that_of_another_item_key_or_seed():
    places = [(seed, key, item) for seed in range(3) for key in ("a", "b") for item in range(50)]
    assert len({next(chances(*place)) for place in places}) == len(places)


@pytest.mark.parametrize(
    "given, values",
    [
        ({"first": 0, "last": 270, "count": 4}, (0, 90, 180, 270)),
        ({"first": 0, "last": 1, "count": 3}, (0, 0.5, 1)),
        ({"first": 0.1, "last": 0.3, "count": 3}, (0.1, 0.2, 0.3)),
        ({"first": 1, "last": -1, "count": 2}, (1, -1)),
    ],
)
def test_spaced_numbers_have_both_ends_and_whole_ones_stay_whole(given, values):
    found = VALUES.validate_python(given).values
    assert found == values
    assert list(map(type, found)) == list(map(type, values))


def test_uniform_numbers_fill_their_range():
    found = [drawn(item, random="uniform", low=-2, high=3) for item in range(2000)]
    assert -2 <= min(found) < -1.98 and 2.98 < max(found) < 3
    assert abs(sum(found) / 2000 - 0.5) < 0.1  # standard deviation of the mean: 0.032


def test_each_of_three_is_drawn_for_itself():
    found = drawn(random="uniform", low=[0, 1, 2], high=[1, 2, 3.5])
    assert [math.floor(x) for x in found[:2]] == [0, 1] and 2 <= found[2] < 3.5
    assert found[0] != found[1] - 1


ITEMS = range(20)


def numbers(item):
    """The chances that `drawn` takes for an item."""
    return chances(SEED, "key", item)


def test_a_uniform_number_is_a_share_of_the_way_from_low_to_high():
    for item in ITEMS:
        u, v, w = (next(each) for each in [numbers(item)] * 3)
        assert drawn(item, random="uniform", low=2, high=5.5) == 2 + u * (5.5 - 2)
        assert drawn(item, random="uniform", low=3.0, high=3.0) == 3.0
        three = drawn(item, random="uniform", low=[0, 1, -2], high=[1, 4, 3.5])
        assert three == [0 + u * (1 - 0), 1 + v * (4 - 1), -2 + w * (3.5 - -2)]


def test_a_whole_number_and_a_choice_are_the_place_of_a_number_among_them():
    for item in ITEMS:
        u = next(numbers(item))
        assert drawn(item, random="integer", low=-3, high=4) == -3 + math.floor(u * 8)
        assert drawn(item, random="integer", low=6, high=6) == 6
        assert drawn(item, random="choice", values=[5, "b", [1], 0.5, 7]) == [5, "b", [1], 0.5, 7][math.floor(u * 5)]


def test_a_point_of_a_sphere_is_one_of_the_disc_laid_onto_it():
    """Marsaglia 1972, about the first pair of numbers that lies in the unit circle."""
    tries = set()
    for item in ITEMS:
        found, count = numbers(item), 0
        x, y = 1.0, 1.0
        while x * x + y * y >= 1:
            x, y, count = 2 * next(found) - 1, 2 * next(found) - 1, count + 1
        tries.add(count)
        square = x * x + y * y
        slope = 2 * math.sqrt(1 - square)
        point = drawn(item, random="sphere", radius=3.0, center=[1, -2, 0.5])
        assert point == [1 + 3.0 * (slope * x), -2 + 3.0 * (slope * y), 0.5 + 3.0 * (1 - 2 * square)]
        unit = drawn(item, random="sphere", radius=1.0)
        assert unit == [slope * x, slope * y, 1 - 2 * square]
    assert tries >= {1, 2}


def test_a_pair_on_the_circle_is_drawn_again():
    """-1 and 0 are on it; then 0 and 0, its middle, which is the sphere's pole."""
    sphere = VALUES.validate_python({"random": "sphere", "radius": 2.0})
    assert sphere.drawn(iter([0.0, 0.5, 0.5, 0.5])) == [0.0, 0.0, 2.0]


def test_log_uniform_is_as_often_below_the_geometric_mean_as_above():
    found = [drawn(item, random="log_uniform", low=0.01, high=100.0) for item in range(1000)]
    assert 0.01 <= min(found) < max(found) < 100
    assert abs(sum(x < 1 for x in found) - 500) < 80  # 5 standard deviations
    assert found[0] == pytest.approx(0.01 * 1e4 ** next(chances(SEED, "key", 0)), rel=1e-14)  # libm's own rounding


def test_whole_numbers_and_choices_reach_both_ends():
    assert {drawn(item, random="integer", low=2, high=4) for item in range(100)} == {2, 3, 4}
    assert {drawn(item, random="choice", values=["a", 1.5]) for item in range(100)} == {"a", 1.5}


def test_points_lie_on_the_sphere_evenly():
    points = [drawn(item, random="sphere", radius=2.0, center=[1, 0, 0]) for item in range(1000)]
    assert all(math.dist(point, (1, 0, 0)) == pytest.approx(2, rel=1e-12) for point in points)  # a few roundings
    for axis in range(3):
        upper = sum(point[axis] > (1, 0, 0)[axis] + 1 for point in points)
        assert abs(upper - 250) < 70  # a zone's area is its height: a quarter; 5 standard deviations


LARGEST = 3.4e38  # float32 has it, and 3.5e38 no more


@pytest.mark.parametrize(
    "given",
    [
        [0],
        {"first": 0, "last": 1, "count": 2},
        {"first": 0, "last": 1, "count": 10**6},
        {"first": -LARGEST, "last": LARGEST, "count": 2},
        {"random": "integer", "low": 1 - 2**31, "high": 2**31 - 1},
        {"random": "uniform", "low": [0, 1, 2], "high": [-LARGEST, 2, 3]},
        {"random": "choice", "values": [{"a": [1]}]},
        {"random": "log_uniform", "low": 0.1, "high": 0.1},
    ],
)
def test_the_ends_of_what_may_be_given(given):
    VALUES.validate_python(given)


@pytest.mark.parametrize(
    "given",
    [
        [],
        {"first": 0, "last": 1, "count": 10**6 + 1},
        {"first": 0, "last": 3.5e38, "count": 2},
        {"first": -3.5e38, "last": 0, "count": 2},
        {"first": "0", "last": 1, "count": 2},
        {"random": "integer", "low": -(2**31), "high": 0},
        {"random": "integer", "low": 0, "high": 2**31},
        {"random": "uniform", "low": [0, 1], "high": [1, 2]},
        {"random": "uniform", "low": [0, 1, 2, 3], "high": [1, 2, 3, 4]},
        {"random": "uniform", "low": [0, 1, "a"], "high": [1, 2, 3]},
        {"random": "uniform", "low": [0, 1, 2], "high": 3},
        {"random": "uniform", "low": 0, "high": "1"},
        {"random": "choice", "values": [1, {"a": [math.inf]}]},
        [1, {"a": math.nan}],
        {"first": 0, "last": 1, "count": 1},
        {"first": 0, "last": math.inf, "count": 2},
        {"first": True, "last": 2, "count": 2},
        {"random": "uniform", "low": 0},
        {"random": "uniform", "low": 0, "high": [1, 2, 3]},
        {"random": "log_uniform", "low": 0, "high": 1},
        {"random": "integer", "low": 2, "high": 1},
        {"random": "integer", "low": 0, "high": 1.5},
        {"random": "choice", "values": []},
        {"random": "sphere", "radius": 0},
        {"random": "dice"},
        {"random": 3},
        {"random": "uniform", "low": 0, "high": 1, "seed": 3},
    ],
)
def test_what_is_no_range_is_refused(given):
    with pytest.raises(ValidationError):
        VALUES.validate_python(given)
