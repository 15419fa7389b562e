"""The tree of a few triangles, written down."""

import numpy as np
import pytest

from sss_ref.truth.box_tree import box_tree_of


def row_along(axis, places):
    """Triangles beside each other along an axis, each from 0 to .5 of the others, a tenth wide."""
    corners = np.zeros((len(places), 3, 3))
    corners[:, 1, (axis + 1) % 3], corners[:, 2, (axis + 2) % 3] = 0.5, 0.5
    corners[:, :, axis] = np.array(places)[:, np.newaxis] + [0.0, 0.1, 0.0]
    return corners


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_nine_triangles_are_three_leaves(axis):
    """Four and five, which is one too many for a leaf: two and three."""
    places = [8.0, 3.0, 5.0, 0.0, 1.0, 7.0, 2.0, 6.0, 4.0]
    tree = box_tree_of(row_along(axis, places))
    assert tree.triangles.tolist() == [[0, 0], [0, 4], [0, 0], [4, 6], [6, 9]]
    assert tree.beyond.tolist() == [5, 2, 5, 4, 5]
    assert tree.corner[:, axis].tolist() == [0, 1, 2, 3, 4, 5, 6, 7, 8]
    ends = [(low, round(high, 9)) for low, high in zip(tree.low[:, axis], tree.high[:, axis], strict=True)]
    assert ends == [(0, 8.1), (0, 3.1), (4, 8.1), (4, 5.1), (6, 8.1)]
    others = [other for other in range(3) if other != axis]
    assert (tree.low[:, others] == 0).all() and (tree.high[:, others] == 0.5).all()


def test_the_ways_from_a_corner_to_the_others():
    tree = box_tree_of(np.array([[[1.0, 2, 3], [2.0, 2, 5], [1.0, 7, 3]]]))
    assert (tree.corner.tolist(), tree.edge1.tolist(), tree.edge2.tolist()) == ([[1, 2, 3]], [[1, 0, 2]], [[0, 5, 0]])
    assert (tree.triangles.tolist(), tree.beyond.tolist()) == ([[0, 1]], [1])
    assert (tree.low.tolist(), tree.high.tolist()) == ([[1, 2, 3]], [[2, 7, 5]])


def test_triangles_at_one_place_stay_in_their_order():
    """They are cut in the middle all the same."""
    tree = box_tree_of(np.repeat(row_along(0, [1.0]), 6, axis=0))
    assert tree.triangles.tolist() == [[0, 0], [0, 3], [3, 6]] and tree.beyond.tolist() == [3, 2, 3]
