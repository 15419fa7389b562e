"""Which triangles may be seen, on a few triangles whose corners are put by hand."""

from dataclasses import replace

import numpy as np
import pytest

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.pipeline import MeshDraw
from sss_ref.numerics.interval import Interval
from sss_ref.raster.interpolate import interpolate_arrays
from sss_ref.raster.primitives import place
from sss_ref.raster.viewport import Viewport
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.acceptance import INTERPOLATION
from sss_ref.validation.accept.rasterizer.boxes import Boxes, same_places
from sss_ref.validation.accept.rasterizer.interpolation import interpolation_slack
from sss_ref.validation.accept.rasterizer.visible import MAY, MUST, MUST_NOT, visible

SIZE = 8
HALF = 1 / 512


@pytest.fixture(scope="module")
def draws():
    """A draw with a depth test, and a layout."""
    passes = load_scene("figure5").method.passes
    found = {one.name: one.draw for one in passes if isinstance(one.draw, MeshDraw)}
    return found["camera"], found["irradiance_map"]


def exactly(depth):
    return Interval(depth.astype(np.float64), depth.astype(np.float64))


def boxes_at(corners, triangles, half=HALF):
    """Boxes around corners (x, y, depth) in pixels from the centre of pixel (0, 0), and triangles between them."""
    corners = np.array(corners, np.float64)
    ndc = np.column_stack([(corners[:, :2] + 0.5) / SIZE * 2 - 1, corners[:, 2] * 2 - 1, np.ones(len(corners))])
    attributes = np.column_stack([corners[:, :2], corners.sum(axis=1)]).astype(np.float32)
    viewport = Viewport(SIZE, SIZE)
    primitives, placed = place(ndc.astype(np.float32), attributes, np.array(triangles, np.int32), viewport)
    wide, none = np.full((len(corners), 2), half), np.zeros(len(corners))
    rounding = np.full((len(triangles), 2), 2 * SIZE * 2.0**-22)
    same, none_of_all = same_places(placed), np.zeros(attributes.shape)
    return Boxes(primitives, viewport, same, corners[:, :2], wide, wide, rounding, none, none, none_of_all)


def seen(draw, corners, triangles, overlap="", half=HALF):
    return visible(boxes_at(corners, triangles, half), draw, overlap, PROFILES["vulkan"])


def shown_at(found, column, row):
    """The triangles that a pixel may show."""
    return set(found.triangle[found.found.pixel == row * SIZE + column].tolist())


SQUARE = [(0.4, 0.4, 0.5), (6.6, 0.4, 0.5), (6.6, 6.6, 0.5), (0.4, 6.6, 0.5)]


def test_inside_must_outside_must_not_be_covered(draws):
    found = seen(draws[0], SQUARE, [(0, 1, 2), (0, 2, 3)])
    assert (found.covered[1:7, 1:7] == MUST).all()
    assert (found.covered[[0, 7]] == MUST_NOT).all() and (found.covered[:, [0, 7]] == MUST_NOT).all()


def test_on_a_shared_edge_one_of_two_must_be_seen(draws):
    found = seen(draws[0], SQUARE, [(0, 1, 2), (0, 2, 3)])
    for k in range(1, 7):
        assert shown_at(found, k, k) == {0, 1} and found.covered[k, k] == MUST
    assert shown_at(found, 2, 1) == {0} and shown_at(found, 1, 2) == {1}
    assert np.array_equal(found.several, np.diag([False, *[True] * 6, False]))


def test_the_two_vertices_of_a_seam_are_one_place(draws):
    found = seen(draws[0], [*SQUARE, SQUARE[0], SQUARE[2]], [(0, 1, 2), (4, 5, 3)])
    assert (found.covered[1:7, 1:7] == MUST).all()


def test_two_vertices_that_differ_in_a_bit_may_be_snapped_apart(draws):
    """As at a sphere's pole, where one is 1e-16 beside the other: a crack may open between them."""
    there = [(x, y, depth + 2.0**-40) for x, y, depth in (SQUARE[0], SQUARE[2])]
    boxes = boxes_at([*SQUARE, *there], [(0, 1, 2), (4, 5, 3)])
    assert np.array_equal(boxes.primitives.snapped[[0, 2]], boxes.primitives.snapped[[4, 5]])
    found = visible(boxes, draws[0], "", PROFILES["vulkan"])
    assert all(found.covered[k, k] == MAY for k in range(1, 7))


def test_on_a_rim_nothing_may_be_seen(draws):
    found = seen(draws[0], SQUARE, [(0, 1, 2)])
    assert all(found.covered[k, k] == MAY for k in range(1, 7))
    assert found.several[3, 3] and shown_at(found, 3, 3) == {0}


def test_on_a_silhouette_nothing_may_be_seen(draws):
    """Two triangles on the same side of the edge between them: a fold seen from the side."""
    found = seen(draws[0], [*SQUARE[:3], (6.5, 0.3, 0.6)], [(0, 1, 2), (0, 2, 3)])
    assert all(found.covered[k, k] == MAY for k in range(1, 7))


def test_around_a_corner_all_its_triangles_may_be_seen(draws):
    corners = [(3.0, 3.0, 0.5), *SQUARE]
    found = seen(draws[0], corners, [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1)])
    assert shown_at(found, 3, 3) == {0, 1, 2, 3} and found.covered[3, 3] == MUST
    with_hole = seen(draws[0], corners, [(0, 1, 2), (0, 2, 3), (0, 3, 4)])
    assert with_hole.covered[3, 3] == MAY


def test_what_lies_behind_is_not_seen_but_beside_an_edge(draws):
    behind = [(x, y, 0.7) for x, y, _ in SQUARE]
    found = seen(draws[0], SQUARE + behind, [(0, 1, 2), (4, 5, 6), (4, 6, 7)])
    assert shown_at(found, 4, 2) == {0} and shown_at(found, 2, 4) == {2}
    assert shown_at(found, 3, 3) == {0, 1, 2} and found.covered[3, 3] == MUST


def test_a_coverage_is_that_of_the_triangle_beside_it(draws):
    """On a rim either is right, but not one in one buffer and the other in the other."""
    draw = draws[0]
    found = seen(draw, SQUARE, [(0, 1, 2)])
    triangle = np.where(found.covered == MUST, 0, -1).astype(np.int32)
    on_rim = found.covered == MAY
    for at_rim in (-1, 0):
        triangle[on_rim] = at_rim
        right = {draw.triangle: triangle, draw.coverage: (triangle >= 0).astype(np.uint8)}
        assert all(holds.all() for holds in found.accepted(right, None).values())
        other = right | {draw.coverage: np.where(on_rim, at_rim < 0, right[draw.coverage]).astype(np.uint8)}
        assert np.array_equal(~found.accepted(other, None)[draw.coverage], on_rim) and on_rim.any()
        alone = {draw.coverage: other[draw.coverage]}
        assert found.accepted(alone, None)[draw.coverage].all()


def test_two_as_deep_as_each_other_may_both_be_seen(draws):
    near = [(x, y, 0.5 + 2.0**-24) for x, y, _ in SQUARE]
    assert shown_at(seen(draws[0], SQUARE[:3] + near[:3], [(0, 1, 2), (3, 4, 5)]), 4, 2) == {0, 1}
    far = [(x, y, 0.5 + 2.0**-20) for x, y, _ in SQUARE]
    assert shown_at(seen(draws[0], SQUARE[:3] + far[:3], [(0, 1, 2), (3, 4, 5)]), 4, 2) == {0}


@pytest.mark.parametrize("overlap, shown", [("first", 0), ("error", 0), ("last", 1)])
def test_in_a_layout_the_first_or_the_last_is_seen(draws, overlap, shown):
    found = seen(draws[1], SQUARE[:3] * 2, [(0, 1, 2), (3, 4, 5)], overlap)
    assert shown_at(found, 4, 2) == {shown}


def test_a_sliver_that_the_snap_removes_may_be_seen(draws):
    found = seen(draws[0], [(1.0, 1.0, 0.5), (5.0, 1.0, 0.5), (3.0, 1.0 + 1 / 1024, 0.5)], [(0, 1, 2)])
    assert shown_at(found, 3, 1) == {0} and found.covered[1, 3] == MAY


def test_what_is_right_to_have_drawn(draws):
    draw = draws[0]
    found = seen(draw, SQUARE, [(0, 1, 2), (0, 2, 3)])
    triangle = np.full((SIZE, SIZE), -1, np.int32)
    triangle[1:7, 1:7] = np.arange(1, 7)[:, None] > np.arange(1, 7)
    depth = np.where(triangle >= 0, np.float32(0.5), np.float32(1))
    coverage = (triangle >= 0).astype(np.uint8)
    right = {draw.triangle: triangle, draw.depth: depth, draw.coverage: coverage}
    assert all(holds.all() for holds in found.accepted(right, exactly(right[draw.depth])).values())
    assert not any(reach[3, 3] for reach in found.reach(right, {draw.triangle: triangle}, None).values())
    for name, value in {draw.triangle: -1, draw.depth: 0.501, draw.coverage: 0}.items():
        wrong = right | {name: right[name].copy()}
        wrong[name][3, 4] = value
        assert np.argwhere(~found.accepted(wrong, exactly(wrong[draw.depth]))[name]).tolist() == [[3, 4]]


def test_half_a_subpixel_by_hand():
    """Corners at pixels (0, 0), (6, 0) and (0, 4): an attribute that is x there grows by 1/512 over half a subpixel."""
    boxes = boxes_at([(0, 0, 0), (6, 0, 0), (0, 4, 0)], [(0, 1, 2)])
    inside = np.array([[2.0, 1.0, 3.0]], np.float32)
    slack = interpolation_slack(boxes, np.array([0]), np.array([2]), np.array([1]), inside, slice(0, 3))[0] / HALF
    assert 1 <= slack[0] <= 4 and 1 <= slack[1] <= 4 and 2 <= slack[2] <= 8


def test_interpolation_anywhere_in_the_boxes_is_within_the_slack():
    rng = np.random.default_rng(7)
    corners = rng.uniform(0, SIZE - 1, (300, 3)) * (1, 1, 0)
    boxes = boxes_at(corners, np.arange(300).reshape(-1, 3), half=1 / 32)
    primitives, sample, columns = boxes.primitives, np.tile(3, 100), slice(0, 3)
    own = interpolated(primitives.snapped / 256, primitives, sample)
    slack = interpolation_slack(boxes, np.arange(100), sample, sample, own.astype(np.float32), columns)
    for _ in range(50):
        moved = primitives.snapped / 256 + rng.uniform(-1 / 32, 1 / 32, (300, 2))
        assert (np.abs(interpolated(moved, primitives, sample) - own) <= slack + 1e-4).all()
    assert np.isfinite(slack).mean() > 0.8


def test_planes_in_float32_are_within_the_slack():
    """On slivers either plane, of a/w and of 1/w, is rounded by more than a changes."""
    rng = np.random.default_rng(11)
    corners = np.repeat(rng.uniform(3, 4, (200, 3)), 3, axis=0) + rng.uniform(-0.05, 0.05, (600, 3))
    corners[:, 0] += np.tile([-3, 0, 3], 200)
    boxes = boxes_at(corners * (1, 1, 0), np.arange(600).reshape(-1, 3), half=0)
    attributes = (0.8 + rng.uniform(0, 0.001, (600, 1))).astype(np.float32)
    inverse_w = rng.uniform(0.5, 2, 600).astype(np.float32)
    boxes = replace(boxes, primitives=boxes.primitives._replace(attributes=attributes, inverse_w=inverse_w))
    primitives, kept = boxes.primitives, np.flatnonzero(boxes.drawable)
    place = (primitives.snapped[primitives.corners[kept]] / 256).astype(np.float32).transpose(1, 2, 0)
    column, row = np.rint(place.mean(axis=0)).astype(np.int64)
    weight = inverse_w.reshape(-1, 3)[kept].T
    drawn = on_plane(place, attributes.reshape(-1, 3)[kept].T * weight, column, row) / on_plane(
        place, weight, column, row
    )
    own = interpolate_arrays(primitives, kept, column, row, 256)
    slack = interpolation_slack(boxes, kept, column, row, own, slice(0, 1))
    apart = np.abs(drawn[:, None].astype(np.float64) - own)
    assert (apart <= slack + own * INTERPOLATION).all()
    assert (apart > own * INTERPOLATION).sum() > 20


def on_plane(place, values, column, row):
    """A plane in float32, float32 (N,), from the picture's corner, through values (3, N) at places (3, 2, N)."""
    (x1, y1), (x2, y2) = place[1:] - place[0]
    first, second = values[1:] - values[0]
    one = np.float32(1) / (x1 * y2 - x2 * y1)
    along_x, along_y = first * (y2 * one) - second * (y1 * one), second * (x1 * one) - first * (x2 * one)
    start = values[0] - (along_x * place[0, 0] + along_y * place[0, 1])
    return (start + along_x * column.astype(np.float32)) + along_y * row.astype(np.float32)


def interpolated(place, primitives, sample):
    """The attributes of all triangles at pixel (3, 3), on the planes through corners at these places; float64."""
    a, b, c = (place[primitives.corners[:, k]] - 3 for k in range(3))
    weights = np.stack([cross(b, c), cross(c, a), cross(a, b)])
    values = primitives.attributes[primitives.corners.T].astype(np.float64)
    return (weights[..., None] * values).sum(axis=0) / weights.sum(axis=0)[:, None]


def cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
