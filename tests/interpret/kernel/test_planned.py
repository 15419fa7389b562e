"""Which rows a pass takes, and what its calls get: the list of them, worked out by hand."""

from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.interpret.kernel import fragment_rows
from sss_ref.interpret.kernel.modules import address_of
from sss_ref.interpret.kernel.planned import cleared, interpolated, last_uses, planned
from sss_ref.interpret.kernel.program import COLUMN, EMPTY, INDEX, ROW, STRIP, Program
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language import Array, Texture, ivec2, stage, texel, vec2, vec3
from sss_ref.language.pipeline import MeshDraw, Pass, ScreenDraw
from sss_ref.passes.vertex import mesh_vertex
from sss_ref.raster.primitives import Primitives

F = np.float32
FUNCTIONS = {address_of(function): function.__name__ for function in fragment_rows.ALL}


class Halved(NamedTuple):
    halved: float


class Mixed(NamedTuple):
    mixed: vec2
    flag: bool


class Place(NamedTuple):
    place: ivec2
    brightness: vec3


@stage(source="a test")
def halve(value: float, tint: vec2) -> Halved:
    return Halved(value * 0.5 * tint.x)


@stage(source="a test")
def mix(halved: float, known: bool, count: int, numbers: Array[vec3], picture: Texture[float], pixel: ivec2) -> Mixed:
    """Reads of every kind: what a stage before gave, a buffer, a uniform, an array, a texture, the pixel."""
    both = vec2(halved + texel(picture, pixel), numbers[count].x)
    return Mixed(both, known & (halved > 0.0))


@stage(source="a test")
def shown(fragment_normal: vec3, fragment_position: vec3) -> Place:
    return Place(ivec2(1, 2), fragment_normal + fragment_position)


@stage(source="a test")
def numbered(triangle: int, coverage: bool) -> Mixed:
    return Mixed(vec2(1.0, 2.0), coverage & (triangle > 0))


def calls_of(program):
    """Each call: the function, if it is none of a stage's, its rows, uniforms and how many tables it gets."""
    return [
        (FUNCTIONS.get(address, ""), rows, [value.view(np.int32).tolist() for value in uniforms], tables)
        for address, _, rows, uniforms, tables in program.listed
    ]


def work_of(draw, stages, uniforms=None, buffers=None, outputs=None, fragments=None):
    one = Pass("one", "camera", draw, stages)
    clear = {name: np.zeros(4, F) for name in outputs or {}}
    return Work(one, fragments or Fragments(3, 2), uniforms or {}, buffers or {}, outputs or {}, clear)


def test_rows_of_what_is_read_no_more_are_used_again():
    """Rows 0 to 3 are there: value in 4, halved in 5; then known in 4, and mixed and flag in 6 to 8."""
    value, known = np.zeros((2, 3), F), np.zeros((2, 3), np.uint8)
    picture, numbers = np.zeros((5, 7), F), np.zeros((4, 3), F)
    wanted = {"halved": np.zeros((2, 3), F), "mixed": np.zeros((2, 3, 2), F), "flag": np.zeros((2, 3), np.uint8)}
    read = {"tint": F([1, 2]), "count": 3, "numbers": numbers}
    buffers = {"value": value, "known": known, "picture": picture}
    program = planned(work_of(ScreenDraw(), (halve, mix), read, buffers, wanted))
    tint = F([1, 2]).view(np.int32).tolist()
    at = {name: array.ctypes.data for name, array in {**buffers, **wanted, "numbers": numbers}.items()}
    assert calls_of(program) == [
        ("take_words", [INDEX, 4], [], [at["value"], 1, 0, 1]),
        ("", [4, 5], [tint], []),
        ("put_words", [INDEX, 5], [], [at["halved"], 1, 0, 1]),
        ("take_bytes", [INDEX, 4], [], [at["known"], 1, 0, 1]),
        ("", [5, 4, COLUMN, ROW, 6, 7, 8], [[3]], [at["numbers"], at["picture"], 7, 5]),
        ("put_words", [INDEX, 6, 7], [], [at["mixed"], 2, 0, 2]),
        ("put_bytes", [INDEX, 8], [], [at["flag"], 1, 0, 1]),
    ]
    assert program.used == 9 and sorted(program.free) == [4, 5, 6, 7, 8]


def test_the_last_stage_that_reads_a_name():
    assert last_uses((halve, mix)) == {
        **{"value": 0, "tint": 0, "halved": 1, "known": 1, "count": 1, "numbers": 1, "picture": 1, "pixel": 1}
    }


PRIMITIVES = Primitives(
    np.array([(0, 1, 2)], np.int32),
    np.array([9], np.int32),
    np.zeros((3, 2), np.int32),
    np.zeros(3, F),
    np.ones(3, F),
    np.zeros((3, 6), F),
)
DRAW = MeshDraw(mesh_vertex.bound(clip_from_model="camera_clip_from_model"), "triangle", "depth", "coverage")


def drawn(stages, outputs, varyings=None):
    fragments = Fragments(3, 2, PRIMITIVES, np.zeros((2, 3), np.int32), 256, varyings or {})
    return planned(work_of(DRAW, stages, outputs=outputs, fragments=fragments))


def test_what_a_draw_interpolates_lies_in_rows_by_column():
    """Corners, weights and their sum in 4 to 10, six columns in 11 to 16 and a block of eight that no pack needs."""
    wanted = {"place": np.zeros((2, 3, 2), F), "brightness": np.zeros((2, 3, 3), F)}
    program = drawn((shown,), wanted, {"fragment_position": 3, "fragment_normal": 0})
    first, second, third, *rest = calls_of(program)
    assert (first[0], first[1], first[3][4:]) == ("weights", [INDEX, COLUMN, ROW, *range(4, 11)], [256])
    assert (second[0], second[1], second[3][1:]) == ("varying", [*range(4, 11), *range(11, 17)], [6, 0, 6])
    assert third[1][:6] == [11, 12, 13, 14, 15, 16]
    assert [(name, len(rows), tables[1:]) for name, rows, _, tables in rest] == [
        ("put_whole", 3, [2, 0, 2]),
        ("put_words", 4, [3, 0, 3]),
    ]
    assert program.used == 25


@pytest.mark.parametrize(
    ("stages", "wanted", "expected"),
    [
        ((), [], []),
        ((), ["triangle"], ["triangle", "put_words"]),
        ((), ["coverage"], ["same", "put_bytes"]),
        ((), ["triangle", "coverage"], ["triangle", "same", "put_words", "put_bytes"]),
        ((numbered,), [], ["triangle", "same", ""]),
        ((numbered,), ["coverage"], ["triangle", "same", "put_bytes", ""]),
    ],
)
def test_triangle_and_coverage_are_there_if_they_are_read_or_wanted(stages, wanted, expected):
    outputs = {name: np.zeros((2, 3), np.int32 if name == "triangle" else np.uint8) for name in wanted}
    program = drawn(stages, outputs)
    assert [name for name, *_ in calls_of(program)] == expected
    assert all(uniforms == [[1]] for name, _, uniforms, _ in calls_of(program) if name == "same")
    assert program.used <= 4 + 2 + 3


@pytest.mark.parametrize(
    ("columns", "expected"),
    [
        (3, [("varying", [4, 5, 6], [3, 0, 3])]),
        (8, [("varying_pack", [*range(4, 12), 12], [8, 0, 8])]),
        (11, [("varying_pack", [*range(4, 12), 15], [11, 0, 8]), ("varying", [12, 13, 14], [11, 8, 3])]),
        (
            16,
            [("varying_pack", [*range(4, 12), 20], [16, 0, 8]), ("varying_pack", [*range(12, 20), 20], [16, 8, 8])],
        ),
    ],
)
def test_columns_go_in_packs_of_eight_as_far_as_they_do(columns, expected):
    program, corners = Program(), [100, 101, 102, 103, 104, 105, 106]
    rows = interpolated(program, corners, np.zeros((3, columns), F))
    found = [(name, given[7:], tables[1:]) for name, given, _, tables in calls_of(program)]
    assert found == expected and rows == [*range(4, 4 + columns)]
    assert all(given[:7] == corners for _, given, *_ in calls_of(program))
    assert program.free == [*range(4 + columns, 12 + columns)]


def test_backgrounds_are_written_by_their_kind():
    outputs = {
        "place": np.zeros((2, 3, 2), F),
        "flag": np.zeros((2, 3), np.uint8),
        "brightness": np.zeros((2, 3, 3), F),
    }
    work = work_of(ScreenDraw(), (shown, numbered), outputs=outputs)
    backgrounds = {"place": F([1, 2]), "flag": np.array([1], np.uint8), "brightness": F([3, 4, 5])}
    program = cleared(Work(work.this_pass, work.fragments, {}, {}, outputs, backgrounds))
    whole, bits = F([1, 2]).view(np.int32).tolist(), F([3, 4, 5]).view(np.int32).tolist()
    assert calls_of(program) == [
        ("clear_words", [EMPTY], [whole], [outputs["place"].ctypes.data, 2, 0, 2]),
        ("clear_bytes", [EMPTY], [[1]], [outputs["flag"].ctypes.data, 1, 0, 1]),
        ("clear_words", [EMPTY], [bits], [outputs["brightness"].ctypes.data, 3, 0, 3]),
    ]
    assert program.used * STRIP == 4 * STRIP
