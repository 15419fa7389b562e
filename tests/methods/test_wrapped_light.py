"""Light from behind that goes round the terminator: no line where light and shade meet, in both methods."""

import runpy
from pathlib import Path

import numpy as np
import pytest
from scenes import around, settings_with, sphere, written

from sss_ref.rendering.fold import render
from sss_ref.scene.catalogue import method_of
from sss_ref.scene.load import load_scene

WRAPPED = {"preset": "robust", "translucency.combine": "transmit_wrapped"}
PRODUCT = {"irradiance_map": {"image": "product", "mode": "lambert", "width": 64, "height": 64}}
LIGHTS = [{"position": [5.0, 1.0, -1.0]}, {"position": [-4.0, 2.0, 2.0], "color": [1.0, 0.5, 0.25]}]
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    return written(tmp_path_factory.mktemp("ball") / "ball.obj", *sphere(24))


@pytest.mark.parametrize(
    "given",
    [
        {"lights": LIGHTS},
        {"lights.0.type": "directional"},
        {"translucency.x": [2.0, 1.5, 1.0]},
        {"shadow_map.filter": "bilinear", "translucency.form": "beer"},
        {"method": "texture_space", **PRODUCT},
        {"method": "texture_space", "lights": LIGHTS, **PRODUCT},
    ],
    ids=["two lights", "parallel", "colored", "bilinear", "texture", "texture of two"],
)
def test_both_interpreters_give_the_same_bits(ball, given):
    scene = load_scene(around(ball), **WRAPPED, **given)
    compiled, expected = render(scene), render(scene, interpreter="arrays")
    assert compiled.hashes == expected.hashes
    assert any(name.startswith("inside_point") for name in compiled.buffers)


def test_the_image_of_two_cases_has_no_sum_to_add_to():
    """Texture space with image `sqrt` has one T where lit and one where not: nothing changes."""
    two_cases = {"method": "texture_space", "irradiance_map.image": "sqrt"}
    wrapped, plain = (
        method_of(settings_with({**two_cases, "translucency.combine": combine}))
        for combine in ("transmit_wrapped", "transmit")
    )
    assert wrapped == plain


def test_no_point_has_another_thickness_for_being_lit(ball):
    result = render(load_scene(around(ball), **WRAPPED))
    lit, inside = result["directly_lit"] == 1, result["inside_shadow_valid"] == 1
    assert (result["translucency"][lit & inside] > 0).all() and (lit & inside).sum() > 500
    assert (result["thickness"][lit & inside] > 0).all()  # it is that of the point below


def across_the_terminator(result):
    """Luminance along the rows from the lit to the unlit side: a run of pixels with N.L from .4 to -.4 each."""
    to_light = result.scene.lights[0].position - result["position_world"]
    cosine = (result["normal_world"] * to_light).sum(axis=-1) / np.linalg.norm(to_light, axis=-1)
    brightness, covered = result["image"] @ LUMINANCE, result["coverage"] == 1
    for row in range(len(cosine)):
        run = np.flatnonzero(covered[row] & (np.abs(cosine[row]) < 0.4))
        if len(run) >= 6 and (np.diff(run) == 1).all() and np.ptp(cosine[row, run]) > 0.75:
            yield brightness[row, run]


def dip(values):
    """How far the deepest valley lies below the lower of the two heights on its sides, as a share of that."""
    sides = np.minimum(np.maximum.accumulate(values), np.maximum.accumulate(values[::-1])[::-1])
    return float(((sides - values) / sides).max())


def dips(light, **given):
    view = {"type": "orbit", "distance": 4.2, "azimuth": 10, "fov_y": 31, "width": 128, "height": 128}
    scene = {"mesh": {"path": "sphere"}, "camera": view, "lights": [{"position": light}], "phong": {"specular": 0.0}}
    rows = list(across_the_terminator(render(load_scene(scene, **given))))
    assert len(rows) > 60
    return [dip(row) for row in rows]


@pytest.mark.parametrize("light", [[4.0, 0.5, 1.0], [3.0, 1.0, -1.0]])
def test_light_and_shade_meet_without_a_dark_line(light):
    """With every light a line is darker than both its sides by 2 %; without the wrap by more than 10 %."""
    assert max(dips(light, **WRAPPED)) <= 0.02
    assert np.median(dips(light, **{**WRAPPED, "translucency.combine": "transmit"})) > 0.1


@pytest.mark.parametrize(("scene", "light"), [("figure3_with", 0), ("default", 0), ("default", 1)])
def test_on_the_bust_nothing_but_its_own_shape_darkens_the_terminator(scene, light):
    """As benchmarks/terminator.py has it, smaller; with the d_min, wrap and scale of before most rows are darker."""
    given = {"camera.width": 192, "camera.height": 192, "phong.specular": 0.0}
    before = {"translucency.d_min": 0.1, "translucency.wrap": 0.3, "translucency.scale": 0.1}
    terminator = runpy.run_path(str(Path(__file__).parents[2] / "benchmarks" / "terminator.py"))
    now, then = (terminator["classified"](scene, light, given | changed)["open"] for changed in ({}, before))
    assert len(now) >= 20 and max(now) <= 0.02
    assert np.mean(np.array(then) > 0.02) > 0.4
