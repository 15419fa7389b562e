"""Which stage is wrong: renderings with one thing changed stand for faulty implementations."""

import numpy as np
import pytest
from scenes import around, sphere, two_slabs, written

from sss_ref.raster.primitives import assemble
from sss_ref.rendering import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.rebased import RASTERIZER, half_subpixel
from sss_ref.validation.stage_by_stage import validate

METHODS = ("screen_space", "texture_space")


@pytest.fixture(scope="module")
def bodies(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bodies")
    return {
        "sphere": written(folder / "sphere.obj", *sphere(12)),
        "slabs": written(folder / "slabs.obj", *two_slabs()),
    }


def scene_of(path, method="screen_space", **overrides):
    tables = {"method": method, "preset": "robust", "irradiance_map": {"width": 64, "height": 64, "dilate": 2}}
    scene = around(path, 64, **tables)
    scene["camera"]["azimuth"] = 100  # half of what it sees faces the light
    return load_scene(scene, **overrides)


def drawn(scene):
    return render(scene, interpreter="arrays")


def verdict_on(dumped, oracle):
    return validate(oracle, dumped)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("preset", ["paper", "robust", "published"])
def test_the_oracle_passes(bodies, method, preset):
    tables = {"method": method, "preset": preset, "irradiance_map": {"width": 64, "height": 64}}
    oracle = drawn(load_scene(around(bodies["sphere"], 64, **tables)))
    found = verdict_on(oracle.buffers, oracle)
    assert found.passed and found.culprit is None and not found.missing
    assert [one.buffer for one in found.verdicts if one.equal < one.compared] == []
    assert {one.buffer for one in found.verdicts} == set(oracle.buffers)
    assert found.summary == f"pass: {len(oracle.buffers)} buffers, every stage gives what it should"


FAULTS = {  # what is changed, and where: (method, overrides, stage)
    "exponent": ("screen_space", {"translucency.exponent": 0.6001}, "translucency_ratio"),
    "base": ("screen_space", {"translucency.x": 2.001}, "translucency_ratio"),
    "scale of T": ("screen_space", {"translucency.scale": 0.201}, "lit_transmit"),
    "shininess": ("screen_space", {"phong.shininess": 33.0}, "phong_shading"),
    "ambient": ("screen_space", {"phong.ambient": 0.101}, "phong_shading"),
    "bias": ("screen_space", {"shadow_map.bias_slope": 0.0}, "directly_lit_slope"),
    "lookup inset": ("screen_space", {"shadow_map.lookup_inset": 0.99}, "shadow_lookup_nearest"),
    "filter": ("screen_space", {"shadow_map.filter": "bilinear"}, "shadow_lookup_nearest"),
    "intensity": ("screen_space", {"lights.0.intensity": 1.001}, "light_constant"),
    "albedo": ("screen_space", {"mesh.color": [0.7, 0.4, 0.401]}, "albedo_constant"),
    "kernel": ("screen_space", {"blur.kernel": "table1"}, "scatter_inside"),
    "scale of the taps": ("screen_space", {"blur.pixel_scale": 2.01}, "scatter_inside"),
    "background": ("screen_space", {"output.background": [0.0, 0.0, 0.5]}, "over_background"),
    "camera": ("screen_space", {"camera.azimuth": 161}, RASTERIZER),
    "view of the light": ("screen_space", {"lights.0.fov_y": 50.0}, RASTERIZER),
    "mode": ("texture_space", {"irradiance_map.mode": "paper"}, "irradiance_lambert"),
    "dilation": ("texture_space", {"irradiance_map.dilate": 1}, "dilate"),
    "kernel on the map": ("texture_space", {"blur.kernel": "schoenberger"}, "scatter_inside"),
    "T on the map": ("texture_space", {"translucency.scale": 0.21}, "irradiance_added"),
    "highlight": ("texture_space", {"phong.specular": 0.6}, "phong_shading"),
    "sum": ("texture_space", {"phong.ambient": 0.12}, "phong_shading"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_the_stage_that_is_wrong_is_named(bodies, fault):
    method, overrides, stage = FAULTS[fault]
    oracle = drawn(scene_of(bodies["slabs" if method == "screen_space" else "sphere"], method))
    wrong = drawn(scene_of(bodies["slabs" if method == "screen_space" else "sphere"], method, **overrides))
    found = verdict_on({name: wrong[name] for name in oracle.buffers if name in wrong.buffers}, oracle)
    assert not found.passed and found.culprit.stage == stage
    assert found.summary.startswith(f"fail: stage {stage} of pass ")


def test_what_follows_from_an_error_is_not_blamed(bodies):
    """A wrong exponent changes the image as well, but the stages after it did their work."""
    oracle = drawn(scene_of(bodies["slabs"]))
    wrong = drawn(scene_of(bodies["slabs"], **{"translucency.exponent": 0.7}))
    assert not np.allclose(oracle.image, wrong.image, atol=1e-3)
    found = verdict_on(wrong.buffers, oracle).verdicts
    assert [v.stage for v in found if not v.passed] == ["translucency_ratio"]
    assert [v.buffer for v in found if v.inherits] == ["lit", "scattered", "image"]


def test_what_is_not_dumped_comes_from_the_oracle(bodies):
    oracle = drawn(scene_of(bodies["slabs"]))
    some = {name: oracle[name] for name in ("lit", "image")}
    found = verdict_on(some, oracle)
    assert found.passed and [one.buffer for one in found.verdicts] == ["lit", "image"]
    assert "thickness" in found.missing and len(found.missing) == len(oracle.buffers) - 2
    wrong = drawn(scene_of(bodies["slabs"], **{"translucency.exponent": 0.7}))
    assert verdict_on({"lit": wrong["lit"]}, oracle).culprit.stage == "lit_transmit"  # the nearest that was dumped


def test_nan_blank_and_nothing_never_pass(bodies):
    oracle = drawn(scene_of(bodies["slabs"]))
    for value in (np.nan, 0.0):
        blank = {name: np.full_like(b, value) if b.dtype == np.float32 else b for name, b in oracle.buffers.items()}
        assert verdict_on(blank, oracle).culprit.buffer == "light_depth"
    maps = drawn(scene_of(bodies["sphere"], "texture_space"))
    broken = dict(maps.buffers, irradiance=np.full_like(maps["irradiance"], np.nan))
    assert verdict_on(broken, maps).culprit.buffer == "irradiance"
    nothing_drawn = dict(oracle.buffers, triangle=np.full_like(oracle["triangle"], -1))
    assert verdict_on(nothing_drawn, oracle).culprit.buffer == "triangle"
    assert verdict_on({}, oracle).summary == "fail: there is no buffer to judge"
    assert not verdict_on({}, oracle).passed


def test_pixels_with_another_triangle_are_the_rasterizers(bodies):
    """Beside one wrong triangle id, no later stage is blamed for what stands at that pixel."""
    oracle = drawn(scene_of(bodies["slabs"]))
    row, column = np.argwhere(oracle["coverage"] != 0)[0]
    other = {name: buffer.copy() for name, buffer in oracle.buffers.items()}
    other["triangle"][row, column] += 1
    other["position_world"][row, column] = 99
    found = {one.buffer: one for one in verdict_on(other, oracle).verdicts}
    assert found["triangle"].equal == found["triangle"].compared - 1
    assert found["position_world"].equal == found["position_world"].compared == int((oracle["coverage"] != 0).sum()) - 1


def test_half_a_subpixel_by_hand():
    """Corners at pixels (0, 0), (8, 0) and (0, 4): an attribute that is x there grows by 1/512 over half a subpixel."""
    from sss_ref.raster.viewport import Viewport

    viewport = Viewport(8, 8)
    window = np.array([(0, 0), (8, 0), (0, 4)], np.float32)
    clip = np.column_stack([window / 4 - 1, np.zeros(3), np.ones(3)]).astype(np.float32)
    attributes = np.column_stack([window, window.sum(axis=1)]).astype(np.float32)
    primitives = assemble(clip, attributes, np.array([(0, 1, 2)], np.int32), viewport)
    slack = half_subpixel(primitives, primitives.attributes, np.array([0]), viewport.step)[0] * 512
    assert slack[0] >= 1 and slack[1] >= 1 and slack[2] >= 2  # at least the gradient along both axes
    assert slack.max() <= 4
