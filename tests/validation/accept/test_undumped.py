"""Buffers that were not dumped: a right device passes without them, and a wrong one is seen through them."""

from dataclasses import replace

import numpy as np
import pytest
from right_devices import trial
from scenes import around, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.numerics.interval import Interval
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept import undumped
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import Known
from sss_ref.validation.stage_by_stage import validate

SMALL = {f"{t}.{s}": 32 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
COARSE = replace(PROFILES["vulkan"], subpixel_bits=4)


@pytest.fixture(scope="module", params=["sphere", "figure5"])
def pair(request):
    """A scene as the oracle has it, and as a right device with four subpixel bits draws it."""
    scene = load_scene(request.param, **SMALL)
    return render(scene, "arrays"), render(scene, "arrays", subpixel_bits=4).buffers


def without(buffers, *names):
    return {name: buffer for name, buffer in buffers.items() if name not in names}


def known(oracle, dumped, name, stored=None):
    return Case(oracle, Drawing(dumped, stored or {}), COARSE).read(name)


def test_a_right_device_passes_without_any_one_buffer(pair):
    oracle, drawn = pair
    for name in drawn:
        found = validate(oracle, without(drawn, name), profile=COARSE, explain=False)
        assert found.passed, (name, found.summary)


@pytest.mark.parametrize("name", ["light_triangle", "light_distance"])
def test_the_bounds_hold_what_was_drawn_and_say_where_it_is_in_doubt(pair, name):
    oracle, drawn = pair
    found = known(oracle, {}, name)
    assert ((found.low <= drawn[name]) & (drawn[name] <= found.high)).all()
    assert (drawn[name] != oracle[name]).any() and 0 < found.doubt.sum() < found.doubt.size / 2


def test_what_was_dumped_beside_it_settles_an_outline(pair):
    """Where a distance was written there is a triangle; elsewhere there may be one, seen edge-on."""
    oracle, drawn = pair
    written = drawn["light_triangle"] >= 0
    alone = known(oracle, {}, "light_triangle")
    beside = known(oracle, {"light_distance": drawn["light_distance"]}, "light_triangle")
    either = (alone.low < 0) & (alone.high >= 0)
    assert (either & written).any() and (either & ~written).any()
    assert (beside.low[written] >= 0).all() and (beside.low[~written] < 0).all()


def test_an_exact_device_is_judged_by_the_bits_that_it_snaps_to(pair):
    """Given all it must have the very bits of a rendering with its own snap, and not ours."""
    oracle, drawn = pair
    exact = replace(PROFILES["ieee"], subpixel_bits=4)
    found = validate(oracle, drawn, profile=exact, explain=False)
    assert found.passed and all(one.equal == one.compared for one in found.verdicts)
    assert not validate(oracle, oracle.buffers, profile=exact, explain=False).passed
    off = {**drawn, "position_world": np.nextafter(drawn["position_world"], np.float32(9))}
    assert validate(oracle, off, profile=exact, explain=False).culprit.buffer == "position_world"


def test_a_wrong_distance_is_seen_without_the_triangles(pair):
    oracle, drawn = pair
    wrong = without(drawn, "light_triangle") | {"light_distance": drawn["light_distance"] * np.float32(1.001)}
    assert validate(oracle, wrong, profile=COARSE, explain=False).culprit.buffer == "light_distance"


def test_a_texture_of_few_bits_that_was_not_dumped(pair):
    """It is said to hold halves: the bounds reach a step further, and hold them."""
    oracle, drawn = pair
    halves = drawn["light_distance"].astype(np.float16).astype(np.float32)
    exact, coarse = (known(oracle, {}, "light_distance", stored) for stored in ({}, {"light_distance": "float16"}))
    assert ((coarse.low <= halves) & (halves <= coarse.high)).all()
    assert not ((exact.low <= halves) & (halves <= exact.high)).all()


def test_a_pass_without_its_stencil_is_judged_where_it_must_have_run(pair):
    oracle, drawn = pair
    few = {name: drawn[name] for name in ("lit", "phong", "scattered") if name in drawn}
    assert validate(oracle, few, profile=COARSE, explain=False).passed
    twice = {name: buffer * np.float32(2) for name, buffer in few.items()}
    assert not validate(oracle, twice, profile=COARSE, explain=False).passed


def test_a_depth_in_few_bits_of_another_triangle_that_may_be_seen(pair):
    """Its file has taken from it what it takes from that of the oracle's triangle."""
    oracle, drawn = pair
    dumped = {"depth": drawn["depth"].astype(np.float16).astype(np.float32)}
    assert validate(oracle, dumped, {"depth": "float16"}, profile=COARSE, explain=False).passed
    assert not validate(oracle, dumped, profile=COARSE, explain=False).passed


@pytest.mark.parametrize("seed", range(8))
def test_a_device_that_is_right_by_chance_never_fails(tmp_path, seed):
    told, found = trial(tmp_path, seed)
    assert found.culprit is None, f"{told}: {found.summary}"


@pytest.mark.full
@pytest.mark.parametrize("seed", range(8, 200))
def test_two_hundred_of_them(tmp_path, seed):
    told, found = trial(tmp_path, seed)
    assert found.culprit is None, f"{told}: {found.summary}"


def cone(facets):
    """A flat cone of 64 facets towards the light, some of them twice: all meet at its tip."""
    turn = 2 * np.pi * np.arange(64) / 64
    rim = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(64)])
    triangles = [(0, 1 + k % 64, 1 + (k + 1) % 64) for k in range(facets)]
    return np.concatenate([[(0.0, 0.0, 0.25)], rim]), np.array(triangles)


@pytest.mark.parametrize(("facets", "least", "most"), [(64, 0, 63), (65, -(2**31), 2**31 - 1)])
def test_where_more_than_64_pieces_may_be_seen_anything_may(tmp_path, facets, least, most):
    """In the middle of a map of 9 x 9, at a distance of 4.75 or unknown."""
    path = written(tmp_path / "cone.obj", *cone(facets))
    oracle = render(load_scene(around(path, 9, lights=[{"position": [0.0, 0.0, 5.0]}])), "arrays")
    triangle, distance = (known(oracle, {}, name) for name in ("light_triangle", "light_distance"))
    assert (triangle.low[4, 4], triangle.high[4, 4]) == (least, most)
    assert (4.7 < distance.low[4, 4] <= distance.high[4, 4] < 4.8) == (facets == 64)
    assert np.isinf([distance.low[4, 4], distance.high[4, 4]]).all() == (facets == 65)
    assert triangle.doubt[4, 4] and np.isfinite(np.delete(distance.high, 40)).all()


def test_what_is_no_number_or_of_no_piece_may_be_anything():
    """The first is known; the others lack an end, or the piece has no area."""
    bounds = Interval(np.array([1.0, np.nan, 1.0, 1.0]), np.array([2.0, 2.0, np.nan, 2.0]))
    low, high = undumped._ends(Known(np.ones(4), bounds), np.array([False, False, False, True]))
    assert low.tolist() == [[1], [-np.inf], [-np.inf], [-np.inf]] and high.tolist() == [
        [2],
        [np.inf],
        [np.inf],
        [np.inf],
    ]
