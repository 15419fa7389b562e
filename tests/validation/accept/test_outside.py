"""What stands where nothing is drawn is judged, and what a right device may leave there passes."""

import numpy as np
import pytest
from planted import PLANTED, oracle_of, scene_of
from scenes import around, two_slabs, written

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate


@pytest.fixture(scope="module")
def outline():
    return oracle_of(scene_of("outline", 32))


@pytest.fixture(scope="module")
def slabs(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("slabs") / "slabs.obj", *two_slabs())
    scene = around(path, 48)
    scene["camera"]["distance"] = 9.0
    return render(load_scene(scene), "arrays")


def judged(oracle, name, values, **others):
    """What is said of a dump whose background of one buffer is another one."""
    nothing = oracle["light_triangle" if name.startswith("light") else "triangle"] < 0
    got = np.where(nothing if oracle[name].ndim == 2 else nothing[..., None], np.float32(values), oracle[name])
    return validate(oracle, {**oracle.buffers, name: got.astype(oracle[name].dtype)}, explain=False, **others)


@pytest.mark.parametrize("name", ["light_distance", "position_world", "shadow_uv", "lit", "scattered", "directly_lit"])
def test_another_background_is_told(slabs, name):
    right = np.atleast_1d(slabs.scene.clear(name)).astype(slabs[name].dtype)
    found = judged(slabs, name, 7)
    assert found.culprit.buffer == name and found.culprit.failing == 0
    assert f"in {name}, where nothing is drawn {'(' if slabs[name].ndim == 3 else '7'}" in found.summary
    assert str(right[0]) in found.culprit.background.expected and found.culprit.background.uniform
    assert judged(slabs, name, right[0]).passed


def test_without_any_mask_the_reference_says_where_nothing_can_be(slabs):
    nothing = slabs["light_triangle"] < 0
    got = np.where(nothing, np.float32(0), slabs["light_distance"])
    found = validate(slabs, {"light_distance": got}, explain=False)
    assert not found.passed and 0.8 * nothing.sum() < found.culprit.background.compared < nothing.sum()
    assert validate(slabs, {"light_distance": slabs["light_distance"]}, explain=False).passed


def test_a_storage_that_has_not_the_number_is_right(slabs):
    held = slabs["light_distance"].astype(np.float16).astype(np.float32)
    bytes_ = np.rint(np.clip(slabs["light_distance"], 0, 1) * 255).astype(np.float32) / np.float32(255)
    for storage, buffer in (("float16", held), ("unorm8", bytes_)):
        assert validate(slabs, {"light_distance": buffer}, {"light_distance": storage}, explain=False).passed


def test_what_differs_at_pixels_that_may_be_covered_is_right(slabs):
    """A device that draws nothing on them, and says so, leaves the background there."""
    right = render(slabs.scene, "arrays", subpixel_bits=4)
    assert validate(slabs, right.buffers, profile=four_bits(), explain=False).passed


def four_bits():
    from dataclasses import replace

    from sss_ref.interpret.intervals.profile import PROFILES

    return replace(PROFILES["vulkan"], subpixel_bits=4)


def test_only_the_pixels_judged_count(slabs):
    only = slabs["triangle"] >= 0
    got = np.where(only[..., None], slabs["lit"], np.float32(7))
    assert validate(slabs, {"lit": got}, only=only, explain=False).passed
    assert not validate(slabs, {"lit": got}, only=~only | only, explain=False).passed


def test_registers_have_no_background(slabs):
    named = {name: each for name, each in slabs.scene.forms.items() if slabs.scene.method["camera"].is_register(name)}
    got = render(slabs.scene, "arrays", keep=["all", "registers"])
    for name in named:
        other = np.where(slabs["triangle"][..., None] < 0, 7, np.atleast_3d(got[name])).reshape(got[name].shape)
        assert validate(slabs, {name: other.astype(got[name].dtype)}, explain=False).passed


def test_a_halo_outside_the_stencil(outline):
    (halo,) = (each for each in PLANTED if each.name == "blur outside the stencil")
    for missing in ((), ("coverage", "triangle", "depth")):
        dump = {name: each for name, each in halo.drawn(outline.scene).items() if name not in missing}
        found = validate(outline, dump, explain=False)
        assert found.culprit.buffer == "scattered" and not found.culprit.background.uniform
        assert "where nothing is drawn" in found.summary and "and other values elsewhere" in found.summary
