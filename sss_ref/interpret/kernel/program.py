"""A program: the calls that a strip of fragments goes through, one after the other, and what each of them gets."""

from collections.abc import Iterable, Sequence
from itertools import accumulate, chain
from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled, part_of_kernels
from sss_ref.interpret.kernel.row_function import call
from sss_ref.language.layout import FLOAT32

STRIP = 512  # fragments at a time: the rows of a pass stay in the processor's second cache
ENOUGH = 128  # fragments: a strip of so many ends with its row of pixels, so that its texels lie side by side
INDEX, COLUMN, ROW, EMPTY = range(4)  # rows that are filled before any call: of fragments, and of pixels without one


class Calls(NamedTuple):
    """The calls of a program: addresses int64 (C,), single bool (C,), and of each where its own numbers begin."""

    address: np.ndarray
    single: np.ndarray
    row_at: np.ndarray
    rows: np.ndarray
    uniform_at: np.ndarray
    uniforms: np.ndarray
    table_at: np.ndarray
    tables: np.ndarray


class Program:
    """Calls being listed, and rows that are taken and given back."""

    def __init__(self) -> None:
        self.used = 4
        self.free: list[int] = []
        self.arrays: list[np.ndarray] = []  # kept alive while their addresses are in use
        self.listed: list[tuple[int, bool, list[int], list[np.ndarray], list[int]]] = []

    def rows(self, count: int) -> list[int]:
        """Rows that nothing else lies in."""
        new = count - len(self.free)
        if new > 0:
            self.free += range(self.used, self.used + new)
            self.used += new
        taken, self.free = self.free[:count], self.free[count:]
        return taken

    def block(self, count: int) -> list[int]:
        """Rows that lie one behind the other."""
        self.used += count
        return list(range(self.used - count, self.used))

    def give_back(self, rows: Sequence[int]) -> None:
        """Rows whose values are needed no more."""
        self.free += rows

    def address(self, array: np.ndarray) -> int:
        """Where an array begins, which must be contiguous; it is kept as long as the program."""
        assert array.flags.c_contiguous
        self.arrays.append(array)
        return array.ctypes.data

    def add(
        self,
        address: int,
        rows: Sequence[int],
        uniforms: Sequence[np.ndarray] = (),
        tables: Sequence[int] = (),
        single: bool = False,
    ) -> None:
        """A call of the function of rows at an address; uniforms: float32 arrays, one after the other."""
        self.listed.append((address, single, list(rows), list(uniforms), list(tables)))

    @property
    def calls(self) -> Calls:
        """All of them, as the loop over strips takes them."""
        addresses, singles, rows, uniforms, tables = zip(*self.listed, strict=True) if self.listed else [()] * 5
        return Calls(
            np.array(addresses, np.int64),
            np.array(singles, np.bool_),
            _begins(map(len, rows)),
            STRIP * np.array([*chain(*rows)], np.int64),
            _begins(sum(map(len, each)) for each in uniforms),
            np.concatenate([np.empty(0, FLOAT32), *chain(*uniforms)]),
            _begins(map(len, tables)),
            np.array([*chain(*tables)], np.int64),
        )


def _begins(lengths: Iterable[int]) -> np.ndarray:
    """Where each of several parts of these lengths begins, int64 (C,), if they lie one after the other."""
    *begins, _ = accumulate(lengths, initial=0)
    return np.array(begins, np.int64)


@compiled
def run_rows(where, first_row, filling, clearing, scratch):
    """Run a program on the fragments of some rows of pixels, and another on the pixels without one.

    where: bool (R, W), which pixels hold a fragment. filling, clearing: Calls. scratch: float32 (rows * STRIP,).
    """
    numbers, width = scratch.view(np.int32), where.shape[1]
    count = empty = np.int64(0)  # numba would compile `run` anew for a 0 of Python
    for k in range(len(where)):
        row, column = first_row + k, 0
        while column < width:
            inside, end = where[k, column], end_of_run(where[k], column)
            while column < end:
                taken = min(end - column, STRIP - (count if inside else empty))
                index = row * width + column
                if inside:
                    for number, first, step in ((INDEX, index, 1), (COLUMN, column, 1), (ROW, row, 0)):
                        put_down(numbers, number, count, taken, first, step)
                    count += taken
                else:
                    put_down(numbers, EMPTY, empty, taken, index, 1)
                    empty += taken
                column += taken
                if count == STRIP:
                    run(filling, scratch, count)
                    count = 0
                if empty == STRIP:
                    run(clearing, scratch, empty)
                    empty = 0
        if count >= ENOUGH:
            run(filling, scratch, count)
            count = 0
    run(filling, scratch, count)
    run(clearing, scratch, empty)


@part_of_kernels
def end_of_run(row, begin):
    """The first column behind `begin` where a row, bool (W,), is not what it is there, or W."""
    rest, here = row[begin:], row[begin]
    for k in range(len(rest)):
        if rest[k] != here:
            return begin + k
    return len(row)


@part_of_kernels
def put_down(numbers, row, at, count, first, step):
    """Write whole numbers into a row of the scratch from one fragment on: `first`, then each `step` more."""
    for k in range(count):
        place = np.uint64(row * STRIP + at + k)  # as it is never below 0, no element is counted from the end
        numbers[place] = first + k * step


@compiled
def run(calls, scratch, count):
    """Run a program on a strip of `count` fragments."""
    if count == 0:
        return
    for k in range(len(calls.address)):
        call(
            calls.address[k],
            scratch,
            1 if calls.single[k] else count,
            calls.rows,
            calls.row_at[k],
            calls.uniforms,
            calls.uniform_at[k],
            calls.tables,
            calls.table_at[k],
        )
