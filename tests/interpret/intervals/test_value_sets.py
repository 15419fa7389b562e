"""What a fetch may give and sets joined: each element beside a loop over all that an index may mean."""

import numpy as np
import pytest

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.interpret.intervals.value_sets import Texels, anything_where, computable, fetched, joined, picked
from sss_ref.interpret.intervals.watching import Watching
from sss_ref.language.types import components, ivec2, vec2, vec3, vec4
from sss_ref.numerics.interval import Interval, point

SHAPE = (4, 5)
ANYTHING = {"f": (-np.inf, np.inf), "i": (-(2**31), 2**31 - 1), "b": (False, True)}


def stored(kind, channels):
    """The least and the most of each element: numbers that grow along neither axis."""
    rng = np.random.default_rng(6)
    shape = SHAPE if channels == 1 else (*SHAPE, channels)
    if kind == "b":
        low = rng.integers(0, 2, shape).astype(np.uint8)
        return low, low
    low = rng.integers(-50, 50, shape).astype(np.float32 if kind == "f" else np.int32)
    return low, low + low.dtype.type(3)


def indices(span):
    """Intervals along an axis, some of them outside, by up to a span."""
    rng = np.random.default_rng(7 + span)
    first = rng.integers(-2, 6, 300)
    return Interval(first, first + rng.integers(0, span + 1, 300))


def naive(low, high, rows, columns):
    """The least and the most of all elements that are meant; None of any, as where four are side by side."""
    inside = rows[0] >= 0 and rows[1] < SHAPE[0] and columns[0] >= 0 and columns[1] < SHAPE[1]
    if not inside or rows[1] - rows[0] > 2 or columns[1] - columns[0] > 2:
        return None
    places = [(row, column) for row in range(rows[0], rows[1] + 1) for column in range(columns[0], columns[1] + 1)]
    return min(low[place] for place in places), max(high[place] for place in places)


@pytest.mark.parametrize("kind", ["f", "i", "b"])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize("span", [0, 1, 4])
def test_a_fetch_gives_what_any_element_holds_that_is_meant(kind, channels, span):
    low, high = stored(kind, channels)
    rows, columns = indices(span), indices(span + 1 if span else 0)
    value, several = fetched(low, high, [rows, columns])
    parts = components(value)
    assert len(parts) == channels and (channels == 1 or type(value) is {2: vec2, 3: vec3, 4: vec4}[channels])
    for k in range(300):
        at = (rows.low[k], rows.high[k]), (columns.low[k], columns.high[k])
        expected = [
            naive(low[..., c], high[..., c], *at) if channels > 1 else naive(low, high, *at) for c in range(channels)
        ]
        found = [(part.low[k], part.high[k]) for part in parts]
        assert found == [ANYTHING[kind] if each is None else each for each in expected], k
        of_one = rows.low[k] == rows.high[k] and columns.low[k] == columns.high[k]
        if expected[0] is not None and not of_one:
            assert np.broadcast_to(several, 300)[k] == any(a != b for a, b in expected)
        elif of_one:
            assert not np.broadcast_to(several, 300)[k]


def test_an_index_of_a_table_has_one_axis():
    table = np.array([3, 1, 4, 1, 5], np.float32)
    value, several = fetched(table, table, [Interval(np.array([0, 1, 3, -1, 5]), np.array([0, 3, 4, 0, 5]))])
    assert value.low.tolist() == [3, 1, 1, -np.inf, -np.inf] and value.high.tolist() == [3, 4, 5, np.inf, np.inf]
    assert several.tolist()[:3] == [False, True, True]
    same, several = fetched(table, table, [point(np.array([4, 0]))])
    assert same.is_point and same.low.tolist() == [5, 3] and not several


def test_numbers_are_computed_in_64_bits_and_bytes_are_truth_values():
    assert computable(np.uint8([0, 1, 2])).tolist() == [False, True, True]
    assert [computable(np.array([1], dtype)).dtype for dtype in ("f4", "i4", "?")] == [np.float64, np.int64, np.bool_]
    assert Texels(np.zeros(1), np.zeros(1)).span == 0


@pytest.mark.parametrize(("dtype", "ends"), [("f8", ANYTHING["f"]), ("i8", ANYTHING["i"]), ("?", ANYTHING["b"])])
def test_anything_of_a_type(dtype, ends):
    given = Interval(np.array([1, 0], dtype), np.array([1, 1], dtype))
    found = anything_where(np.array([True, False]), given)
    assert (found.low[0], found.high[0]) == ends and (found.low[1], found.high[1]) == (0, 1)
    assert anything_where(np.array([False, False]), given) is given


def test_some_of_the_fragments():
    value = vec2(Interval(np.arange(3.0), np.arange(3.0) + 1), point(np.float64(7)))
    found = picked(value, np.array([True, False, True]))
    assert found.x.low.tolist() == [0, 2] and found.x.high.tolist() == [1, 3] and found.y.low == 7
    assert picked("a table", slice(0, 1)) == "a table"


@pytest.mark.parametrize("where", [np.array([False, True, True, True, True]), np.True_])
def test_joined_values_are_apart_where_nothing_lies_in_both(where):
    """From 2 to 3, with others: above, touching from above, touching from below, below."""
    there = np.broadcast_to(where, 5)
    others = np.array([(9.0, 9.0), (4, 5), (3, 4), (1, 2), (0, 1)])[there].T
    value, apart = joined(Interval(np.full(5, 2.0), np.full(5, 3.0)), where, Interval(*others))
    assert value.low.tolist() == [2, 2, 2, 1, 0] and value.high.tolist() == [9 if there[0] else 3, 5, 4, 3, 3]
    assert apart.tolist() == [there[0], True, False, False, True]


def test_vectors_are_apart_where_a_component_is():
    a = vec2(point(np.zeros(2)), point(np.zeros(2)))
    b = vec2(point(np.zeros(2)), point(np.array([0.0, 1.0])))
    assert joined(a, np.True_, b)[1].tolist() == [False, True]


@pytest.mark.parametrize(
    ("rows", "columns", "read"),
    [
        ((1, 1), (2, 2), {(1, 2)}),
        ((0, 1), (4, 4), {(0, 4), (1, 4)}),
        ((3, 3), (0, 2), {(3, 0), (3, 1), (3, 2)}),
        ((3, 3), (0, 4), {(3, 0), (3, 1), (3, 2)}),
        ((-3, -1), (9, 9), {(0, 4)}),
        ((2, 9), (-2, 0), {(2, 0), (3, 0)}),
    ],
)
def test_which_elements_a_fetch_reads(rows, columns, read):
    """As many as it may choose among; those outside are the nearest ones inside."""
    operations, picture = Watching(PROFILES["vulkan"]), np.zeros(SHAPE, np.float32)
    assert operations.read_of(picture) == set()
    index = [Interval(*np.array(ends)[:, None]) for ends in (rows, columns)]
    operations.fetched(picture, picture, index)
    assert operations.read_of(picture) == read and operations.read_of(picture.copy()) == set()
    operations.fetched(picture, picture, [point(np.array([0])), point(np.array([0]))])
    assert operations.read_of(picture) == read | {(0, 0)}


def test_a_nearest_texel_is_among_those_there_are():
    """Of four columns and three rows: before the first, on an edge, behind the last."""
    operations = Watching(PROFILES["vulkan"])
    uv = vec2(point(np.array([-1.0, 0.5, 2.0])), point(np.array([0.0, 0.5, 1.0])))
    found = operations.nearest_texel(ivec2(point(np.int64(4)), point(np.int64(3))), uv)
    assert (found.x.low.tolist(), found.x.high.tolist()) == ([0, 1, 3], [0, 2, 3])
    assert (found.y.low.tolist(), found.y.high.tolist()) == ([0, 1, 2], [0, 1, 2])
