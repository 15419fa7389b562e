"""Which stage is wrong: renderings with one thing changed stand for faulty implementations."""

from dataclasses import replace

import numpy as np
import pytest
from scenes import LIGHT, around, sphere, two_slabs, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept import case
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.stage_by_stage import validate

METHODS = ("screen_space", "texture_space")
ORACLES = {
    **{preset: {"preset": preset} for preset in ("paper", "robust", "published")},
    "two lights": {"preset": "robust", "lights": [{"position": LIGHT}, {"position": [-3.0, 0.5, 1.0]}]},
}


@pytest.fixture(scope="module")
def bodies(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bodies")
    return {
        "sphere": written(folder / "sphere.obj", *sphere(12)),
        "slabs": written(folder / "slabs.obj", *two_slabs()),
    }


def scene_of(path, method="screen_space", **overrides):
    tables = {"method": method, "preset": "robust", "irradiance_map": {"width": 64, "height": 64, "dilate": 2}}
    scene = around(path, 64, shadow_map={"width": 64, "height": 64, "test": "slope"}, **tables)
    scene["camera"]["azimuth"] = 100  # half of what it sees faces the light
    return load_scene(scene, **overrides)


def drawn(scene):
    return render(scene, interpreter="arrays")


def verdict_on(dumped, oracle):
    return validate(oracle, dumped, explain=False)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("tables", ORACLES.values(), ids=ORACLES)
def test_the_oracle_passes_registers_and_taps_too(bodies, method, tables):
    scene = load_scene(
        around(bodies["sphere"], 64, method=method, irradiance_map={"width": 64, "height": 64}, **tables)
    )
    oracle = drawn(scene)
    on_demand = [name for name in ("taps", "registers") if name in scene.method.on_demand]
    for dumped in (oracle.buffers, render(scene, "arrays", keep=["all", *on_demand]).buffers):
        found = verdict_on(dumped, oracle)
        assert found.passed and found.culprit is None and not found.missing
        assert [one.buffer for one in found.verdicts if one.equal < one.compared] == []
        assert [one.buffer for one in found.verdicts if one.chained not in (one.compared, None)] == []
        assert [one.buffer for one in found.verdicts] == list(dumped)
        assert found.summary == f"pass: {len(dumped)} buffers, every stage gives what it should"


def test_a_register_alone_is_judged(bodies):
    oracle = drawn(load_scene(around(bodies["sphere"], 64, preset="published")))
    (lit,) = render(oracle.scene, "arrays", keep="exact_lit").buffers.values()
    assert verdict_on({"exact_lit": lit}, oracle).passed
    wrong = verdict_on({"exact_lit": lit * np.float32(1.01)}, oracle)
    assert wrong.culprit.stage == "lit_add" and "lit" in wrong.missing


def test_a_wrong_tap_is_the_taps(bodies):
    oracle = drawn(scene_of(bodies["slabs"]))
    dumped = dict(render(oracle.scene, "arrays", keep=["all", "taps"]).buffers)
    dumped["tap_03"] = dumped["tap_03"] * np.float32(1.01)
    (wrong,) = (one for one in verdict_on(dumped, oracle).verdicts if not one.passed)
    assert wrong.buffer == "tap_03" and wrong.suspects == ("taps/single_tap",)


FAULTS = {  # what is changed, and where: (method, overrides, stage)
    "exponent": ("screen_space", {"translucency.exponent": 0.7501}, "translucency_ratio_throughout"),
    "base": ("screen_space", {"translucency.x": 2.001}, "translucency_ratio_throughout"),
    "scale of T": ("screen_space", {"translucency.scale": 0.05025}, "lit_transmit_wrapped"),
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
    "T on the map": ("texture_space", {"translucency.scale": 0.0525}, "irradiance_added_wrapped"),
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
    wrong = drawn(scene_of(bodies["slabs"], **{"translucency.exponent": 0.85}))
    assert not np.allclose(oracle.image, wrong.image, atol=1e-3)
    found = verdict_on(wrong.buffers, oracle).verdicts
    assert [v.stage for v in found if not v.passed] == ["translucency_ratio_throughout"]
    assert [v.buffer for v in found if v.inherits] == ["lit", "scattered", "image"]


def test_what_is_not_dumped_comes_from_the_oracle(bodies):
    oracle = drawn(scene_of(bodies["slabs"]))
    some = {name: oracle[name] for name in ("lit", "image")}
    found = verdict_on(some, oracle)
    assert found.passed and [one.buffer for one in found.verdicts] == ["lit", "image"]
    assert "thickness" in found.missing and len(found.missing) == len(oracle.buffers) - 2
    wrong = drawn(scene_of(bodies["slabs"], **{"translucency.exponent": 0.85}))
    assert (
        verdict_on({"lit": wrong["lit"]}, oracle).culprit.stage == "lit_transmit_wrapped"
    )  # the nearest that was dumped


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
    assert verdict_on({}, oracle).summary == "empty: no buffer to judge"
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


@pytest.mark.parametrize(("preset", "draws"), [("robust", 2), ("published", 3)])
def test_a_draw_that_no_dump_can_change_is_done_once(bodies, monkeypatch, preset, draws):
    """The chained bounds and the rebased checks share it; where vertices read a buffer, each has its own.

    Bounds are chained only where a bit differs, so one does.
    """
    tables = {"preset": preset, "irradiance_map": {"width": 64, "height": 64}}
    oracle = drawn(load_scene(around(bodies["sphere"], 64, **tables)))
    done, visible = [], case.visible
    monkeypatch.setattr(case, "visible", lambda *given: done.append(1) or visible(*given))
    assert verdict_on(oracle.buffers, oracle).passed
    assert len(done) == 2
    done.clear()
    verdict_on(oracle.buffers | {"phong": np.nextafter(oracle["phong"], np.float32(0))}, oracle)
    assert len(done) == draws


@pytest.mark.parametrize("form", ["D16", "D24"])
def test_a_depth_as_another_target_keeps_it(bodies, form):
    oracle, steps = drawn(scene_of(bodies["sphere"])), {"D16": 2**16 - 1, "D24": 2**24 - 1}[form]
    profile = replace(PROFILES["vulkan"], depth_format=form, reversed_depth=True)
    kept = {name: (np.rint((1 - oracle[name]) * steps) / steps).astype(np.float32) for name in ("depth", "light_depth")}
    assert validate(oracle, oracle.buffers | kept, profile=profile, explain=False).passed
    assert verdict_on(oracle.buffers | kept, oracle).culprit.stage == RASTERIZER
    assert validate(oracle, oracle.buffers, profile=profile, explain=False).culprit.stage == RASTERIZER
