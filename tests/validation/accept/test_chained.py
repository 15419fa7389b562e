"""The chained bounds hold the oracle, and what differs from it by more than rounding is outside."""

import numpy as np
import pytest

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept import chained as chaining
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.chained import chained, within_bounds
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import checks

SMALL = {f"{t}.{s}": 48 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}


def bounds_of(oracle, profile):
    return chained(Case(oracle, Drawing({}), PROFILES[profile]), oracle.buffers)


def ends(known):
    return known.low, known.high


def within(buffer, known):
    low, high = ends(known)
    return ((buffer >= low) & (buffer <= high)).reshape(*buffer.shape[:2], -1).all(axis=-1)


@pytest.mark.parametrize("name", ["figure3_with", "figure5", "figure4_wax", "figure2", "default", "lesson_halo"])
@pytest.mark.parametrize("profile", ["vulkan", "gl"])
def test_the_oracle_is_within_its_bounds(name, profile):
    oracle = render(load_scene(name, **SMALL), interpreter="arrays")
    bounds = bounds_of(oracle, profile)
    assert list(bounds) == list(oracle.buffers)
    for buffer, values in oracle.buffers.items():
        assert within(values, bounds[buffer]).all(), buffer
        assert all(end.shape == values.shape and end.dtype == values.dtype for end in ends(bounds[buffer]))


def test_bounds_of_the_image_are_narrow_enough_to_show_a_wrong_exponent():
    right = render(load_scene("figure3_with", **SMALL), interpreter="arrays")
    wrong = render(load_scene("figure3_with", **SMALL, **{"translucency.exponent": 0.61}), interpreter="arrays")
    bounds = bounds_of(right, "vulkan")
    low, high = ends(bounds["image"])
    assert np.median((high - low)[right["coverage"] != 0]) < 0.01
    for buffer in ("translucency", "lit", "image"):
        assert not within(wrong[buffer], bounds[buffer]).all()
    assert within(wrong["phong"], bounds["phong"]).all()


@pytest.fixture(scope="module")
def slopes():
    return render(load_scene("figure3_with", **SMALL), interpreter="arrays")


def counted(oracle, dumped):
    case = Case(oracle, Drawing(dumped), PROFILES["vulkan"])
    return within_bounds(case, list(checks(case)))


def test_what_has_the_bits_of_the_oracle_is_within_without_any_bounds(slopes, monkeypatch):
    with monkeypatch.context() as patched:
        patched.setattr(chaining, "_is_the_oracle", lambda case, check: False)
        computed = counted(slopes, slopes.buffers)
    monkeypatch.setattr(chaining, "in_rounds", None)  # no pass runs
    assert counted(slopes, slopes.buffers) == computed
    assert computed["depth"] is None and computed["image"] == 48 * 48


def test_only_what_others_need_is_bounded(slopes):
    moved = {**slopes.buffers, "lit": slopes["lit"] + np.float32(1e-7), "phong": slopes["phong"] + np.float32(1e-7)}
    bounds = bounds_of(slopes, "vulkan")
    case = Case(slopes, Drawing(moved), PROFILES["vulkan"])
    fewer = chained(case, ["lit"])
    assert "scattered" not in fewer and "image" not in fewer
    for name, known in fewer.items():
        assert all(np.array_equal(a, b) for a, b in zip(ends(known), ends(bounds[name]), strict=True)), name
    found = counted(slopes, moved)
    where = slopes["coverage"] != 0
    for name in ("lit", "phong"):
        assert found[name] == within(moved[name], bounds[name])[where].sum()


def test_the_bounds_of_one_output_of_a_pass_in_rounds():
    """The other output of its rounds was not asked for, and is fed back all the same."""
    oracle = render(load_scene("figure5", **SMALL), interpreter="arrays")
    bounds = chained(Case(oracle, Drawing({}), PROFILES["vulkan"]), ["irradiance_filled"])
    assert within(oracle["irradiance_filled"], bounds["irradiance_filled"]).all()
