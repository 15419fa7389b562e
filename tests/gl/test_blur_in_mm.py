"""A kernel in mm on a software OpenGL: every stage passes, and a wrong length is found where it is made."""

import numpy as np
import pytest
from opengl import needs_mesa

import sss_ref
from sss_ref.gl import draw

pytestmark = needs_mesa

SMALL = {f"{table}.{side}": 64 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")}
IN_MM = {"blur.unit": "mm", "blur.follow_surface": True}
SCALES = {"screen_space": "pixels_per_offset", "texture_space": "texels_per_offset"}


@pytest.mark.parametrize("mask", ["taps", "output"])
@pytest.mark.parametrize("method", SCALES)
def test_a_drawing_passes(method, mask):
    scene = sss_ref.load_scene("default", preset="robust", method=method, **SMALL, **IN_MM, **{"blur.mask": mask})
    report = sss_ref.validate(scene, draw(scene), explain=False)
    assert report.passed, report.summary


@pytest.mark.parametrize(("method", "scale"), SCALES.items())
def test_another_length_is_named(method, scale):
    scene = sss_ref.load_scene("default", preset="robust", method=method, **SMALL, **IN_MM)
    drawn = draw(scene)
    report = sss_ref.validate(scene, {**drawn, scale: drawn[scale] * np.float32(1.5)})
    assert "stage offset_length" in report.summary
    assert "mm_per_offset is 1.8 instead of 1.2" in report.explanations[0]
