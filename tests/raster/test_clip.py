import naive_raster
import numpy as np
import pytest
from raster_proof import assert_same_bits

from sss_ref.raster.clip import MOST_VERTICES, clip, fans

CORNERS = np.array([[0, 1, 2]], np.int32)


def cut(*vertices, attributes=None):
    """Clip one triangle; (N, 4 + A) corners of what is left, in fan order."""
    position = np.array(vertices, np.float32)
    attributes = np.zeros((3, 0), np.float32) if attributes is None else np.array(attributes, np.float32)
    pieces = clip(position, attributes, CORNERS)
    return np.concatenate([pieces.clip_position, pieces.attributes], axis=1)[pieces.corners]


def test_a_triangle_inside_is_left_alone():
    position = np.array([(1, 1, 1, 1), (-1, 1, 1, 1), (1, -1, -1, 1)], np.float32)  # on five planes, outside none
    attributes = np.zeros((3, 2), np.float32)
    pieces = clip(position, attributes, CORNERS)
    assert pieces.clip_position is position and pieces.attributes is attributes and pieces.corners is CORNERS


def test_one_corner_outside_leaves_a_fan_of_two():
    pieces = cut((0, 0, 0, 1), (4, 0, 0, 1), (0, 1, 0, 1), attributes=[[0], [8], [16]])
    # w - x = 1, -3, 1: the cut is a quarter of the way to the far corner, on both edges
    a, b, c, d = (0, 0, 0, 1, 0), (1, 0, 0, 1, 2), (1, 0.75, 0, 1, 14), (0, 1, 0, 1, 16)
    assert pieces.tolist() == [[list(a), list(b), list(c)], [list(a), list(c), list(d)]]


def test_a_polygon_may_start_with_a_new_vertex():
    pieces = cut((4, 0, 0, 1), (0, 1, 0, 1), (0, 0, 0, 1))
    assert pieces[:, 0].tolist() == [[1, 0.75, 0, 1]] * 2


def test_mixes_from_the_nearer_vertex():
    near, far = np.float32(0.9), np.float32(7.3)  # distances 1 - x: inside is nearer
    t = (1 - near) / ((1 - near) - (1 - far))
    pieces = cut((near, 0, 0, 1), (far, 0, 0, 1), (0, 1, 0, 1))
    assert_same_bits(pieces[0, 1, :1], np.array([near * (1 - t) + far * t]))
    near, far = np.float32(1.1), np.float32(-0.9)  # outside is nearer
    t = (1 - near) / ((1 - near) - (1 - far))
    pieces = cut((far, 0, 0, 1), (near, 0, 0, 1), (0, 1, 0, 1))
    assert_same_bits(pieces[0, 1, :1], np.array([near * (1 - t) + far * t]))


def test_on_a_tie_mixes_from_the_inside_vertex():
    # t is 1/2 and the order shows in no bit, unless the sum of the distances overflows: then t is 0
    huge = 2e38
    for vertices in ([(0, 0, 0, huge), (huge, 0, 0, 0)], [(huge, 0, 0, 0), (0, 0, 0, huge)]):
        pieces = cut(*vertices, (0, huge, 0, huge), attributes=[[v[3] / huge] for v in vertices] + [[3]])
        assert np.float32(0) not in pieces[..., 4]


def test_both_triangles_of_a_shared_edge_get_the_same_vertices():
    rng = np.random.default_rng(11)
    for _ in range(200):
        a, b, c, d = rng.normal(size=(4, 4)).astype(np.float32) * (2, 2, 2, 1) + np.float32((0, 0, 0, 0.8))
        one, other = edge_vertices(a, b, c), edge_vertices(b, a, d)
        assert one == other


def edge_vertices(a, b, c):
    """The vertices of the clipped triangle that lie on a-b: those whose third barycentric attribute is exactly 0."""
    left = cut(a, b, c, attributes=[[0], [0], [1]])
    return {vertex.tobytes() for vertex in left.reshape(-1, 5)[:, :5].astype(np.float32) if vertex[4] == 0}


@pytest.mark.parametrize("seed", range(4))
def test_each_triangle_is_cut_plane_by_plane_in_the_order_of_the_rule(seed):
    """As one reads the rule: many cross both planes of an axis, where another order has other bits."""
    rng = np.random.default_rng(seed)
    for triangle in (rng.normal(size=(60, 3, 6)) * (3, 3, 3, 1, 1, 1) + (0, 0, 0, 0.7, 0, 0)).astype(np.float32):
        polygon = naive_raster.clip([list(vertex) for vertex in triangle], set())
        fan = [(polygon[0], polygon[k], polygon[k + 1]) for k in range(1, len(polygon) - 1)]
        found = cut(*triangle[:, :4], attributes=triangle[:, 4:])
        assert_same_bits(found, np.array(fan, np.float32).reshape(-1, 3, 6))


def test_nothing_is_left_of_a_triangle_outside():
    assert len(cut((2, 0, 0, 1), (3, 0, 0, 1), (2, 1, 0, 1))) == 0
    assert len(cut((0, 0, 0, -1), (0.5, 0, 0, -1), (0, 0.5, 0, -1))) == 0


def test_pieces_keep_the_order_of_the_triangles():
    inside, crossing, outside = np.eye(3, 4) / 2, np.eye(3, 4) * 2, np.eye(3, 4) * 4  # x + y + z = 1/2, 2, 4 with w = 1
    position = np.concatenate([crossing, outside, inside, crossing]).astype(np.float32) + np.float32((0, 0, 0, 1))
    pieces = clip(position, np.zeros((12, 1), np.float32), np.arange(12, dtype=np.int32).reshape(4, 3))
    count = np.bincount(pieces.triangle, minlength=4).tolist()
    assert count[0] == count[3] > 1 and count[1:3] == [0, 1]
    assert (np.diff(pieces.triangle) >= 0).all() and pieces.corners[pieces.triangle == 2].tolist() == [[6, 7, 8]]


def test_many_crossing_triangles_outgrow_the_first_allocation():
    one = np.array([(-3, -3, 0, 1), (3, -3, 0, 1), (0, 3, 0, 1)], np.float32)
    position = np.tile(one, (1000, 1))
    pieces = clip(position, position[:, :1], np.arange(3000, dtype=np.int32).reshape(-1, 3))
    expected = cut(*one, attributes=one[:, :1])
    found = np.concatenate([pieces.clip_position, pieces.attributes], axis=1)[pieces.corners]
    assert len(expected) > 2
    assert_same_bits(found, np.tile(expected, (1000, 1, 1)))


def test_fans():
    assert fans(np.array([4, 0, 3])).tolist() == [[0, 1, 2], [0, 2, 3], [4, 5, 6]]


def test_most_vertices_is_six_cuts_of_at_most_three_halves():
    most = 3
    for _ in range(6):
        most = most * 3 // 2
    assert most == MOST_VERTICES
