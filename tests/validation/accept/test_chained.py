"""The chained bounds hold the oracle, and what differs from it by more than rounding is outside."""

import numpy as np
import pytest

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.chained import chained
from sss_ref.validation.accept.dumped import Drawing

SMALL = {f"{t}.{s}": 48 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}


def bounds_of(oracle, profile):
    return chained(Case(oracle, Drawing({}), PROFILES[profile]))


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
