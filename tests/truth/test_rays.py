"""The tree finds what asking every triangle finds, and lengths inside are those of closed forms."""

import math

import numpy as np
import pytest
from lit_boxes import parallel, scenery

from sss_ref.scene.load import load_scene
from sss_ref.truth.box_tree import LEAF, box_tree_of
from sss_ref.truth.media import volumes
from sss_ref.truth.rays import NO_TRIANGLE, crossing, inside_length, meets, nearest, normal, steepness
from sss_ref.truth.tracing import Tracing

NUMBERS = np.random.default_rng(3)


def random_triangles(count):
    return NUMBERS.normal(size=(count, 1, 3)) + 0.3 * NUMBERS.normal(size=(count, 3, 3))


def random_directions(count):
    drawn = NUMBERS.normal(size=(count, 3))
    return drawn / np.sqrt((drawn**2).sum(axis=1, keepdims=True))


@pytest.fixture(scope="module")
def bust():
    return Tracing(load_scene("figure3_with"), volumes("skin1")).scenery.tree


def test_every_triangle_is_in_one_leaf_and_every_box_holds_what_is_inside():
    tree = box_tree_of(random_triangles(333))
    leaves = tree.triangles[tree.triangles[:, 1] > 0]
    assert (np.diff(leaves) <= LEAF).all()
    assert sorted(number for first, last in leaves for number in range(first, last)) == list(range(333))
    for box, beyond in enumerate(tree.beyond):
        assert (tree.low[box] <= tree.low[box:beyond]).all() and (tree.high[box] >= tree.high[box:beyond]).all()
        for first, last in tree.triangles[box:beyond]:
            points = (
                tree.corner[first:last],
                (tree.corner + tree.edge1)[first:last],
                (tree.corner + tree.edge2)[first:last],
            )
            assert all(
                (tree.low[box] <= each + 1e-12).all() and (tree.high[box] >= each - 1e-12).all() for each in points
            )


@pytest.mark.parametrize("count", [1, 4, 5, 300])
def test_the_nearest_is_that_of_all(count):
    tree = box_tree_of(random_triangles(count))
    origins, directions = NUMBERS.normal(size=(300, 3)) * 2, random_directions(300)
    aimed = (tree.corner + (tree.edge1 + tree.edge2) / 3)[NUMBERS.integers(count, size=150)] - origins[150:]
    directions[150:] = aimed / np.sqrt((aimed**2).sum(axis=1, keepdims=True))
    directions[:30] = np.sign(directions[:30]) * np.eye(3)[NUMBERS.integers(3, size=30)]  # along an axis
    met = 0
    for origin, direction in zip(map(tuple, origins), map(tuple, directions), strict=True):
        every = [crossing(tree, triangle, origin, direction) for triangle in range(count)]
        for inwards in (True, False):
            ahead = [(far, k) for k, (far, turn) in enumerate(every) if far >= 0 and (turn > 0) == inwards]
            distance, triangle = min(ahead, default=(math.inf, NO_TRIANGLE))
            assert nearest(tree, origin, direction, math.inf, inwards) == (distance, triangle)
            if ahead:
                met += 1
                assert (np.dot(normal(tree, triangle), direction) < 0) == inwards
                assert nearest(tree, origin, direction, distance, inwards) == (distance, NO_TRIANGLE)
    assert met >= 150


def test_where_a_triangle_is_met():
    tree = box_tree_of(np.array([[[0.0, 0, 0], [2, 0, 0], [0, 2, 0]]]))
    assert nearest(tree, (0.5, 0.5, 3.0), (0.0, 0.0, -1.0), math.inf, True) == (3.0, 0)
    assert nearest(tree, (0.5, 0.5, -3.0), (0.0, 0.0, 1.0), math.inf, False) == (3.0, 0)
    assert nearest(tree, (1.5, 1.5, 3.0), (0.0, 0.0, -1.0), math.inf, True)[1] == NO_TRIANGLE
    assert normal(tree, 0) == (0.0, 0.0, 1.0)


def test_lengths_inside_a_body_with_a_concave_face(bust):
    """By the sorted crossings of every triangle."""
    inside = (0.0, 0.1, 0.0)
    for direction in map(tuple, random_directions(12)):
        every = [crossing(bust, triangle, inside, direction) for triangle in range(len(bust.corner))]
        ahead = sorted((distance, determinant < 0) for distance, determinant in every if distance >= 0)
        distances = np.array([0.0, *(distance for distance, _ in ahead)])
        assert [outwards for _, outwards in ahead] == [k % 2 == 0 for k in range(len(ahead))]
        expected = np.diff(distances)[::2].sum()
        assert inside_length(bust, inside, direction, math.inf) == pytest.approx(expected, rel=1e-12)
    assert inside_length(bust, (9.0, 9.0, 9.0), direction, math.inf) == -1.0  # a point outside: not known


def test_some_rays_leave_the_bust_more_than_once(bust):
    counts = []
    for direction in map(tuple, random_directions(16)):
        every = [crossing(bust, triangle, (0.0, -0.7, 0.0), direction)[0] for triangle in range(len(bust.corner))]
        counts.append(sum(distance >= 0 for distance in every))
    assert max(counts) >= 3


ONE = box_tree_of(np.array([[[0.0, 0, 0], [2, 0, 0], [0, 2, 0]]]))
ASKEW = box_tree_of(np.array([[[1.0, 2, 3], [3.0, 3, 2], [0.0, 5, 5]]]))
DOWN, UP = (0.0, 0.0, -1.0), (0.0, 0.0, 1.0)


@pytest.mark.parametrize("at", [(0, 0), (2, 0), (0, 2), (1, 0), (0, 1), (1, 1), (0.5, 0.25)])
def test_corners_and_edges_belong_to_a_triangle(at):
    assert crossing(ONE, 0, (*map(float, at), 3.0), DOWN) == (3, 4)  # twice its area times the cosine
    assert crossing(ONE, 0, (*map(float, at), -3.0), UP) == (3, -4)
    assert crossing(ONE, 0, (*map(float, at), 0.0), DOWN) == (0, 4)


@pytest.mark.parametrize("at", [(-0.01, 1), (1, -0.01), (1.01, 1), (3, -1), (-1, 3)])
def test_beside_its_edges_a_triangle_is_not_met(at):
    assert crossing(ONE, 0, (*map(float, at), 3.0), DOWN) == (-1, 4)


def test_a_ray_along_a_triangle_does_not_meet_it():
    assert crossing(ONE, 0, (0.5, -1.0, 0.0), (0.0, 1.0, 0.0)) == (-1, 0)
    assert crossing(ONE, 0, (0.5, 0.5, 3.0), UP) == (-3, -4)  # behind


def test_a_triangle_askew_is_met_where_its_edges_say():
    """A quarter of one edge (2, 1, -1) and half of the other (-1, 3, 2) from its corner, two steps (1, -2, 4) off."""
    assert crossing(ASKEW, 0, (-1.0, 7.75, -4.25), (1.0, -2.0, 4.0)) == (2, -39)
    assert crossing(ASKEW, 0, (3.0, -0.25, 11.75), (-1.0, 2.0, -4.0)) == (2, 39)
    assert normal(ASKEW, 0) == pytest.approx(np.array([5, -3, 7]) / math.sqrt(83), abs=1e-15)


def test_what_a_ray_starts_on_is_as_near_as_can_be():
    assert nearest(ONE, (0.5, 0.5, 0.0), DOWN, math.inf, True) == (0, 0)
    assert nearest(ONE, (0.5, 0.5, 3.0), DOWN, 3.0, True) == (3, NO_TRIANGLE)


@pytest.mark.parametrize(("component", "steep"), [(2.0, 0.5), (-0.25, -4.0), (0.0, 1e300), (1e-301, 1e300)])
def test_how_far_a_step_along_an_axis_is(component, steep):
    assert steepness(component) == steep


CUBE = scenery(parallel(UP)).tree  # of 12 triangles, -1 to 1


@pytest.mark.parametrize(
    ("origin", "direction", "limit", "is_met"),
    [
        ((0.0, 0.0, 5.0), DOWN, math.inf, True),
        ((0.0, 0.0, 5.0), DOWN, 4.0, True),
        ((0.0, 0.0, 5.0), DOWN, 3.99, False),
        ((0.0, 0.0, -5.0), DOWN, math.inf, False),
        ((0.0, 0.0, 0.0), DOWN, 0.5, True),
        ((0.0, 0.0, 1.0), UP, math.inf, True),  # on its border
        ((-1.0, -1.0, 5.0), DOWN, math.inf, True),  # along an edge: of two boxes side by side one has it
        ((1.0, -1.0, 5.0), DOWN, math.inf, False),
        ((-1.0, 1.0, 5.0), DOWN, math.inf, False),
        ((1.5, 0.0, 5.0), DOWN, math.inf, False),
        ((0.0, 0.0, 5.0), (0.3, 0.0, -1.0), math.inf, False),  # beside it after 3.3, as high after 4
        ((0.0, 0.0, 5.0), (0.2, -0.2, -1.0), math.inf, True),
    ],
)
def test_which_rays_meet_a_box(origin, direction, limit, is_met):
    assert meets(CUBE, 0, origin, tuple(map(steepness, direction)), limit) == is_met


@pytest.mark.parametrize(("limit", "length"), [(math.inf, 1.75), (3.0, -1.0), (2.75, 0.75), (0.8, 0.75), (0.75, -1.0)])
def test_the_way_through_two_boxes(limit, length):
    """From .25 to 1 and from 3 to 4; not known to a point inside, nor to one on a border."""
    tree = scenery(parallel(UP), ends=(((-1, -1, -1), (1, 1, 1)), ((-1, -1, 3), (1, 1, 4)))).tree
    assert inside_length(tree, (0.1, 0.2, 0.25), UP, limit) == length


def test_a_way_that_begins_on_a_face_leaves_there():
    """After 0; then there are 2 outside and 1 inside."""
    tree = scenery(parallel(UP), ends=(((-1, -1, -1), (1, 1, 1)), ((-1, -1, 3), (1, 1, 4)))).tree
    assert inside_length(tree, (0.1, 0.2, 1.0), UP, math.inf) == 1
    assert inside_length(tree, (0.1, 0.2, 1.0), UP, 1.0) == 0
