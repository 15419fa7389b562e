"""Right rasterizers of another make pass, and wrong ones are found, although each of their stages fits the others."""

from dataclasses import replace

import numpy as np
import pytest
from devices import (
    Device,
    ExactVertices,
    as_it_is,
    cut_off,
    farthest,
    only,
    other_first_vertex,
    shifted,
    to_any_side,
    uncut,
    upside_down,
    without,
)
from scenes import around, sphere, two_slabs, wall, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.stage_by_stage import validate

VULKAN = PROFILES["vulkan"]
COARSE, CUT_OFF = replace(VULKAN, subpixel_bits=4), replace(VULKAN, snap="any")


@pytest.fixture(scope="module")
def bodies(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bodies")
    tables = {"preset": "robust", "irradiance_map": {"width": 64, "height": 64, "dilate": 2}}
    ball, slabs = written(folder / "sphere.obj", *sphere(12)), written(folder / "slabs.obj", *two_slabs(), flat=True)
    scenes = {
        "sphere": around(ball, 64, **tables),
        "slabs": around(slabs, 64, **tables),
        "texture space": around(ball, 64, method="texture_space", **tables),
    }
    scenes["from inside"] = scenes["sphere"] | {"camera": scenes["sphere"]["camera"] | {"distance": 0.5, "near": 0.01}}
    scenes["cut open"] = scenes["sphere"] | {"camera": scenes["sphere"]["camera"] | {"near": 4.0}}
    scenes["beyond the frame"] = scenes["sphere"] | {"camera": scenes["sphere"]["camera"] | {"fov_y": 10}}
    return {name: render(load_scene(scene), interpreter="arrays") for name, scene in scenes.items()}


RIGHT = {
    "ours": (as_it_is, 8, VULKAN),
    "another first vertex": (other_first_vertex, 8, VULKAN),
    "cutting off": (cut_off, 8, CUT_OFF),
    "4 subpixel bits": (as_it_is, 4, COARSE),
    "4 subpixel bits, cut off": (cut_off, 4, replace(CUT_OFF, subpixel_bits=4)),
    "4 subpixel bits, another first vertex": (other_first_vertex, 4, COARSE),
    "to any side": (to_any_side(1), 8, CUT_OFF),
}


@pytest.mark.parametrize("body", ["sphere", "slabs", "texture space", "from inside", "cut open", "beyond the frame"])
@pytest.mark.parametrize("device", RIGHT)
def test_a_right_rasterizer_passes(bodies, body, device):
    changed, bits, profile = RIGHT[device]
    oracle = bodies[body]
    drawn = Device(oracle.scene, changed, bits).buffers_of_all()
    found = validate(oracle, drawn, profile=profile, explain=False)
    assert found.passed, found.summary
    assert {one.buffer: one.compared - one.within for one in found.verdicts if one.compared != one.within} == {}


@pytest.mark.parametrize("bits, profile", [(4, COARSE), (8, VULKAN)])
def test_triangles_need_not_be_cut_at_the_sides(bodies, bits, profile):
    oracle = bodies["beyond the frame"]
    drawn = Device(oracle.scene, uncut(oracle.scene.mesh.triangles), bits).buffers_of_all()
    found = validate(oracle, drawn, profile=profile, explain=False)
    assert found.passed, found.summary


def test_where_a_distant_body_is_cut_depends_on_the_vertex_stage(tmp_path):
    """A wall that is nearly parallel to the near plane, 1000 units from the mesh's origin."""
    positions, triangles = wall()
    path = written(tmp_path / "wall.obj", positions + np.array([1000.0, 0.0, 0.0]), triangles)
    scene = around(path, 257)
    scene["camera"] |= {"target": [1000.0, 0.0, 0.0], "distance": 2.0, "azimuth": 0.5, "elevation": 0.05}
    scene["camera"] |= {"fov_y": 60, "near": 2.0, "far": 20.0}
    scene["lights"] = [{"position": [1006.0, 3.0, 20.0]}]
    oracle = render(load_scene(scene), interpreter="arrays")
    drawn = ExactVertices(oracle.scene, as_it_is).buffers_of_all()
    assert (drawn["triangle"] != oracle["triangle"]).any()
    found = validate(oracle, drawn, explain=False)
    assert found.passed, found.summary
    (seen,) = (one for one in found.verdicts if one.buffer == "triangle")
    assert seen.ambiguous < 0.01 * seen.compared


WRONG = {
    "front faces culled": (only(lambda turn: turn < 0), "counter-clockwise in the window are culled"),
    "the farthest": (farthest, "the depth test keeps the farthest"),
    "half a pixel to the right": (shifted(0.5, 0), "0.5 pixels too far right"),
    "half a pixel down": (shifted(0, -0.5), "0.5 pixels too far down"),
    "upside down": (upside_down, "upside down"),
}


@pytest.mark.parametrize("fault", WRONG)
def test_a_wrong_rasterizer_is_found_and_explained(bodies, fault):
    changed, text = WRONG[fault]
    oracle = bodies["slabs"]
    found = validate(oracle, Device(oracle.scene, changed).buffers_of_all())
    assert found.culprit.stage == RASTERIZER
    assert any(text in line for line in found.explanations), found.explanations


def test_back_faces_are_missed_where_they_are_seen(bodies):
    oracle = bodies["cut open"]
    found = validate(oracle, Device(oracle.scene, only(lambda turn: turn > 0)).buffers_of_all())
    assert found.culprit.stage == RASTERIZER
    assert any("clockwise in the window are culled" in line for line in found.explanations), found.explanations


def test_a_flipped_layout_is_found(bodies):
    oracle = bodies["texture space"]
    flipped = Device(oracle.scene, upside_down).buffers_of_all()
    only_the_map = {name: flipped[name] for name in flipped if name.startswith("irradiance")}
    found = validate(oracle, {**oracle.buffers, **only_the_map}, explain=False)
    assert not found.passed and found.culprit.pass_name == "irradiance_map"


def test_one_missing_triangle_is_found(bodies):
    oracle = bodies["sphere"]
    shown, count = np.unique(oracle["triangle"], return_counts=True)
    most = shown[1:][np.argmax(count[1:])]
    found = validate(oracle, Device(oracle.scene, without(most)).buffers_of_all(), explain=False)
    assert found.culprit.stage == RASTERIZER


@pytest.mark.parametrize("names", [["coverage"], ["depth"], ["triangle"]])
def test_any_one_of_its_buffers_shows_it(bodies, names):
    oracle = bodies["slabs"]
    wrong = Device(oracle.scene, shifted(0.5, 0.5)).buffers_of_all()
    assert not validate(oracle, {name: wrong[name] for name in names}, explain=False).passed
    assert validate(oracle, {name: oracle[name] for name in names}, explain=False).passed


@pytest.mark.parametrize("bits, profile", [(4, VULKAN), (8, COARSE)])
def test_the_subpixel_bits_must_be_those_of_the_profile(bodies, bits, profile):
    oracle = bodies["sphere"]
    found = validate(oracle, Device(oracle.scene, as_it_is, bits).buffers_of_all(), profile=profile, explain=False)
    assert not found.passed


def test_a_bit_exact_port_must_show_the_same_triangles(bodies):
    oracle = bodies["slabs"]
    assert validate(oracle, oracle.buffers, profile="ieee", explain=False).passed
    found = validate(oracle, Device(oracle.scene, cut_off).buffers_of_all(), profile="ieee", explain=False)
    assert found.culprit.stage == RASTERIZER
