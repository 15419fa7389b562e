import numpy as np
import pytest
from raster_proof import assert_same_bits, interpolate_compiled, weights_compiled

from sss_ref.raster.interpolate import interpolate_arrays, weights_arrays
from sss_ref.raster.primitives import assemble
from sss_ref.raster.viewport import Viewport

VIEWPORT = Viewport(4, 4)


def one_triangle(corners, attributes=((0,), (0,), (8,))):
    """Corners at window (0, 0), (4, 0), (0, 4) with w = 1, 2, 4."""
    position = np.array([(-1, -1, 0, 1), (2, -2, 0, 2), (-4, 4, 0, 4)], np.float32)
    return assemble(position, np.array(attributes, np.float32), np.array([corners], np.int32), VIEWPORT)


@pytest.mark.parametrize("corners", [(0, 1, 2), (2, 1, 0)])
def test_weights_by_hand(corners):
    # pixel (1, 0): window (1.5, 0.5) divides the area 16 as 8 : 6 : 2, in units of step^2; over w = 1, 2, 4
    where = np.array([[0], [1], [0]])
    for weights in (weights_arrays, weights_compiled):
        found = weights(one_triangle(corners), *where, VIEWPORT.step)
        assert found[:, 0].tolist() == [(8, 3, 0.5)[corner] * 256.0**2 for corner in corners]


@pytest.mark.parametrize("corners", [(0, 1, 2), (2, 1, 0)])
def test_attribute_by_hand(corners):
    expected = np.array([[np.float32(4) / np.float32(11.5)]])  # 8*0.5 / (8 + 3 + 0.5)
    where = np.array([[0], [1], [0]])
    primitives = one_triangle(corners)
    assert_same_bits(interpolate_arrays(primitives, *where, VIEWPORT.step), expected)
    assert_same_bits(interpolate_compiled(primitives, *where, VIEWPORT.step), expected)


@pytest.mark.parametrize("corners", [(0, 1, 2), (2, 1, 0), (1, 2, 0)])
def test_every_corner_gives_its_share(corners):
    primitives = one_triangle(corners, attributes=((1, 5), (2, -4), (8, 0.5)))
    expected = np.float32([[18, 28.25]]) / np.float32(11.5)  # 8*1 + 3*2 + .5*8, 8*5 - 3*4 + .5*.5
    where = np.array([[0], [1], [0]])
    assert_same_bits(interpolate_arrays(primitives, *where, VIEWPORT.step), expected)
    assert_same_bits(interpolate_compiled(primitives, *where, VIEWPORT.step), expected)


def test_a_clockwise_piece_keeps_the_sign_of_zero():
    primitives = one_triangle((2, 1, 0), attributes=((0,), (0,), (0,)))
    on_an_edge = np.array([[0], [0], [3]])  # where one weight is 0 the products' zeros would differ in sign
    value = interpolate_arrays(primitives, *on_an_edge, VIEWPORT.step)
    assert_same_bits(value, np.zeros((1, 1), np.float32))
    assert_same_bits(interpolate_compiled(primitives, *on_an_edge, VIEWPORT.step), value)


def test_edge_functions_beyond_24_bits_are_rounded_once():
    viewport = Viewport(16384, 16384)
    position = np.array([(-1, -1, 0, 1), (1, -0.9, 0, 1), (-0.77, 1, 0, 1)], np.float32)
    primitives = assemble(position, np.zeros((3, 0), np.float32), np.array([[0, 1, 2]], np.int32), viewport)
    (ax, ay), (bx, by) = primitives.snapped[1:].tolist()
    exact = (ax - 4000 * 256) * (by - 7000 * 256) - (bx - 4000 * 256) * (ay - 7000 * 256)
    assert exact > 2**40 and int(np.float32(exact)) != exact
    where = np.array([[0], [4000], [7000]])
    assert weights_arrays(primitives, *where, viewport.step)[0] == np.float32(exact)
    assert weights_compiled(primitives, *where, viewport.step)[0] == np.float32(exact)


@pytest.mark.filterwarnings("error")
def test_what_is_too_large_for_float32_is_no_number_and_no_warning():
    primitives = one_triangle((0, 1, 2), attributes=((3e38,), (3e38,), (-3e38,)))
    assert not np.isfinite(interpolate_arrays(primitives, *np.array([[0], [1], [0]]), VIEWPORT.step)).all()
