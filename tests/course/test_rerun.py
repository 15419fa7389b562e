"""A stage run again gives what the rendering has, until one of its inputs is changed."""

import numpy as np
import pytest

from sss_ref.course import small_scenes
from sss_ref.course.rerun import inputs_of, rerun
from sss_ref.passes import blur, phong, shadow_map, translucency
from sss_ref.rendering.fold import render

STAGES = [
    shadow_map.shadow_lookup_nearest,
    shadow_map.back_point,
    shadow_map.directly_lit_slope,
    phong.phong_shading,
    translucency.translucency_ratio,
    blur.scatter_inside,
]


@pytest.fixture(scope="module")
def result():
    return render(small_scenes.load("sphere", size=48, **small_scenes.BY_THE_TEXT), interpreter="arrays")


@pytest.mark.parametrize("stage", STAGES, ids=lambda stage: stage.name)
def test_the_same_inputs_give_the_same_bits(stage, result):
    drawn = result["coverage"] != 0
    for name, buffer in rerun(stage, result).items():
        assert np.array_equal(buffer[drawn], result[name][drawn])
        assert not buffer[~drawn].any()


def test_a_changed_uniform_changes_the_output(result):
    doubled = rerun(translucency.translucency_ratio, result, x=8.0, y=1.0)["translucency"]
    single = rerun(translucency.translucency_ratio, result, x=4.0, y=1.0)["translucency"]
    through = (result["directly_lit"] == 0) & (result["shadow_valid"] != 0)
    assert through.any() and np.array_equal(doubled[through], 2 * single[through])


def test_a_changed_buffer_changes_the_output(result):
    none = np.zeros_like(result["thickness"])
    thin = rerun(translucency.translucency_ratio, result, thickness=none)["translucency"]
    through = (result["directly_lit"] == 0) & (result["shadow_valid"] != 0)
    assert len(np.unique(thin[through])) == 1


def test_inputs_of_single_fragments(result):
    rows, columns = (index[::7] for index in np.nonzero(result["coverage"]))
    inputs = inputs_of(blur.scatter_inside, result, (rows, columns))
    assert list(inputs) == list(blur.scatter_inside.parameters)
    assert np.array_equal(inputs["pixel"].x, columns) and np.array_equal(inputs["pixel"].y, rows)
    (scattered,) = blur.scatter_inside(*inputs.values())
    assert np.array_equal(np.stack([*scattered], axis=-1), result["scattered"][rows, columns])
