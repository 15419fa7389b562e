"""Rows from arrays and into arrays, and what a draw interpolates: each function beside a loop over fragments."""

import numpy as np
import pytest

from sss_ref.interpret.kernel import fragment_rows
from sss_ref.interpret.kernel.modules import address_of
from sss_ref.interpret.kernel.program import STRIP, Program, run

F = np.float32
STEP = 16  # snapped units a pixel
INDICES = {
    "one": [5],
    "side by side": range(3, 20),
    "a hole": [3, 4, 6, 7],
    "a hole at the end": [0, 1, 3],
    "every other": range(1, 30, 2),
}
PLACES = [(3, 0, 3), (1, 0, 1), (2, 0, 2), (4, 1, 3), (5, 3, 2), (3, 0, 2)]  # columns, first column, values


def ran(function, given, results, uniforms=(), tables=()):
    """The rows of results, int32 (results, N), when a function of rows gets the rows given, 32 bits each."""
    program, count = Program(), len(given[0])
    rows = [*program.rows(len(given)), *results_at(program, results)]
    numbers = [program.address(each) if isinstance(each, np.ndarray) else each for each in tables]
    program.add(address_of(function), rows, [np.asarray(uniforms).view(F)] if len(uniforms) else [], numbers)
    scratch = np.full((program.used, STRIP), F(np.nan))
    for row, values in zip(rows, given, strict=False):
        scratch[row, :count] = np.asarray(values).view(F)
    before = scratch.copy()
    run(program.calls, scratch.reshape(-1), count)
    written = rows[len(given) : len(given) + results]
    apart = [row for row in range(program.used) if row not in rows[len(given) :]]
    assert scratch[apart].tobytes() == before[apart].tobytes(), "a row that is not the function's"
    assert scratch[written, count:].tobytes() == before[written, count:].tobytes(), "a value behind the strip"
    return scratch.view(np.int32)[written, :count]


def results_at(program, results):
    """Rows in another order than they lie in, then a block for a pack of values."""
    return [*reversed(program.rows(results)), *program.block(fragment_rows.PACK)[:1]]


def index_of(name):
    return np.array([*INDICES[name]], np.int32)


def words(count, columns, seed=1):
    """Bits of any kind but those of what is no number, which a row need not keep."""
    return np.random.default_rng(seed).integers(-(2**30), 2**30, (count, columns)).astype(np.int32)


@pytest.mark.parametrize(
    ("name", "begin"), [("one", 5), ("side by side", 3), ("a hole", -1), ("a hole at the end", -1), ("every other", -1)]
)
def test_what_lies_side_by_side_has_a_beginning(name, begin):
    scratch = np.concatenate([words(4, 1)[:, 0], index_of(name)]).view(F)
    assert fragment_rows.beginning(scratch, len(INDICES[name]), 4) == begin


@pytest.mark.parametrize(("columns", "first", "channels"), PLACES)
@pytest.mark.parametrize("name", INDICES)
def test_words_are_taken_and_put(name, columns, first, channels):
    index, array = index_of(name), words(30, columns)
    table = [array, columns, first, channels]
    taken = ran(fragment_rows.take_words, [index], channels, tables=table)
    wanted = [[array[at, first + channel] for at in index] for channel in range(channels)]
    assert taken.tolist() == np.array(wanted).tolist()
    target, expected = words(30, columns, 2), words(30, columns, 2)
    for k, at in enumerate(index):
        for channel in range(channels):
            expected[at, first + channel] = wanted[channel][k]
    ran(fragment_rows.put_words, [index, *taken], 0, tables=[target, *table[1:]])
    assert target.tolist() == expected.tolist()


@pytest.mark.parametrize("name", INDICES)
def test_truth_values_are_taken_and_put(name):
    index, array = index_of(name), np.random.default_rng(3).integers(0, 2, 30).astype(np.uint8)
    (taken,) = ran(fragment_rows.take_bytes, [index], 1, tables=[array])
    assert taken.tolist() == [array[at] for at in index]
    target, expected = np.full(30, 9, np.uint8), np.full(30, 9, np.uint8)
    flags = np.resize(np.array([0, 1, -1, 256, 2], np.int32), len(index))
    expected[index] = flags != 0
    ran(fragment_rows.put_bytes, [index, flags], 0, tables=[target])
    assert target.tolist() == expected.tolist()


@pytest.mark.parametrize(("columns", "first", "channels"), [(2, 0, 2), (5, 3, 2)])
@pytest.mark.parametrize("name", ["one", "a hole", "side by side"])
def test_whole_numbers_are_kept_as_floats(name, columns, first, channels):
    index, array = index_of(name), np.random.default_rng(4).integers(-99, 99, (30, columns)).astype(F)
    taken = ran(fragment_rows.take_whole, [index], channels, tables=[array, columns, first, channels])
    assert taken.tolist() == [[int(array[at, first + channel]) for at in index] for channel in range(channels)]
    target, expected = np.full((30, columns), F(0.5)), np.full((30, columns), F(0.5))
    expected[index, first : first + channels] = array[index, first : first + channels]
    ran(fragment_rows.put_whole, [index, *taken], 0, tables=[target, columns, first, channels])
    assert target.tolist() == expected.tolist()


@pytest.mark.parametrize(("columns", "first", "channels"), PLACES)
@pytest.mark.parametrize("name", INDICES)
def test_a_background_is_put(name, columns, first, channels):
    index, values = index_of(name), words(1, channels, 5)[0]
    target, expected = words(30, columns, 2), words(30, columns, 2)
    expected[index, first : first + channels] = values
    ran(fragment_rows.clear_words, [index], 0, values, [target, columns, first, channels])
    assert target.tolist() == expected.tolist()


@pytest.mark.parametrize(("value", "kept"), [(0, 0), (1, 1), (-2, 1)])
@pytest.mark.parametrize("name", INDICES)
def test_a_background_of_truth_values_is_put(name, value, kept):
    index, target, expected = index_of(name), np.full(30, 9, np.uint8), np.full(30, 9, np.uint8)
    expected[index] = kept
    ran(fragment_rows.clear_bytes, [index], 0, np.array([value], np.int32), [target])
    assert target.tolist() == expected.tolist()


def test_one_value_for_all():
    program = Program()
    (row,) = program.rows(1)
    program.add(address_of(fragment_rows.same), [row], [np.array([-7], np.int32).view(F)])
    scratch = np.zeros((program.used, STRIP), np.int32)
    run(program.calls, scratch.reshape(-1).view(F), 5)
    assert scratch[row, :6].tolist() == [-7] * 5 + [0]


def test_the_triangle_of_a_fragment_is_that_of_its_piece():
    piece, triangles = np.array([4, 0, 3, 3, 1], np.int32), np.array([10, 11, 12, 13, 14], np.int32)
    (found,) = ran(fragment_rows.triangle, [index_of("a hole") - 3], 1, tables=[piece, triangles])
    assert found.tolist() == [14, 10, 13, 11]


CORNERS = np.array([(0, 1, 2), (2, 1, 0), (3, 1, 4), (5, 6, 7)], np.int32)  # the first two: one triangle, both ways
SNAPPED = np.array(
    [(-20, -7), (170, 3), (40, 181), (165, 190), (16, 150), (0, 0), (32, 0), (0, 32)], np.int32
)  # of the last piece, pixel 1,0 is on an edge, and 0,2 is a corner


@pytest.mark.parametrize("seed", range(3))
def test_weights_are_the_edge_functions_over_w(seed):
    """Each corner's: twice the area of the triangle that the pixel's centre makes with the two others (rule R5)."""
    rng = np.random.default_rng(seed)
    inverse_w = rng.uniform(0.1, 3, len(SNAPPED)).astype(F)
    piece = np.resize(np.array([0, 1, 2, 3], np.int32), 12 * 12)
    index = np.sort(rng.choice(144, 40, replace=False)).astype(np.int32)
    index[:3] = 1, 24, 27  # pixels that are on an edge of their piece or at its corner come first
    piece[index[:3]] = 3
    column, row = index % 12, index // 12
    tables = [piece, CORNERS, SNAPPED, inverse_w, STEP]
    found = ran(fragment_rows.weights, [index, column, row], 7, tables=tables)
    for k, at in enumerate(index):
        corners = CORNERS[piece[at]]
        assert found[:3, k].tolist() == corners.tolist()
        expected = naive_weights(corners, (int(column[k]) * STEP, int(row[k]) * STEP), inverse_w)
        assert found[3:, k].view(F).tobytes() == expected.tobytes(), k


def naive_weights(corners, sample, inverse_w):
    """Three weights and their sum, the areas as whole numbers; those of a triangle that turns the other way negated."""
    places = [[int(end) - start for end, start in zip(SNAPPED[corner], sample, strict=True)] for corner in corners]
    areas = []
    for number in range(3):
        (bx, by), (cx, cy) = places[(number + 1) % 3], places[(number + 2) % 3]
        areas.append(bx * cy - by * cx)
    turn = -1 if sum(areas) < 0 else 1
    a, b, c = (F(turn * area) * inverse_w[corner] for area, corner in zip(areas, corners, strict=True))
    return np.array([a, b, c, (a + b) + c], F)


def attributes_of(columns, count=9):
    rng = np.random.default_rng(columns)
    vertices = rng.normal(size=(6, columns)).astype(F)
    corners = rng.integers(0, 6, (3, count)).astype(np.int32)
    weights = rng.uniform(0, 1e4, (3, count)).astype(F)
    return vertices, [*corners, *weights, (weights[0] + weights[1]) + weights[2]]


def naive_mixed(vertices, given, column):
    """What the corners have, each times its weight, over the sum of the weights, rounded after every step."""
    a, b, c, weight_a, weight_b, weight_c, total = given
    sums = vertices[a, column] * weight_a + vertices[b, column] * weight_b
    return (sums + vertices[c, column] * weight_c) / total


@pytest.mark.parametrize(("columns", "first", "channels"), [(1, 0, 1), (5, 0, 5), (11, 8, 3), (10, 8, 1)])
def test_columns_are_interpolated_one_by_one(columns, first, channels):
    vertices, given = attributes_of(columns)
    found = ran(fragment_rows.varying, given, channels, tables=[vertices, columns, first, channels])
    for channel in range(channels):
        assert found[channel].view(F).tobytes() == naive_mixed(vertices, given, first + channel).tobytes()


@pytest.mark.parametrize(("columns", "first"), [(8, 0), (16, 8), (19, 8)])
def test_columns_are_interpolated_in_packs(columns, first):
    vertices, given = attributes_of(columns)
    found = ran(fragment_rows.varying_pack, given, 8, tables=[vertices, columns, first, 8])
    for channel in range(8):
        assert found[channel].view(F).tobytes() == naive_mixed(vertices, given, first + channel).tobytes()


def test_a_weighted_mean_by_hand():
    """(1*2 + 2*3 + 4*5)/10 = 2.8."""
    found = fragment_rows.mixed((F(1), F(2), F(4)), (F(2), F(3), F(5)), F(10))
    assert found == F(2.8)
