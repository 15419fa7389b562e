"""Every technique on a software OpenGL: each stage passes, and a mistake in it is named."""

import pytest
from opengl import needs_mesa
from techniques import MISTAKES, SCENES, TWO_LIGHTS, of

import sss_ref
from sss_ref.gl import draw

pytestmark = needs_mesa


@pytest.mark.parametrize("lights", [{}, {"lights": TWO_LIGHTS}])
@pytest.mark.parametrize("technique", SCENES)
def test_a_drawing_passes(technique, lights):
    scene = of(technique, **lights)
    report = sss_ref.validate(scene, draw(scene), explain=False)
    assert report.passed, report.summary


@pytest.mark.parametrize("technique", SCENES)
def test_a_wrong_drawing_is_named(technique):
    keys, stage = MISTAKES[technique]
    report = sss_ref.validate(of(technique), draw(of(technique, **keys)), explain=False)
    assert report.culprit.stage == stage
