"""The comparison of the package with the naive rasterizer, scene by scene and in every bit."""

import hashlib
from collections import Counter

import naive_raster
import numpy as np
from soups import soup

from sss_ref.interpret.kernel import fragment_rows
from sss_ref.interpret.kernel.modules import address_of
from sss_ref.interpret.kernel.program import COLUMN, INDEX, ROW, STRIP, Program, run
from sss_ref.raster.interpolate import interpolate_arrays
from sss_ref.raster.primitives import assemble
from sss_ref.raster.rasterize import visibility
from sss_ref.raster.viewport import Viewport


def assert_same_bits(actual, expected):
    assert actual.dtype == expected.dtype and actual.shape == expected.shape
    assert np.ascontiguousarray(actual).tobytes() == np.ascontiguousarray(expected).tobytes()


def interpolate_compiled(primitives, piece, column, row, step):
    """Rule R5 as kernels have it, on N fragments anywhere: every attribute, float32 (N, A)."""
    return by_rows(primitives, piece, column, row, step)[1]


def weights_compiled(primitives, piece, column, row, step):
    """The weights of N fragments as kernels have them, float32 (3, N)."""
    return by_rows(primitives, piece, column, row, step)[0]


def by_rows(primitives, piece, column, row, step):
    """Weights and attributes of N fragments, strip after strip."""
    channels, count = primitives.attributes.shape[1], len(piece)
    weights, values = np.empty((3, count), np.float32), np.empty((count, channels), np.float32)
    for first in range(0, count, STRIP):
        strip = slice(first, first + STRIP)
        program, rows = rows_of_a_strip(primitives, np.ascontiguousarray(piece[strip], np.int32), step)
        scratch = np.zeros((program.used, STRIP), np.float32)
        numbers, here = scratch.view(np.int32), len(piece[strip])
        numbers[INDEX, :here], numbers[COLUMN, :here], numbers[ROW, :here] = np.arange(here), column[strip], row[strip]
        run(program.calls, scratch.reshape(-1), here)
        weights[:, strip], values[strip] = scratch[rows[3:6], :here], scratch[rows[7:], :here].T
    return weights, values


def rows_of_a_strip(primitives, piece, step):
    """The program that fills the rows of `weights` and `varying`, and the numbers of these rows."""
    program, channels = Program(), primitives.attributes.shape[1]
    rows = program.rows(7 + channels)
    arrays = (piece, primitives.corners, primitives.snapped, primitives.inverse_w)
    tables = [*(program.address(array) for array in arrays), step]
    program.add(address_of(fragment_rows.weights), [INDEX, COLUMN, ROW, *rows[:7]], tables=tables)
    tables = [program.address(primitives.attributes), channels, 0, channels]
    program.add(address_of(fragment_rows.varying), rows, tables=tables)
    return program, rows


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
