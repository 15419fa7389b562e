"""A draw of the mesh with something changed."""

import numpy as np
import pytest
from planted import LIGHT, NUMBERS, Planted, moved_in_clip_space, oracle_of, scene_of, vertex

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.redrawn import Redrawing, fitted_shift

SIDE = 48
STEP = 2.0**-8  # of the positions in pixels


@pytest.fixture(scope="module")
def oracle():
    return oracle_of(scene_of("bust", SIDE))


def shift_of(oracle, buffer, buffers):
    (this_pass,) = (each for each in oracle.scene.method.passes if buffer in each.outputs)
    return fitted_shift(Redrawing(Case(oracle, Drawing(buffers), PROFILES["vulkan"]), this_pass, buffer))


def test_a_jitter_is_measured_to_a_step_or_two(oracle):
    x, y = 0.31, -0.17  # pixels
    jitter = moved_in_clip_space(2 * x / SIDE, 2 * y / SIDE)
    dumped = Planted("jitter", vertex(LIGHT, jitter, "shadow_map"), "", lacks=NUMBERS).drawn(oracle.scene)
    assert np.allclose(shift_of(oracle, "light_depth", dumped), (x, y), rtol=0, atol=2 * STEP)


@pytest.mark.parametrize("buffer", ["light_depth", "light_triangle"])  # numbers of triangles have no slope
def test_a_right_buffer_lies_where_it_should(oracle, buffer):
    assert shift_of(oracle, buffer, oracle.buffers) == (0.0, 0.0)
