"""How fragments are packed into strips, and which rows and numbers each call of a program gets."""

import numpy as np
import pytest

from sss_ref.interpret.kernel.fragment_rows import clear_words, put_words
from sss_ref.interpret.kernel.modules import address_of
from sss_ref.interpret.kernel.program import COLUMN, EMPTY, ENOUGH, INDEX, ROW, STRIP, Program, end_of_run, run_rows
from sss_ref.interpret.kernel.row_memory import read_float, write_float

F = np.float32


def note_count(scratch, count, rows, uniforms, tables):
    """Write how many fragments a strip has behind what is written: uniforms: their number, then they."""
    number = read_float(uniforms, 0) + np.float32(1)
    write_float(0, uniforms, 0, number)
    write_float(0, uniforms, np.int64(number), np.float32(count))


def add_up(scratch, count, rows, uniforms, tables):
    """The first row plus the uniforms and tables' numbers, into the second."""
    for k in range(count):
        more = read_float(uniforms, 0) + read_float(uniforms, 1) + np.float32(tables[0] + tables[1])
        write_float(0, scratch, rows[1] + k, read_float(scratch, rows[0] + k) + more)


def noting():
    """Calls that note the strips among their uniforms."""
    program = Program()
    program.add(address_of(note_count), [], [np.zeros(100, F)])
    return program.calls


def strips_of(where, first_row=0):
    """How many fragments the strips have, and how many pixels those of pixels without one."""
    filling, clearing = noting(), noting()
    run_rows(where, first_row, filling, clearing, np.zeros(4 * STRIP, F))
    filled, cleared = ([int(each) for each in calls.uniforms] for calls in (filling, clearing))
    return filled[1 : filled[0] + 1], cleared[1 : cleared[0] + 1]


@pytest.mark.parametrize(
    ("height", "width", "expected"),
    [
        (1, 1, [1]),
        (1, STRIP - 1, [STRIP - 1]),
        (1, STRIP, [STRIP]),
        (1, 2 * STRIP + 3, [STRIP, STRIP, 3]),
        (2, STRIP + ENOUGH, [STRIP, ENOUGH] * 2),
        (3, ENOUGH, [ENOUGH] * 3),
        (3, ENOUGH - 1, [2 * ENOUGH - 2, ENOUGH - 1]),
        (2, STRIP + 1, [STRIP, STRIP, 2]),
        (5, 2, [10]),
    ],
)
def test_a_strip_is_full_or_ends_with_a_row_that_has_enough(height, width, expected):
    assert strips_of(np.ones((height, width), bool)) == (expected, [])


def test_pixels_without_a_fragment_fill_strips_of_their_own():
    """Those wait for a full strip, whatever the rows."""
    where = np.zeros((4, STRIP), bool)
    where[1, 3:5] = where[3, 0] = True
    assert strips_of(where) == ([3], [STRIP, STRIP, STRIP, STRIP - 3])
    assert strips_of(np.zeros((3, ENOUGH), bool)) == ([], [3 * ENOUGH])


@pytest.mark.parametrize("first_row", [0, 5])
@pytest.mark.parametrize(("height", "width"), [(1, 1), (3, 7), (2, STRIP + 5), (40, 31)])
@pytest.mark.parametrize("share", [0.0, 0.1, 0.9, 1.0])
def test_every_fragment_has_its_index_column_and_row(first_row, height, width, share):
    where = np.random.default_rng(1).random((height, width)) < share
    target = np.full(((first_row + height) * width, 2), -9, np.int32)
    filling, clearing = Program(), Program()
    filling.add(address_of(put_words), [INDEX, COLUMN, ROW], tables=[filling.address(target), 2, 0, 2])
    nothing = [np.array([-1, -2], np.int32).view(F)]
    clearing.add(address_of(clear_words), [EMPTY], nothing, [clearing.address(target), 2, 0, 2])
    run_rows(where, first_row, filling.calls, clearing.calls, np.zeros(4 * STRIP, F))
    expected = [
        (column, first_row + row) if where[row, column] else (-1, -2)
        for row in range(height)
        for column in range(width)
    ]
    assert target[first_row * width :].tolist() == [list(each) for each in expected]
    assert (target[: first_row * width] == -9).all()


@pytest.mark.parametrize(
    ("row", "begin", "end"), [("1", 0, 1), ("110", 0, 2), ("110", 1, 2), ("110", 2, 3), ("011", 0, 1), ("0000", 1, 4)]
)
def test_a_run_ends_where_the_next_begins(row, begin, end):
    assert end_of_run(np.array([*map(int, row)], bool), begin) == end


def test_each_call_gets_its_own_rows_uniforms_and_tables():
    """1 + (2 + 3) + (10 + 20) = 36, then 36 + (4 + 5) + (30 + 40) = 115, then of one fragment 115 + 11 + 0 = 126."""
    program = Program()
    first, second, third, fourth = program.rows(4)
    for rows, numbers, tables in (((first, second), (2, 3), (10, 20)), ((second, third), (4, 5), (30, 40))):
        program.add(address_of(add_up), rows, [np.array([number], F) for number in numbers], tables)
    program.add(address_of(add_up), (third, fourth), [np.array([5, 6], F)], (0, 0), single=True)
    scratch = np.zeros((program.used, STRIP), F)
    scratch[first, :3] = 1
    run_rows(np.ones((1, 3), bool), 0, program.calls, Program().calls, scratch.reshape(-1))
    found = scratch[[second, third, fourth], :4].tolist()
    assert found == [[36, 36, 36, 0], [115, 115, 115, 0], [126, 0, 0, 0]]


def test_rows_are_taken_anew_only_where_none_is_free():
    """The first four are those of index, column, row and pixels without a fragment."""
    program = Program()
    assert program.rows(2) == [4, 5] and program.block(3) == [6, 7, 8]
    program.give_back([5, 7])
    assert (program.rows(1), program.rows(2), program.rows(0)) == ([5], [7, 9], [])
    assert program.used == 10


def test_memory_is_kept_as_long_as_its_address():
    program, array = Program(), np.arange(6, dtype=F)
    assert program.address(array) == array.ctypes.data and program.arrays[-1] is array
    with pytest.raises(AssertionError):
        program.address(array[::2])


def test_rows_are_read_by_their_place_in_the_scratch():
    program = Program()
    program.add(7, [5, 6], [np.array([1, 2], F)], [8])
    program.add(9, [4], (), [1, 2], single=True)
    calls = program.calls
    assert (calls.address.tolist(), calls.single.tolist()) == ([7, 9], [False, True])
    assert (calls.row_at.tolist(), calls.rows.tolist()) == ([0, 2], [5 * STRIP, 6 * STRIP, 4 * STRIP])
    assert (calls.uniform_at.tolist(), calls.uniforms.tolist()) == ([0, 2], [1, 2])
    assert (calls.table_at.tolist(), calls.tables.tolist()) == ([0, 1], [8, 1, 2])
    assert all(len(each) == 0 for each in Program().calls)
