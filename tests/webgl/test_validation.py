"""SwiftShader is another right processor: what it draws with our shaders passes, with its four subpixel bits."""

from dataclasses import replace

import pytest
from chromium import SUBPIXEL_BITS, needs_chromium

from sss_ref import webgl
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene import scene_names
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_chromium

SWIFTSHADER = replace(PROFILES["vulkan"], subpixel_bits=SUBPIXEL_BITS)
QUICK = ["figure3_with", "figure4_wax", "figure5"]
TECHNIQUES = [
    "preintegrated",
    *(pytest.param(each, marks=pytest.mark.full) for each in ("separable", "burley", "gaussian_texture")),
]
SMALL = {f"{table}.{side}": 96 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")}


@pytest.mark.parametrize(
    "name", [*QUICK, *(pytest.param(each, marks=pytest.mark.full) for each in scene_names() if each not in QUICK)]
)
def test_every_shipped_scene_passes(name):
    assert_passes(load_scene(name, **SMALL))


@pytest.mark.parametrize("method", TECHNIQUES)
def test_every_technique_passes(method):
    assert_passes(load_scene("figure3_with", **SMALL, method=method))


def assert_passes(scene):
    oracle, drawing = render(scene, interpreter="arrays"), webgl.draw(scene)
    found = validate(oracle, drawing, profile=SWIFTSHADER)
    assert found.passed, found.summary
    assert not found.missing


def test_with_other_subpixel_bits_the_rasterizer_is_named():
    scene = load_scene("figure3_with", **SMALL)
    found = validate(render(scene, interpreter="arrays"), webgl.draw(scene))
    assert found.culprit.stage == RASTERIZER
    assert "it snaps to 4 subpixel bits" in found.explanations[0]
