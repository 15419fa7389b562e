from itertools import chain
from typing import get_args

import numpy as np
import pytest
from scenes import around, cube, settings_with, sphere, two_slabs, written

from sss_ref.errors import RenderError
from sss_ref.rendering.fold import render
from sss_ref.scene.catalogue import method_of
from sss_ref.scene.load import load_scene
from sss_ref.scene_file import scattering, settings, viewpoints

USER_KERNEL = [[0.0, 0.0, 0.5, 0.25, 0.125], [2.5, -1.25, 0.5, 0.75, 0.875], [-200.0, 3.0, 0.25, 0.0, 0.5]]

# Each alternative of the scene file occurs at least once; few scenes, since each is compiled by itself.
CASES = {
    "paper": {"preset": "paper"},
    "robust": {"preset": "robust"},
    "beer": {
        "preset": "paper",
        "shadow_map.filter": "bilinear",
        "shadow_map.test": "literal",
        "translucency.form": "beer",
        "translucency.combine": "add",
        "lights.0.falloff": "inverse_square",
        "blur.mask": "none",
        "blur.kernel": "schoenberger",
        "blur.normalize": True,
    },
    "exponent": {
        "preset": "robust",
        "shadow_map.test": "slope",
        "shadow_map.filter": "bilinear",
        "shadow_map.lookup_inset": 0.9,
        "translucency.form": "exponent",
        "translucency.combine": "multiply",
        "lights.0.falloff": "inverse_square",
        "blur.kernel": USER_KERNEL,
    },
    "literal": {
        "preset": "paper",
        "shadow_map.test": "literal",
        "shadow_map.bias_abs": 0.03,
        "translucency.form": "gaussians",
        "translucency.combine": "transmit",
        "blur.mask": "taps",
        "blur.pixel_scale": 1.5,
    },
    "wrapped": {"preset": "robust", "shadow_map.test": "slope"},
}

BODIES = {"cube": cube, "two slabs": two_slabs, "sphere": lambda: sphere(24)}

CHOICES = {
    "shadow_map.filter": {"nearest": "shadow_lookup_nearest", "bilinear": "shadow_lookup_bilinear"},
    "shadow_map.test": {"slope": "directly_lit_slope", "literal": "directly_lit_literal"},
    "translucency.form": {
        "ratio": "translucency_ratio",
        "exponent": "translucency_exponent",
        "beer": "translucency_beer",
        "gaussians": "translucency_gaussians",
    },
    "translucency.combine": {"multiply": "lit_multiply", "add": "lit_add", "transmit": "lit_transmit"}
    | {"transmit_wrapped": "lit_transmit_wrapped"},
    "blur.mask": {"none": "scatter", "output": "scatter", "taps": "scatter_inside"},
    "lights.0.falloff": {"none": "light_constant", "inverse_square": "light_inverse_square"},
}

# Name -> channels, type, background; an independent copy of the table of buffers.
LIGHT_CLEAR = "twice the light's far plane"
BUFFERS = {
    "light_triangle": (1, "<i4", -1),
    "light_depth": (1, "<f4", 1),
    "light_distance": (1, "<f4", LIGHT_CLEAR),
    "triangle": (1, "<i4", -1),
    "depth": (1, "<f4", 1),
    "coverage": (1, "|u1", 0),
    "position_world": (3, "<f4", 0),
    "normal_world": (3, "<f4", 0),
    "uv": (2, "<f4", 0),
    "albedo": (3, "<f4", 0),
    "shadow_uv": (2, "<f4", -1),
    "shadow_valid": (1, "|u1", 0),
    "stored_distance": (1, "<f4", 0),
    "entry_point": (3, "<f4", 0),
    "thickness": (1, "<f4", 0),
    "directly_lit": (1, "|u1", 0),
    "incident_light": (3, "<f4", 0),
    "phong": (3, "<f4", 0),
    "translucency": (1, "<f4", 0),
    "lit": (3, "<f4", 0),
    "scattered": (3, "<f4", 0),
    "image": (3, "<f4", (0.25, 0.5, 2.0)),
}


@pytest.fixture(scope="module")
def bodies(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bodies")
    return {name: written(folder / f"{name}.obj", *body()) for name, body in BODIES.items()}


def assert_same_in_both_interpreters(scene):
    kernel, arrays = render(scene), render(scene, interpreter="arrays")
    assert list(kernel.buffers) == list(arrays.buffers)
    of_robust = ("inside_", "light_visible")
    assert [name for name in kernel.buffers if not name.startswith(of_robust)] == list(BUFFERS)
    different = [name for name in kernel.buffers if kernel[name].tobytes() != arrays[name].tobytes()]
    assert not different
    return kernel


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("case", CASES)
def test_both_interpreters_give_the_same_bits(bodies, body, case):
    result = assert_same_in_both_interpreters(load_scene(around(bodies[body]), **CASES[case]))
    assert all(np.isfinite(buffer).all() for buffer in result.buffers.values())
    lit, valid, covered = (result[name] != 0 for name in ("directly_lit", "shadow_valid", "coverage"))
    assert (lit & covered).any() and (~lit & valid & covered).any() and not covered.all()


@pytest.mark.parametrize("preset", ["paper", "robust"])
@pytest.mark.parametrize(
    ("path", "distance"),
    [("head_lps/leeperrysmith.obj", 15.0), ("spot/spot_triangulated.obj", 3.4), ("bunny/bunny_hr.obj", 3.4)],
)
def test_both_interpreters_give_the_same_bits_on_scanned_meshes(asset, path, distance, preset):
    scene = around(str(asset(path)), lights=[{"position": [3 * distance, distance, 0.0]}])
    scene["camera"]["distance"] = distance
    result = assert_same_in_both_interpreters(load_scene(scene, preset=preset))
    assert np.unique(result["triangle"]).size > 500


def test_a_light_whose_map_misses_part_of_the_body(bodies):
    scene = around(bodies["sphere"], lights=[{"position": [0.0, 0.0, 2.0], "fov_y": 40, "near": 0.5, "far": 4}])
    result = assert_same_in_both_interpreters(load_scene(scene, **{"camera.azimuth": 90}))
    outside = (result["coverage"] == 1) & (result["shadow_valid"] == 0)
    assert outside.sum() > 100 and (result["shadow_valid"] == 1).sum() > 100
    assert not result["thickness"][outside].any()
    assert (result["entry_point"] == result["position_world"])[outside].all()
    assert (result["translucency"][outside] == 1).all()


@pytest.mark.parametrize(("preset", "combine"), [("paper", "multiply"), ("robust", "transmit")])
def test_on_the_background_of_the_map_translucency_is_that_of_no_thickness(bodies, preset, combine):
    """Fragments just behind the terminator, whose nearest texel shows no body: x^y / d_min^.6, and no dark seam."""
    hard = {"translucency.combine": combine, "translucency.d_min": 0.1, "shadow_map.test": "slope"}
    result = render(load_scene(around(bodies["sphere"]), preset=preset, **hard))
    on_map = (result["coverage"] == 1) & (result["shadow_uv"][..., 0] >= 0)
    seam = on_map & (result["shadow_valid"] == 0) & (result["directly_lit"] == 0)
    thinnest = on_map & (result["directly_lit"] == 0) & (result["thickness"] <= 0.1)
    assert seam.sum() > 5 and np.unique(result["translucency"][thinnest]).size == 1
    assert (seam <= thinnest).all() and result["translucency"][seam].min() > 1


def test_the_cases_hold_every_alternative_of_the_scene_file():
    alternatives = {
        "shadow_map.filter": settings.ShadowMap.model_fields["filter"],
        "shadow_map.test": settings.ShadowMap.model_fields["test"],
        "translucency.form": scattering.TranslucencySettings.model_fields["form"],
        "translucency.combine": scattering.TranslucencySettings.model_fields["combine"],
        "blur.mask": scattering.Blur.model_fields["mask"],
        "lights.0.falloff": viewpoints.PointLight.model_fields["falloff"],
    }
    assert {key: set(get_args(field.annotation)) for key, field in alternatives.items()} == {
        key: set(stages) | ({"exact", "kernel"} if key == "shadow_map.test" else set())  # see test_soft_edges.py
        for key, stages in CHOICES.items()
    }
    stages = set(chain.from_iterable(CHOICES[key].values() for key in CHOICES))
    used = {
        stage.name for case in CASES.values() for one in method_of(settings_with(case)).passes for stage in one.stages
    }
    assert stages <= used


@pytest.mark.parametrize(
    ("key", "value", "stage"), [(key, value, stage) for key in CHOICES for value, stage in CHOICES[key].items()]
)
def test_a_choice_selects_its_stage_and_no_other(key, value, stage):
    used = {stage.name for one in method_of(settings_with({key: value})).passes for stage in one.stages}
    assert used & set(CHOICES[key].values()) == {stage}


@pytest.mark.parametrize(
    ("mask", "composite", "stencil"),
    [("none", "glow", ""), ("output", "over_background", "coverage"), ("taps", "over_background", "coverage")],
)
def test_the_mask_decides_the_stencil_and_the_background(mask, composite, stencil):
    *_, blur, last = method_of(settings_with({"blur.mask": mask})).passes
    assert (blur.draw.stencil, last.stages[0].name) == (stencil, composite)


def test_every_buffer_has_its_shape_type_and_background(bodies):
    scene = load_scene(around(bodies["cube"]), **{"shadow_map.width": 96, "output.background": [0.25, 0.5, 2.0]})
    result = render(scene)
    assert list(result.buffers) == list(BUFFERS)
    outside = {True: result["light_triangle"] == -1, False: result["coverage"] == 0}
    for name, (channels, dtype, background) in BUFFERS.items():
        buffer, is_light = result[name], name.startswith("light_")
        size = (128, 96) if is_light else (128, 128)
        assert buffer.shape == (size if channels == 1 else (*size, channels)), name
        assert buffer.dtype.str == dtype, name
        expected = np.float32(2 * scene.lights[0].view.far) if background == LIGHT_CLEAR else background
        assert 0 < outside[is_light].sum() < buffer[..., 0].size if channels > 1 else buffer.size
        assert (buffer[outside[is_light]] == np.array(expected, dtype)).all(), name


@pytest.mark.parametrize("case", ["paper", "beer", "exponent"])
def test_the_single_taps_of_the_blur_are_there_on_demand(bodies, case):
    scene = load_scene(around(bodies["cube"]), **CASES[case])
    kernel, arrays = (render(scene, i, keep=["taps", "scattered", "coverage"]) for i in ("kernel", "arrays"))
    assert kernel.hashes == arrays.hashes
    names = [f"tap_{number:02}" for number in range(len(scene.settings.blur.taps))]
    assert list(kernel.buffers) == ["coverage", "scattered", *names]
    if scene.settings.blur.mask != "taps":
        total = kernel["tap_00"]
        for name in names[1:]:
            total = total + kernel[name]
        assert total.tobytes() == kernel["scattered"].tobytes()


def test_without_a_mask_the_light_spills_over_the_outline(bodies):
    spilled = render(load_scene(around(bodies["cube"]), **CASES["beer"], **{"output.background": [9.0, 9.0, 9.0]}))
    assert (spilled.image == spilled["scattered"]).all()
    assert spilled.image[spilled["coverage"] == 0].max() > 0


@pytest.mark.parametrize("interpreter", ["kernel", "arrays"])
def test_a_value_that_is_not_finite_names_stage_pixel_and_inputs(bodies, interpreter):
    scene = load_scene(around(bodies["cube"]), preset="paper")
    row, column = np.argwhere(render(scene)["coverage"])[0]
    glaring = load_scene(
        around(bodies["cube"]), preset="paper", **{"lights.0.intensity": 3e38, "lights.0.color": [1, 9, 1]}
    )
    with pytest.raises(RenderError) as caught:
        render(glaring, interpreter=interpreter)
    assert str(caught.value) == (
        f"stage light_constant, pixel {column},{row}: result is not finite; "
        "inputs: light_color = 1.0 9.0 1.0, light_intensity = 3e+38"
    )
