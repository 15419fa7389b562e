import numpy as np
import pytest
from raster_proof import assert_same_bits

from sss_ref.raster.primitives import assemble
from sss_ref.raster.viewport import Viewport


def assembled(vertices, viewport=None, triangles=((0, 1, 2),)):
    position = np.array(vertices, np.float32)
    triangles = np.array(triangles, np.int32).reshape(-1, 3)
    return assemble(position, np.zeros((len(position), 0), np.float32), triangles, viewport or Viewport(4, 2))


def test_window_position_depth_and_inverse_w_by_hand():
    primitives = assembled([(-2, -2, -2, 2), (2, -2, 0, 2), (0, 0.5, 1, 1)])
    # window (0, 0), (4, 0), (2, 1.5): less half a pixel, times 256
    assert primitives.snapped.tolist() == [[-128, -128], [896, -128], [384, 256]]
    assert primitives.depth.tolist() == [0, 0.5, 1]
    assert primitives.inverse_w.tolist() == [0.5, 0.5, 1]
    assert [array.dtype.name for array in primitives] == ["int32", "int32", "int32", "float32", "float32", "float32"]


def test_the_snap_rounds_half_to_even():
    viewport = Viewport(2, 2, subpixel_bits=0)  # window x = ndc + 1, snapped = round(ndc + 1/2)
    primitives = assembled([(-1, -1, 0, 1), (0, 0.99, 0, 1), (1, 0, 0, 1)], viewport)
    assert primitives.snapped.tolist() == [[0, 0], [0, 1], [2, 0]]


def test_four_subpixel_bits():
    primitives = assembled([(-1, -1, 0, 1), (1, -1, 0, 1), (0, 0.5, 0, 1)], Viewport(4, 2, subpixel_bits=4))
    assert primitives.snapped.tolist() == [[-8, -8], [56, -8], [24, 16]]


@pytest.mark.parametrize(
    "vertices",
    [
        [(0, 0, 0, 0)] * 3,  # the eye: inside all six planes
        [(0, 0, 0, 0), (0.5, 0, 0, 1), (0, 0.5, 0, 1)],
        [(0, 0, 0, -1), (0.5, 0, 0, -1), (0, 0.5, 0, -1)],  # behind the eye
        [(5, 0, 0, 1), (6, 0, 0, 1), (5, 1, 0, 1)],
        [(0, 0, 0, 1), (0.25, 0.25, 0, 1), (0.5, 0.5, 0, 1)],  # a line
        [(0, 0, 0, 1), (0.0001, 0, 0, 1), (0, 0.0001, 0, 1)],  # a point after the snap
        [(0, 0, 0, 1e-40), (0, 1e-40, 0, 1e-40), (1e-40, 0, 0, 1e-40)],  # 1/w overflows
    ],
)
def test_what_cannot_be_covered_is_dropped(vertices):
    assert len(assembled(vertices).corners) == 0


def test_huge_positions_keep_to_the_guard():
    rng = np.random.default_rng(3)
    scale = 10.0 ** rng.integers(30, 39, (500, 1, 1))
    position = (rng.uniform(-3, 3, (500, 3, 4)) * scale).astype(np.float32).reshape(-1, 4)
    primitives = assembled(position, triangles=np.arange(1500))
    assert len(primitives.corners) > 100
    corners = primitives.corners
    assert (primitives.inverse_w[corners] > 0).all() and (abs(primitives.snapped[corners]) <= 2**24).all()


def test_a_vertex_without_a_place_in_the_window_is_marked():
    limit = 2.0**24 / 512  # of x/w in a picture of 4 pixels: snapped = (2*x/w + 1.5)*256
    positions = [(limit - 2, 0, 0, 1), (limit, 0, 0, 1), (0, -2 * limit - 2, 0, 1), (0, 0, 0, -1), (np.nan, 0, 0, 1)]
    primitives = assembled(positions, triangles=())  # so nothing is clipped
    assert primitives.inverse_w.tolist() == [1, 0, 0, 0, 0]
    assert primitives.snapped.tolist() == [[2**24 - 640, 128], *[[0, 0]] * 4]


def test_the_guard_itself_is_a_place():
    """Of 4 x 2 pixels: snapped = (2*x/w + 1.5)*256 and (y/w + .5)*256; two units are the next float32."""
    x, y, unit = 32767.25, 65535.5, 1 / 256
    at_the_guard, beyond = [(x, 0, 0, 1), (0, y, 0, 1)], [(x + unit, 0, 0, 1), (0, y + 2 * unit, 0, 1)]
    primitives = assembled([*at_the_guard, *beyond], triangles=())
    assert primitives.snapped.tolist() == [[2**24, 128], [384, 2**24], [0, 0], [0, 0]]
    assert primitives.inverse_w.tolist() == [1, 1, 0, 0]


@pytest.mark.parametrize("corners", [(0, 1, 2), (1, 0, 2), (1, 2, 0)])
def test_one_corner_without_a_place_drops_the_piece_whichever_it_is(corners):
    vertices = [(0, 0, 0, 0), (0.5, 0, 0, 1), (0, 0.5, 0, 1), (0.25, 0.25, 0, 1), (-0.5, 0, 0, 1)]
    primitives = assembled(vertices, triangles=(corners, (1, 2, 4)))
    assert primitives.triangle.tolist() == [1]


def test_no_triangles():
    primitives = assembled([(0, 0, 0, 1)], triangles=())
    assert primitives.corners.shape == (0, 3) and primitives.triangle.shape == (0,)


def test_both_sides_are_kept():
    vertices = [(0, 0, 0, 1), (1, 0, 0, 1), (0, 1, 0, 1)]
    primitives = assembled(vertices, triangles=((0, 1, 2), (2, 1, 0)))
    assert_same_bits(primitives.triangle, np.array([0, 1], np.int32))
