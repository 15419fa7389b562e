"""Which triangles may be seen, on a few triangles whose corners are put by hand."""

from dataclasses import replace
from types import SimpleNamespace

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
from sss_ref.validation.accept.rasterizer.candidates import Candidates
from sss_ref.validation.accept.rasterizer.interpolation import interpolation_slack
from sss_ref.validation.accept.rasterizer.visible import MAY, MUST, MUST_NOT, Visible, visible

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
    assert (found.covered[1:7, 1:7] == MUST).all() and (MUST_NOT, MAY, MUST) == (0, 1, 2)
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


DRAW = SimpleNamespace(triangle="triangle", depth="depth", coverage="coverage")
SEEN = {"triangle": np.int32([[7, 9, -1, -1]]), "depth": np.float32([[0.25, 0.5, 1, 1]])}  # as the oracle has it
SEEN["coverage"] = np.uint8([[1, 1, 0, 0]])


def by_hand():
    """Four pixels in a row: what must be seen, twice what may be, and what must not.

    At the first triangle 7 from 0.125 to 0.5, or 9 at 0.75 to 0.875, of which the oracle covers no sample; at the
    second 9 from 0.4375 to 0.625; at the third 7 from 0.125 to 0.25.
    """
    rows = [  # pixel, piece, low, high, inside
        (0, 0, 0.125, 0.5, True),
        (0, 1, 0.75, 0.875, False),
        (1, 1, 0.4375, 0.625, True),
        (2, 0, 0.125, 0.25, False),
    ]
    pixel, piece, low, high, inside = (np.array(column) for column in zip(*rows, strict=True))
    found = Candidates(pixel, piece.astype(np.int32), low, high, inside, inside, np.zeros(4, np.uint8))
    boxes = SimpleNamespace(primitives=SimpleNamespace(triangle=np.int32([7, 9])), drawable=np.array([True, True]))
    return Visible(DRAW, boxes, found, np.uint8([[MUST, MAY, MAY, MUST_NOT]]))


def dumped(**changed):
    """What was dumped: as the oracle has it, but for some buffers, whole rows of four."""
    return SEEN | {name: np.array([row], SEEN[name].dtype) for name, row in changed.items()}


def right(**changed):
    buffers = dumped(**changed)
    depth = exactly(buffers["depth"]) if "depth" in buffers else None
    return {name: holds[0].tolist() for name, holds in by_hand().accepted(buffers, depth).items()}


ALL = [True] * 4


@pytest.mark.parametrize(
    ("triangle", "holds"),
    [
        ((7, 9, -1, -1), ALL),
        ((9, -1, 7, -1), ALL),
        ((-1, 7, 9, 7), [False] * 4),
        ((-7, -9, -1, 0), [False, True, True, False]),  # any number below 0 is none
        ((0, 0, 0, -1), [False, False, False, True]),
    ],
)
def test_a_number_is_that_of_a_candidate_or_none_where_nothing_need_be(triangle, holds):
    assert right(triangle=triangle)["triangle"] == holds


@pytest.mark.parametrize(
    ("depth", "triangle", "holds"),
    [
        ((0.125, 0.4375, 0.125, 1), (7, 9, 7, -1), ALL),
        ((0.5, 0.625, 0.25, 1), (7, 9, 7, -1), ALL),
        ((0.0625, 0.375, 0.0625, 0.5), (7, 9, 7, -1), [False] * 4),
        ((0.5625, 0.6875, 0.3125, 0), (7, 9, 7, -1), [False] * 4),
        ((0.25, 1, 1, 1), (9, -1, -1, -1), [False, True, True, True]),  # that of the other triangle; nothing is seen
        ((0.8125, 0.5, 0.1875, 1), (9, -1, -1, -1), [True, False, False, True]),  # of a triangle that is not seen
        ((1, 1, 1, 1), (7, 9, 7, -1), [False, False, False, True]),
        ((1, 1, 1, 1), (0, 0, 0, 0), [False] * 4),  # triangle 0 is one
    ],
)
def test_a_depth_is_that_of_the_triangle_beside_it(depth, triangle, holds):
    assert right(depth=depth, triangle=triangle)["depth"] == holds


def test_without_numbers_a_depth_is_that_of_any_candidate():
    buffers = {"depth": np.float32([[0.8125, 1, 0.125, 0.5]])}
    holds = by_hand().accepted(buffers, exactly(buffers["depth"]))
    assert [*holds] == ["depth"] and holds["depth"].tolist() == [[True, True, True, False]]
    assert by_hand().accepted({}, None) == {}


@pytest.mark.parametrize(
    ("coverage", "triangle", "holds"),
    [
        ((1, 1, 0, 0), (7, 9, -1, -1), ALL),
        ((0, 0, 1, 1), (7, -1, 7, -1), [False, True, True, False]),
        ((1, 0, 1, 0), (7, 9, -1, -1), [True, False, False, True]),
        ((2, 1, 0, 0), (0, 0, -1, -1), ALL),
    ],
)
def test_a_coverage_goes_with_the_number_beside_it_where_it_may_be_either(coverage, triangle, holds):
    assert right(coverage=coverage, triangle=triangle)["coverage"] == holds


def reach(**changed):
    buffers = dumped(**changed)
    return {name: each[0].tolist() for name, each in by_hand().reach(SEEN, buffers, exactly(buffers["depth"])).items()}


def test_a_right_depth_reaches_as_far_as_its_triangle_or_to_what_was_dumped():
    assert reach()["depth"] == [0.25, 0.125, 0, 0]
    assert reach(depth=(0.375, 0.625, 0.25, 1), triangle=(7, 9, 7, -1))["depth"] == [0.25, 0.125, 0.75, 0]
    assert reach(depth=(0.8125, 0.5, 1, 1), triangle=(9, 9, -1, -1))["depth"] == [0.5625, 0.125, 0, 0]


@pytest.mark.parametrize(
    ("depth", "expected"),
    [
        ((0.125, 0.4375, 0.1875, 1), [0.375, 0.1875, 0, 0]),
        ((0.5, 0.625, 0.125, 1), [0.375, 0.1875, 0, 0]),
        ((0.75, 0.5, 0.25, 1), [0, 0.125, 0, 0]),
    ],
)
def test_a_depth_reaches_to_the_ends_of_what_covers_its_sample_and_holds_it(depth, expected):
    """Triangle 9 covers no sample at the first pixel, nor 7 at the third."""
    ours = {"depth": np.float32([depth])}
    assert by_hand().reach(ours, ours, exactly(ours["depth"]))["depth"].tolist() == [expected]


def test_a_wrong_one_lies_beyond_its_reach():
    """Within the reach of the right triangle, beside another one; and farther than that."""
    found = reach(depth=(0.375, 0.375, 0.5, 0.5), triangle=(9, 9, -1, -1))["depth"]
    assert found == [np.nextafter(0.125, -1), np.nextafter(0.125, -1), 0, 0]
    assert reach(depth=(0.625, 1, 1, 1))["depth"] == [0.25, 0.125, 0, 0]


def test_another_number_or_coverage_is_reached_where_it_is_right():
    found = reach(triangle=(9, -1, 7, 7), coverage=(1, 0, 1, 1), depth=(0.8125, 1, 0.125, 1))
    assert found["triangle"] == [2, 10, 8, 0] and found["coverage"] == [0, 1, 1, 0]
    assert reach(triangle=(8, 9, -1, -1))["triangle"] == [0, 0, 0, 0]


@pytest.mark.parametrize(
    ("buffers", "pieces"),
    [
        ({"triangle": (7, 9, -1, -1)}, [0, 1, -1, -1]),
        ({"triangle": (9, 7, 7, 9)}, [1, -1, 0, -1]),
        ({}, [-1, -1, -1, -1]),
        ({"coverage": (1, 1, 1, 1)}, [-1, -1, -1, -1]),
    ],
)
def test_which_piece_a_pixel_shows(buffers, pieces):
    """By its number; without it, where no pixel may show but one triangle: none of these."""
    given = {name: np.array([row], SEEN[name].dtype) for name, row in buffers.items()}
    assert by_hand().shown(given).tolist() == [pieces]


def test_without_numbers_a_piece_is_known_where_there_is_one_and_it_must_be_seen():
    alone = by_hand()
    alone = replace(alone, found=Candidates(*(column[2:] for column in alone.found)))
    certain = replace(alone, covered=np.uint8([[MUST_NOT, MUST, MUST, MUST_NOT]]))
    assert certain.several.tolist() == [[False] * 4] and alone.several.tolist() == [[False, True, True, False]]
    assert certain.shown({}).tolist() == [[-1, 1, 0, -1]]
    assert certain.shown({"coverage": np.uint8([[1, 0, 1, 1]])}).tolist() == [[-1, -1, 0, -1]]
    assert by_hand().several.tolist() == [[True, True, True, False]]


def test_of_two_pieces_of_a_triangle_that_with_an_area_and_the_sample_is_shown():
    """Piece 1 has no area; of 0 and 2 the one that covers the sample for the oracle counts."""
    found = Candidates(
        np.zeros(3, int), np.int32([0, 2, 1]), *[np.zeros(3)] * 2, np.array([True, False, True]), *[np.zeros(3)] * 2
    )
    boxes = SimpleNamespace(
        primitives=SimpleNamespace(triangle=np.int32([5, 5, 5])), drawable=np.array([True, False, True])
    )
    one = Visible(DRAW, boxes, found, np.uint8([[MUST]]))
    assert one.shown({"triangle": np.int32([[5]])}).tolist() == [[0]] and not one.several.any()
    flat = replace(one, boxes=SimpleNamespace(**vars(boxes) | {"drawable": np.array([False, False, True])}))
    assert flat.shown({"triangle": np.int32([[5]])}).tolist() == [[2]]
    none = replace(one, boxes=SimpleNamespace(**vars(boxes) | {"drawable": np.zeros(3, bool)}))
    assert none.shown({"triangle": np.int32([[5]])}).tolist() == [[-1]]
