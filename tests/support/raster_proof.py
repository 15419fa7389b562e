"""The comparison of the package with the naive rasterizer, scene by scene and in every bit."""

import hashlib
from collections import Counter

import naive_raster
import numba
import numpy as np
from soups import soup

from sss_ref.raster.interpolate import barycentric, interpolate_arrays
from sss_ref.raster.primitives import assemble
from sss_ref.raster.rasterize import visibility
from sss_ref.raster.viewport import Viewport


def assert_same_bits(actual, expected):
    assert actual.dtype == expected.dtype and actual.shape == expected.shape
    assert np.ascontiguousarray(actual).tobytes() == np.ascontiguousarray(expected).tobytes()


@numba.njit(error_model="numpy")
def interpolate_compiled(primitives, piece, column, row, step):
    """Rule R5 with the compiled weights, in the form in which the kernels of a pass contain it."""
    values = np.empty((len(piece), primitives.attributes.shape[1]), np.float32)
    for k in range(len(piece)):
        wa, wb, wc = barycentric(primitives, piece[k], column[k], row[k], step)
        a, b, c = primitives.corners[piece[k]]
        varying = primitives.attributes
        for attribute in range(values.shape[1]):
            total = (varying[a, attribute] * wa + varying[b, attribute] * wb) + varying[c, attribute] * wc
            values[k, attribute] = total / ((wa + wb) + wc)
    return values


def draw_naively(scene, viewport):
    """Every triangle of a scene by itself: a list of naive_raster.Drawn, pieces numbered through."""
    position, attributes, triangles = scene
    vertices = [list(row) for row in np.concatenate([position, attributes], axis=1)]
    drawn, pieces = [], 0
    with np.errstate(all="ignore"):
        for corners in triangles:
            triangle = [vertices[corner] for corner in corners]
            drawn.append(naive_raster.draw(triangle, viewport.width, viewport.height, viewport.subpixel_bits, pieces))
            pieces += len(drawn[-1].pieces)
    return drawn


def check_primitives(primitives, drawn):
    """The same pieces, from the same triangles, with the same corners."""
    triangle = [number for number, each in enumerate(drawn) for _ in each.pieces]
    corners = [corner for each in drawn for piece in each.pieces for corner in piece]
    used = primitives.corners.reshape(-1)
    assert_same_bits(primitives.triangle, np.array(triangle, np.int32))
    assert_same_bits(primitives.snapped[used], np.array([(c.x, c.y) for c in corners], np.int32).reshape(-1, 2))
    assert_same_bits(primitives.depth[used], np.array([c.depth for c in corners], np.float32))
    assert_same_bits(primitives.inverse_w[used], np.array([c.inverse_w for c in corners], np.float32))
    attributes = np.array([c.attributes for c in corners], np.float32).reshape(len(used), -1)
    assert_same_bits(primitives.attributes[used].reshape(len(used), -1), attributes)


def check_attributes(primitives, drawn, viewport):
    """Attributes at every fragment, visible or not, as array code and compiled."""
    fragments = [fragment for each in drawn for fragment in each.fragments]
    if not fragments:
        return
    where = np.array([(f.piece, f.column, f.row) for f in fragments]).T
    expected = np.array([f.attributes for f in fragments], np.float32)
    assert_same_bits(interpolate_arrays(primitives, *where, viewport.step), expected)
    assert_same_bits(interpolate_compiled(primitives, *where, viewport.step), expected)


def check_picture(picture, fragments, viewport):
    """The same visible piece and the same depth in every pixel."""
    expected = naive_raster.resolve(fragments, viewport.width, viewport.height)
    piece = np.array([[-1 if f is None else f.piece for f in row] for row in expected], np.int32)
    depth = np.array([[1 if f is None else f.depth for f in row] for row in expected], np.float32)
    assert_same_bits(picture[0], piece)
    assert_same_bits(picture[1], depth)


def check_each_triangle(primitives, drawn, viewport):
    """Draw every triangle by itself, so that none hides another."""
    first = 0
    for each in drawn:
        last = first + len(each.pieces)
        alone = primitives._replace(corners=primitives.corners[first:last], triangle=primitives.triangle[first:last])
        piece, depth = visibility(alone, viewport, None)
        check_picture((np.where(piece >= 0, piece + np.int32(first), piece), depth), each.fragments, viewport)
        first = last


def check_scene(scene, viewport):
    """Hold the package to the naive rasterizer; count triangles, those on an edge and those each plane crosses."""
    drawn = draw_naively(scene, viewport)
    primitives = assemble(*scene, viewport)
    check_primitives(primitives, drawn)
    check_attributes(primitives, drawn, viewport)
    check_each_triangle(primitives, drawn, viewport)
    fragments = [fragment for each in drawn for fragment in each.fragments]
    check_picture(visibility(primitives, viewport, None), fragments, viewport)
    counts = Counter(triangles=len(drawn), fragments=len(fragments), on_edge=sum(each.on_edge for each in drawn))
    counts.update(plane for each in drawn for plane in each.planes)
    return counts


def digest():
    """A hash of everything the rasterizer computes for a small scene."""
    viewport = Viewport(16, 40)
    primitives = assemble(*soup(8, 60, viewport), viewport)
    piece, depth = visibility(primitives, viewport, None)
    row, column = np.nonzero(piece >= 0)
    values = interpolate_arrays(primitives, piece[row, column], column, row, viewport.step)
    return hashlib.sha256(b"".join(array.tobytes() for array in (piece, depth, values, *primitives))).hexdigest()
