"""The boxes around vertices: no wider than what each reason by itself allows, worked out by hand."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scenes import around, cube, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language import vec2
from sss_ref.numerics.interval import Interval
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.rasterizer import boxes
from sss_ref.validation.accept.rasterizer.boxes import boxes_of, same_places

EVERYWHERE = 2.0**40


def piece_of(*corners, triangle=None):
    number = np.arange(len(corners)) if triangle is None else np.array(triangle)
    return SimpleNamespace(corners=np.array(corners), triangle=number)


def test_a_division_by_w_may_be_off():
    clip = np.float32([(2, -4, 1, 2), (1, 0, 1, 2), (1, 1, 1, 0), (1, 1, 1, -1), (3, 3, 3, 2)])
    error = np.array([(0.1, 0.2, 0.3, 0.5), (0, 0, 0, 2), (1, 1, 1, 0), (0, 0, 0, 0), (0, 0, 0, 0)])
    ndc, off, weight = boxes._divided(clip, error)
    assert ndc.tolist() == [[1, -2, 0.5], [0.5, 0, 0.5], [0, 0, 0], [0, 0, 0], [1.5, 1.5, 1.5]]
    assert np.allclose(off[0], [0.6 / 1.5, 1.2 / 1.5, 0.55 / 1.5], rtol=1e-15, atol=0)
    assert off[1:].tolist() == [[np.inf] * 3, [0] * 3, [0] * 3, [0] * 3]
    assert weight.tolist() == [0.5 / 1.5, np.inf, 0, 0, 0]


def test_how_far_a_vertex_is_from_the_pictures_corner():
    """What is cut at the near or far plane, or at the eye, may be as far as the guard band."""
    band = 2.0**15
    placed = np.float32([(0, 0, 1, 1), (0, 0, -1, 1), (0, 0, 1.5, 1), (0, 0, -1.5, 1), (0, 0, 0, 0), (0, 0, 0, -1)])
    centre = np.tile([(-3.0, 1e6)], (6, 1))
    assert boxes._extent(centre, placed).tolist() == [[3, band]] * 2 + [[band, band]] * 4


def test_the_attributes_of_what_is_cut_are_as_uncertain_as_any():
    error = np.array([(1.0, 2.0), (3.0, 0.5)])
    assert boxes._of_all(error, None, 4).tolist() == [[1, 2], [3, 0.5], [3, 2], [3, 2]]
    assert boxes._of_all(error, None, 2).tolist() == error.tolist()
    assert boxes._of_all(error / 8, None, 3)[2].tolist() == [0.375, 0.25]


def test_how_far_an_interval_lies_from_a_value():
    low, high = np.array([1.0, -2.0, -np.inf]), np.array([4.0, 5.0, np.inf])
    ours = np.float32([(2, 9), (4, 9), (np.inf, 9)])
    nine = Interval(np.float64(8.5), np.float64(9.0))
    assert boxes._distance(vec2(Interval(low, high), nine), ours).tolist() == [[2, 0.5], [6, 0.5], [np.inf, 0.5]]


def test_a_cut_corner_is_as_uncertain_as_its_triangle_and_rounded():
    """Vertices 3 and 4 came where triangles were cut."""
    error = np.array([(0.1, 0, 0, 0), (0, 0.2, 0, 0), (0, 0, 0.3, 0.4)])
    placed = np.float32([(1, 1, 1, 1), (0, 2, 0, 1), (1, 1, 1, 1), (-16, 0, 0, 1), (0, 0, 0, 4)])
    pieces, given = piece_of((0, 1, 3), (0, 3, 4)), np.array([(0, 1, 2), (0, 1, 1)])
    found = boxes._with_cut_errors(error, pieces, given, placed)
    assert np.array_equal(found[:3], error)
    cut = 16 * 2.0**-20
    assert np.allclose(found[3], [0.1 + cut, 0.2 + cut, 0.3 + cut, 0.4 + cut], rtol=1e-15, atol=0)
    assert np.allclose(found[4], [0.1 + cut, 0.2 + cut, cut, cut], rtol=1e-15, atol=0)


def test_a_plane_that_cuts_elsewhere_moves_a_corner():
    """Depth grows by 1/8 a pixel to the right and by 1/4 upwards; the corner at 1 is cut."""
    centre = np.array([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (9.0, 9.0)])
    depth, error = np.array([0.0, 0.5, 1.0, -1.0]), np.array([2.0**-7, 2.0**-6, 2.0**-8, 2.0**-9])
    far = 2.0**-6 / np.hypot(1 / 8, 1 / 4)
    assert np.allclose(boxes._moves_of_cuts(piece_of((0, 1, 2)), centre, depth, error), [0, 0, far, 0], 1e-14, 0)
    turned = piece_of((2, 1, 0))
    assert np.allclose(boxes._moves_of_cuts(turned, centre, depth, error), [0, 0, far, 0], 1e-14, 0)


def test_only_corners_that_may_lie_on_a_plane_move():
    centre, error = np.array([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)]), np.full(3, 2.0**-6)
    depth = np.array([-1 + 2.0**-6, 1 - 2.0**-6, 1 - 2.0**-5])
    moves = boxes._moves_of_cuts(piece_of((0, 1, 2)), centre, depth, error)
    assert (moves > 0).tolist() == [True, True, False]


def test_the_gradient_is_that_of_the_largest_piece():
    """Two pieces of triangle 1, the smaller one steep; and one of triangle 0, which is flat and cut nowhere."""
    centre = np.array([(0.0, 0.0), (8.0, 0.0), (0.0, 8.0), (0.0, 1.0), (20.0, 0.0), (24.0, 0.0), (20.0, 4.0)])
    depth, error = np.array([1.0, 0.5, 1.0, 0.0, -1.0, -1.0, -1.0]), np.full(7, 2.0**-6)
    for pieces in (
        piece_of((4, 5, 6), (0, 1, 2), (0, 1, 3), triangle=(0, 1, 1)),
        piece_of((4, 5, 6), (0, 1, 3), (0, 1, 2), triangle=(0, 1, 1)),
    ):
        moves = boxes._moves_of_cuts(pieces, centre, depth, error)
        assert moves[[0, 1, 2, 3]].tolist() == [2.0**-6 * 16, 0, 2.0**-6 * 16, 0]
        assert (moves[4:] >= EVERYWHERE).all()  # it may be cut anywhere


def test_vertices_at_one_place_have_one_number():
    clip = np.float32([(1, 2, 3, 4), (1, 2, 3, 5), (1, 2, 3, 4)])
    numbers = same_places(clip)
    assert numbers.dtype == np.int64 and numbers[0] == numbers[2] != numbers[1]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("cube") / "cube.obj", *cube())
    return load_scene(around(path, 64), **{"camera.width": 48, "camera.distance": 9.0})


EXACT = PROFILES["ieee"]
ROUNDED = 2.0**-22


@pytest.mark.parametrize("profile", [EXACT, replace(EXACT, snap="any"), replace(EXACT, subpixel_bits=4)])
def test_of_exact_arithmetic_the_snap_and_the_viewport_are_left(scene, profile):
    this_pass = scene.method["camera"]
    found = boxes_of(scene, this_pass, {}, profile)
    positions = np.column_stack([scene.mesh.attributes["position"].astype(np.float64), np.ones(len(found.centre))])
    clip = positions @ scene.uniforms["camera_clip_from_model"].astype(np.float64).T
    ndc, size, step = clip[:, :2] / clip[:, 3:], np.array([24, 32]), 2.0**-profile.subpixel_bits
    assert np.allclose(found.centre, (ndc + 1) * size - 0.5, rtol=0, atol=1e-4)  # that of the stage is in float32
    rounding = (np.abs((found.centre + 0.5) / size - 1) + 1) * ROUNDED * size
    moved = np.abs(found.primitives.snapped * step - found.centre)
    if profile.snap == "any":
        half, off = rounding + step, moved + rounding + step
    else:
        half = rounding + step / 2
        off = np.where(moved > step / 2 - rounding, step, moved) + rounding
    assert np.allclose(found.half, half, rtol=1e-9, atol=0) and np.allclose(found.off, off, rtol=1e-9, atol=0)
    farthest = np.abs(found.centre)[scene.mesh.triangles].max(axis=1)
    assert np.allclose(found.rounding, ROUNDED * (2 * size + farthest), rtol=1e-12, atol=0)
    assert np.all(found.depth_error == ROUNDED) and not found.weight_error.any() and not found.attribute_error.any()


def test_a_vertex_that_may_be_at_the_eye_may_be_anywhere(scene):
    near = replace(PROFILES["mediump"], subpixel_bits=8)
    found = boxes_of(scene, scene.method["camera"], {}, near)
    assert (found.half < EVERYWHERE).all() and (found.depth_error > ROUNDED).all() and (found.weight_error > 0).all()
    assert (found.attribute_error > 0).any()


def test_what_is_cut_snaps_elsewhere(scene):
    """A cube of which the near plane cuts off all but what lies behind; each vertex that comes of it."""
    cut_open = load_scene(scene.settings.model_dump(), **{"camera.near": 9.0})
    found = boxes_of(cut_open, cut_open.method["camera"], {}, EXACT)
    given, step = len(cut_open.mesh.attributes["position"]), 2.0**-EXACT.subpixel_bits
    assert len(found.centre) > given and (found.off[given:] >= step).all() and (found.off[:given] < step).any()
    assert (found.half[given:] > step / 2).all() and np.isfinite(found.half).all()
