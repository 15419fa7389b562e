"""Every technique through every interpreter: one result, accepted by the bounds, told by the trace."""

import numpy as np
import pytest
from scenes import cube, written
from techniques import MISTAKES, SCENES, TWO_LIGHTS, of

from sss_ref.errors import SceneError
from sss_ref.explanation.explain import explain
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.types import components
from sss_ref.rendering.fold import render
from sss_ref.scene.catalogue import TECHNIQUES
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate


def test_each_technique_is_tried():
    assert set(SCENES) == set(MISTAKES) == set(TECHNIQUES)


@pytest.fixture(scope="module", params=TECHNIQUES)
def technique(request):
    return request.param


@pytest.fixture(scope="module")
def oracle(technique):
    return render(of(technique), "arrays")


def test_preset_robust_has_the_shadows_that_a_technique_can_draw(technique):
    hard = technique == "preintegrated"
    assert of(technique).settings.shadow_map.test == ("slope" if hard else "kernel")


ORTHOGRAPHIC = {"type": "orthographic", "eye": [1.2, 0.3, 4.0], "view_height": 2.4, "width": 48, "height": 40}


@pytest.mark.parametrize("given", [{}, {"lights": TWO_LIGHTS}, {"camera": ORTHOGRAPHIC}])
def test_both_interpreters_give_the_same_bits(technique, given):
    scene = of(technique, **given)
    assert render(scene).hashes == render(scene, "arrays").hashes


@pytest.mark.parametrize("profile", PROFILES)
def test_it_accepts_itself(oracle, profile):
    report = validate(oracle, oracle.buffers, profile=profile, explain=False)
    assert report.passed, report.summary


def test_a_mistake_is_named(oracle, technique):
    keys, stage = MISTAKES[technique]
    report = validate(oracle, render(of(technique, **keys), "arrays").buffers, explain=False)
    assert report.culprit.stage == stage


def test_the_trace_tells_what_was_rendered(oracle):
    covered = np.argwhere(oracle["coverage"] != 0)
    told = set()
    for row, column in covered[np.random.default_rng(5).integers(0, len(covered), 3)]:
        for one in explain(oracle, (int(column), int(row))).passes:
            for name, value in ((name, value) for traced in one.stages for name, value in traced.writes.items()):
                if name in oracle.buffers:
                    at = one.place.pixel[::-1]
                    assert np.array(components(value), oracle[name].dtype).tobytes() == oracle[name][at].tobytes()
                    told.add(name)
    assert {"image", "thickness"} <= told


def test_the_figures_of_the_paper_have_its_own_methods_alone(technique):
    with pytest.raises(SceneError, match=f'preset: expected "paper" or "robust" with method = "{technique}"'):
        load_scene("sphere", preset="published", method=technique)


@pytest.mark.parametrize("keys", [{}, {"translucency.combine": "transmit_wrapped", "shadow_map.test": "kernel"}])
@pytest.mark.parametrize("name", ["separable", "burley"])
def test_what_is_lit_is_what_the_papers_method_has(name, keys):
    expected, found = (
        render(of(name, method=each, preset="paper", **keys), keep="lit") for each in ("screen_space", name)
    )
    assert found.hashes == expected.hashes


@pytest.mark.parametrize(
    ("name", "keys", "message"),
    [
        (
            "preintegrated",
            {"shadow_map.test": "kernel"},
            'shadow_map.test: expected "slope" with method = "preintegrated", got "kernel"; '
            "choose it or another method",
        ),
        (
            "gaussian_texture",
            {"diffusion.profile": [[2, 1, 1, 1], [1, 1, 1, 1]]},
            'diffusion.profile: expected six rows, v rising, with method = "gaussian_texture", got v = [2.0, 1.0]; '
            "give such rows or choose another method",
        ),
    ],
)
def test_what_a_technique_cannot_do_is_told(name, keys, message):
    with pytest.raises(SceneError) as error:
        of(name, **keys)
    assert message in str(error.value)


def test_a_map_of_the_surface_needs_uvs(tmp_path):
    path = written(tmp_path / "cube.obj", *cube())
    with pytest.raises(SceneError, match=r"method: expected a mesh with UVs, got cube\.obj without"):
        of("gaussian_texture", **{"mesh.path": path})
