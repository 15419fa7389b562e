"""Other numbers for the uniforms of a stage."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest
from planted import NUMBERS, Planted, instead, oracle_of, scene_of, vertex

from sss_ref.language import stage, vec3
from sss_ref.validation.cause.hypothesis import FITTED, INPUT, NUMBER
from sss_ref.validation.cause.other_numbers import _apart, _fitted, _own_numbers, lengthened, other_numbers
from sss_ref.validation.cause.sample import Sample
from sss_ref.validation.clock import Limit
from sss_ref.validation.scope import Scope
from sss_ref.validation.stage_by_stage import validate


@pytest.fixture(scope="module")
def oracle():
    return oracle_of(scene_of("bust", 32))


@pytest.mark.parametrize(
    ("name", "value", "rank", "text"),
    [
        ("wrap", 0.0, NUMBER, "wrap is 0 instead"),
        ("shininess", 64.0, NUMBER, "shininess is 64 instead"),
        ("shininess", 33.3, FITTED, "shininess is 33.3 instead"),
        ("translucency_scale", 0.1234, FITTED, "translucency_scale is 0.1234 instead"),
    ],
)
def test_simple_numbers_and_few_digits_come_first(oracle, name, value, rank, text):
    dumped = Planted(name, vertex(name, instead(np.float32(value))), "", lacks=NUMBERS).drawn(oracle.scene)
    found = validate(oracle, dumped, explain=Scope(power=False, seconds=300)).finding.hypotheses
    assert found[0].text.startswith(text) and found[0].rank == rank


COUNT = 45
PLACES = np.linspace(0.5, 2.0, COUNT, dtype=np.float32)


class Shade(NamedTuple):
    """A number."""

    shade: float


@stage(source="a test")
def shaded(thickness: float, x: float, albedo: vec3, light_count: float, bias_abs: float) -> Shade:
    """A sum whose parts can be told apart."""
    return Shade(((thickness * x + albedo.x) + albedo.y * (thickness * thickness)) * light_count + bias_abs)


RIGHT = {"x": np.float32(1.5), "albedo": (2.0, 3.0), "light_count": np.float32(1), "bias_abs": np.float32(4)}


def sample_of(**changed):
    """The stage, where what was got was made with other numbers."""
    given = RIGHT | changed
    red, green = given["albedo"]
    got = (PLACES.astype(float) * given["x"] + red + green * PLACES.astype(float) ** 2) * given["light_count"]
    colour = vec3(np.float32(2), np.float32(3), np.float32(1))
    inputs = [PLACES, RIGHT["x"], colour, RIGHT["light_count"], RIGHT["bias_abs"]]
    at = np.zeros(COUNT, int), np.arange(COUNT)
    got, reach = (got + given["bias_abs"])[:, None], np.full((COUNT, 1), 1e-5)
    return Sample(shaded, inputs, "shade", at, got, reach, np.ones(COUNT, bool))


def told(**changed):
    """In words -> the explanation."""
    return {each.text: each for each in other_numbers(sample_of(**changed), Limit(60))}


@pytest.mark.parametrize(
    ("value", "number", "rank"),
    [
        (0.0, "0", NUMBER),
        (1.0, "1", NUMBER),
        (3.0, "3", NUMBER),
        (0.75, "0.75", NUMBER),
        (1.7, "1.7", FITTED),
        (1.73, "1.73", FITTED),
        (1.732, "1.732", FITTED),
        (1.732051, "1.73205", FITTED),
        (14.0, "14", FITTED),
    ],
)
def test_a_number_that_explains_all_is_told(value, number, rank):
    found = told(x=value)[f"x is {number} instead of 1.5"]
    assert (found.share, found.kept, found.rank, found.blames, found.names) == (1, 1, rank, INPUT, ("x",))


def test_what_a_number_cannot_mean_is_not_told():
    assert not any(text.startswith("x is") for text in told(x=-1.5))
    assert not any(text.startswith("x is") for text in told(x=-0.25))


def test_nobody_sets_the_count_of_lights():
    assert told(light_count=2.0) == {} and [*_own_numbers(sample_of())] == ["x", "albedo", "bias_abs"]


def test_a_vector_is_fitted_part_by_part():
    (found,) = (each for text, each in told(albedo=(2.5, 3.0)).items() if text.startswith("albedo is (2.5, 3, "))
    assert found.rank == FITTED and found.text.endswith(") instead of (2, 3, 1)")
    assert told(albedo=(-2.0, -3.0))["albedo is (-2, -3, -1) instead of (2, 3, 1)"].rank == FITTED


def test_what_nothing_explains_has_no_numbers():
    strange = sample_of()
    strange.got[::2] += 1
    assert not [*other_numbers(strange, Limit(60))]


@pytest.mark.parametrize(("right", "there"), [(1.0, 3.7), (-2.0, 5.25), (0.0, -0.31), (40.0, 40.0004), (1.0, 1.0)])
def test_the_number_that_misses_least_is_found(right, there):
    found = _fitted(lambda numbers: np.abs(numbers - there), np.float32(right))
    assert abs(found - there) <= 1e-7 * max(abs(right), 1.0)


@pytest.mark.parametrize(("there", "found"), [(10.9, 10.9), (12.0, 11.0), (-7.0, -7.0), (-12.0, -9.0)])
def test_no_number_farther_than_ten_times_its_size_is_tried(there, found):
    assert abs(_fitted(lambda numbers: np.abs(numbers - there), np.float32(1)) - found) < 1e-6


def test_the_smallest_step_is_a_hundred_thousandth():
    """Nearer numbers are tried between it and the right one."""
    tried = []

    def misfits(numbers):
        tried.append(np.sort(np.abs(numbers - 2.0))[:2])
        return np.abs(numbers - 2.0)

    assert _fitted(misfits, np.float32(2)) == 2 and len(tried) == 13
    assert tried[0][0] == 0 and abs(tried[0][1] - 2e-5) < 1e-9


def test_how_far_off_is_a_mean_in_reaches_and_what_is_no_number_is_far():
    sample = sample_of()
    off = _apart(sample, np.array([1.0, 3.0]), lambda many, each: many.got + each[:, None] * 1e-5)
    assert np.allclose(off, [1, 3], rtol=1e-6, atol=0)
    lost = _apart(sample, np.array([1.0]), lambda many, each: np.full(many.got.shape, np.nan))
    infinite = _apart(sample, np.array([1.0]), lambda many, each: np.full(many.got.shape, np.inf))
    assert np.allclose([lost, infinite], 1e30, rtol=1e-12, atol=0)


@pytest.mark.parametrize(("factor", "words"), [(1.25, "1.25"), (0.5, "0.5")])
def test_a_position_may_be_longer_or_shorter(factor, words):
    sample = sample_of(albedo=(2.0 * factor, 3.0 * factor))
    ((charge, fit),) = lengthened(sample, "albedo", "its_name")
    assert charge.text == f"its_name is {words} times as long" and charge.names == ("its_name",) and fit == (1, 1)


def test_no_position_is_turned_round_by_its_length():
    assert not [*lengthened(sample_of(albedo=(-2.0, -3.0)), "albedo", "its_name")]


def test_where_nothing_may_be_off_the_nearest_number_still_misses_least():
    sample = sample_of()
    exact = replace(sample, reach=np.zeros_like(sample.reach))
    near, far = _apart(exact, np.array([1.0, 3.0]), lambda many, each: many.got + each[:, None])
    assert 0 < near < far < 1e32
