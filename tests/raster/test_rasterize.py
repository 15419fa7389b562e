import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from raster_proof import assert_same_bits, check_scene, digest
from soups import soup

from sss_ref.raster.primitives import assemble
from sss_ref.raster.rasterize import bin_pieces, first_and_last, visibility, window_depth
from sss_ref.raster.viewport import Viewport


def draw(vertices, viewport, triangles=None):
    """The visible triangle and the depth of each pixel."""
    position = np.array(vertices, np.float32)
    corners = np.arange(len(position)) if triangles is None else np.array(triangles)
    attributes = np.zeros((len(position), 0), np.float32)
    primitives = assemble(position, attributes, corners.astype(np.int32).reshape(-1, 3), viewport)
    piece, depth = visibility(primitives, viewport, None)
    return np.append(primitives.triangle, np.int32(-1))[piece], depth


def sheet(z):
    """A triangle that covers the whole picture at one depth of normalised device coordinates."""
    return [(-1, -1, z, 1), (3, -1, z, 1), (-1, 3, z, 1)]


@pytest.mark.parametrize(
    ("depths", "expected"), [((1.5, 1.5, 1.5), 1), ((-0.5, -0.5, -0.5), 0), ((0, 0.5, 1), 0.625), ((1, 1, 1), 1)]
)
def test_a_depth_is_the_weighted_mean_held_to_0_and_1(depths, expected):
    assert window_depth((1.0, 1.0, 2.0), tuple(map(float, depths)), 4.0) == expected


def assert_same_picture(actual, expected):
    assert_same_bits(actual[0], expected[0])
    assert_same_bits(actual[1], expected[1])


@pytest.mark.parametrize("size", [(1, 1), (3, 5), (40, 70)])
def test_without_triangles_the_picture_is_cleared(size):
    triangle, depth = draw(np.zeros((0, 4)), Viewport(*size))
    assert_same_bits(triangle, np.full(size[::-1], -1, np.int32))
    assert_same_bits(depth, np.ones(size[::-1], np.float32))


def test_one_pixel():
    triangle, depth = draw([(-1, -1, 0, 1), (1, -1, 0, 1), (0, 1, 0, 1)], Viewport(1, 1))
    assert triangle.tolist() == [[0]] and depth.tolist() == [[0.5]]


def test_depth_by_hand():
    _, depth = draw([(-1, -1, -1, 1), (1, -1, 1, 1), (-1, 1, -1, 1)], Viewport(4, 4))
    # depth = window x / 4 at the pixel centres; the hypotenuse is no left edge
    one = np.float32(1)
    assert depth.tolist() == [[0.125, 0.375, 0.625, one], [0.125, 0.375, one, one], [0.125, one, one, one], [one] * 4]


def test_on_a_tie_the_earlier_triangle_wins():
    triangle, _ = draw(sheet(0), Viewport(3, 3), [(0, 1, 2), (2, 1, 0), (1, 2, 0)])
    assert (triangle == 0).all()


def test_first_and_last_are_those_of_the_order_and_of_the_reverse(crowd):
    primitives, viewport = crowd
    flat = primitives._replace(depth=np.zeros_like(primitives.depth))
    reverse = flat._replace(corners=flat.corners[::-1], triangle=flat.triangle[::-1])
    count = len(flat.corners)
    for drawn, backwards in ((flat, reverse), (primitives, None)):
        first, last, depth = first_and_last(drawn, viewport, None)
        assert_same_picture((first, depth), visibility(drawn, viewport, None))
        expected = first if backwards is None else count - 1 - visibility(backwards, viewport, None)[0]
        assert_same_bits(last, np.where(first < 0, np.int32(-1), expected).astype(np.int32))
    assert (first_and_last(flat, viewport, None)[0] != first_and_last(flat, viewport, None)[1]).any()


def test_the_nearer_triangle_wins_whatever_the_order():
    for order in ((0, -0.5, 0.5), (-0.5, 0.5, 0), (0.5, 0, -0.5)):
        triangle, depth = draw([vertex for z in order for vertex in sheet(z)], Viewport(3, 3))
        assert (triangle == order.index(-0.5)).all() and (depth == 0.25).all()


def test_at_the_far_plane_nothing_passes_the_depth_test():
    assert (draw(sheet(1), Viewport(2, 2))[0] == -1).all()


def test_depths_that_round_to_the_same_float32_tie():
    viewport = Viewport(1, 1)
    position = np.array([(-1, -1, 0, 1), (1, -1, 0, 1), (0, 1, 0, 1)] * 2, np.float32)
    corners = np.arange(6, dtype=np.int32).reshape(2, 3)
    primitives = assemble(position, np.zeros((6, 0), np.float32), corners, viewport)
    primitives.depth[3] = np.nextafter(np.float32(0.5), np.float32(0))  # weighs 1/4 of half a ulp: rounded away
    piece, depth = visibility(primitives, viewport, None)
    assert piece.tolist() == [[0]] and depth.tolist() == [[0.5]]


def test_depth_is_clamped():
    viewport = Viewport(2, 2)
    position, triangles = np.array(sheet(0), np.float32), np.array([[0, 1, 2]], np.int32)
    flat = assemble(position, np.zeros((3, 0), np.float32), triangles, viewport)
    below = flat._replace(depth=np.full_like(flat.depth, -0.25))
    assert_same_bits(visibility(below, viewport, None)[1], np.zeros((2, 2), np.float32))


@pytest.fixture(scope="module")
def crowd():
    viewport = Viewport(150, 131)
    return assemble(*soup(21, 3000, Viewport(128, 128)), viewport), viewport


@pytest.mark.parametrize("threads", [1, 2, 4])
def test_bits_do_not_depend_on_the_number_of_threads(crowd, threads):
    expected = visibility(*crowd, None)
    with ThreadPoolExecutor(threads) as pool:
        assert_same_picture(visibility(*crowd, pool), expected)


@pytest.mark.parametrize("band_rows", [1, 7, 64, 1000])
def test_bits_do_not_depend_on_the_bands(crowd, band_rows):
    with ThreadPoolExecutor(2) as pool:
        drawn = visibility(*crowd, pool, bin_pieces(*crowd, band_rows))
        assert_same_picture(drawn, visibility(*crowd, None))


@pytest.mark.parametrize(
    "viewport", [Viewport(70, 3), Viewport(16384, 2), Viewport(5, 90, subpixel_bits=4), Viewport(33, 65, 1)]
)
def test_equals_the_naive_rasterizer_in_odd_pictures(viewport):
    counts = check_scene(soup(5, 90, viewport), viewport)
    assert counts["fragments"] > 300


def test_the_same_bits_without_the_compiler():
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": os.pathsep.join(sys.path)}
    program = "from raster_proof import digest; print(digest())"
    command = [sys.executable, "-W", "error::RuntimeWarning", "-c", program]
    finished = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert finished.stdout.strip() == digest()
