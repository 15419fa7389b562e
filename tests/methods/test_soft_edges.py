"""Shadows with soft edges: the kernel's taps on the shadow map, in both methods."""

import numpy as np
import pytest
from scenes import settings_with

from sss_ref.rendering.fold import render
from sss_ref.scene.catalogue import method_of
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

SOFT = {"preset": "robust", "shadow_map.test": "kernel"}
PRODUCT = {"method": "texture_space", "irradiance_map": {"image": "product", "mode": "lambert", "dilate": 2}}
LIGHTS = [{"position": [1.0, 5.0, 3.0]}, {"type": "directional", "position": [-4.0, 3.0, 2.0]}]


def of(**given):
    """The bust, whose nose and chin throw shadows."""
    sizes = {f"{table}.{side}": 96 for table in ("camera", "shadow_map") for side in ("width", "height")}
    return load_scene("figure3_with", **sizes, **{**SOFT, "shadow_map.kernel_scale": 1.0, **given})


@pytest.mark.parametrize("combine", ["multiply", "add", "transmit", "transmit_wrapped"])
def test_both_interpreters_give_the_same_bits(combine):
    scene = of(**{"translucency.combine": combine, "lights": LIGHTS})
    compiled = render(scene)
    assert compiled.hashes == render(scene, interpreter="arrays").hashes
    assert "light_visible_2" in compiled.buffers


def test_both_interpreters_give_the_same_bits_in_texture_space():
    small = {"camera.width": 64, "camera.height": 64, "irradiance_map.width": 64, "irradiance_map.height": 64}
    scene = load_scene("sphere", **{**SOFT, **small, "shadow_map.width": 64, "shadow_map.height": 64}, **PRODUCT)
    compiled = render(scene)
    assert compiled.hashes == render(scene, interpreter="arrays").hashes


def test_an_edge_is_soft_and_red_goes_farther_than_blue():
    result = render(of(**{"translucency.combine": "transmit"}))
    visible = result["light_visible"][result["coverage"] == 1]
    between = (visible > 0) & (visible < 1)
    assert between[:, 0].sum() > 100
    red, _, blue = (np.abs(visible - 0.5) * between).T
    assert red[between.any(axis=1)].mean() < blue[between.any(axis=1)].mean()  # red is nearer to half
    lit = result["directly_lit"][result["coverage"] == 1] == 1
    assert visible[lit & ~between.any(axis=1)].mean() > 0.95


def test_at_no_width_it_is_yes_or_no():
    """All taps lie on the point then: what is seen is what `slope` finds, but for the map's background."""
    result = render(of(**{"shadow_map.kernel_scale": 0.0}))
    known = (result["coverage"] == 1) & (result["shadow_valid"] == 1)
    assert (result["light_visible"][known] == (result["directly_lit"][known] == 1)[:, None]).all()


@pytest.mark.parametrize("combine", ["multiply", "transmit_wrapped"])
def test_it_accepts_itself_and_names_a_wrong_width(combine):
    oracle = render(of(**{"translucency.combine": combine}), "arrays")
    assert validate(oracle, oracle.buffers, explain=False).passed
    wrong = render(of(**{"translucency.combine": combine, "shadow_map.kernel_scale": 0.9}), "arrays")
    assert validate(oracle, wrong.buffers, explain=False).culprit.stage == "light_visible_kernel"


def test_add_asks_nothing_that_an_edge_could_soften():
    stages = {
        stage.name
        for each in method_of(settings_with({"shadow_map.test": "kernel", "translucency.combine": "add"})).passes
        for stage in each.stages
    }
    assert {"lit_add", "translucency_ratio"} <= stages
