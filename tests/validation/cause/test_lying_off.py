"""How far off a draw lies, measured on what was dumped of it."""

import numpy as np
import pytest
from planted import LIGHT, NUMBERS, Planted, moved_in_clip_space, oracle_of, scene_of, vertex, zoomed

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.lying_off import Projected, fitted_shift, lying_off
from sss_ref.validation.cause.redrawn import Redrawing
from sss_ref.validation.clock import Limit

SIDE = 48
X, Y = 0.31, -0.17  # pixels
JITTER = vertex(LIGHT, moved_in_clip_space(2 * X / SIDE, 2 * Y / SIDE), "shadow_map")


@pytest.fixture(scope="module")
def oracle():
    return oracle_of(scene_of("bust", SIDE))


def draw_of(oracle, buffer, buffers):
    (this_pass,) = (each for each in oracle.scene.method.passes if buffer in each.outputs)
    return Redrawing(Case(oracle, Drawing(buffers), PROFILES["vulkan"]), this_pass, buffer)


def shift_of(oracle, buffer, buffers):
    return fitted_shift(Projected(draw_of(oracle, buffer, buffers), LIGHT), Limit(60))


@pytest.mark.parametrize("lacks", [(), NUMBERS, (*NUMBERS, "light_depth")])
def test_a_jitter_is_measured_to_a_five_hundredth_of_a_pixel(oracle, lacks):
    dumped = Planted("jitter", JITTER, "", lacks=lacks).drawn(oracle.scene)
    assert np.allclose(shift_of(oracle, "light_distance", dumped), (X, Y), rtol=0, atol=1 / 500)


def test_where_only_numbers_of_triangles_are_known_it_is_searched_for(oracle):
    dumped = Planted("jitter", JITTER, "").drawn(oracle.scene)
    dumped = {name: buffer for name, buffer in dumped.items() if name == "light_triangle"}
    assert np.allclose(shift_of(oracle, "light_triangle", dumped), (X, Y), rtol=0, atol=1 / 50)


@pytest.mark.parametrize("buffer", ["light_depth", "light_triangle"])
def test_a_right_buffer_lies_where_it_should(oracle, buffer):
    alone = {buffer: oracle[buffer]}
    assert shift_of(oracle, buffer, alone) == (0.0, 0.0) and not [*lying_off(draw_of(oracle, buffer, alone), Limit(60))]


def test_the_size_of_a_picture_is_measured(oracle):
    dumped = Planted("zoom", vertex(LIGHT, zoomed(1.013), "shadow_map"), "").drawn(oracle.scene)
    texts = [each.charge.text for each in lying_off(draw_of(oracle, "light_depth", dumped), Limit(60))]
    assert f"{LIGHT} is of another field of view: tan(fov_y/2) is 1.013 times as large" in texts
