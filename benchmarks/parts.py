"""What each part of a rendering takes, one thread, in nanoseconds: python benchmarks/parts.py --method texture_space.

Every call of a pass's program is timed alone, on the strips that a rendering has, and so are the parts around the
programs. Processor time, the least of several renderings; what reading the clock takes is taken off.
"""

import argparse
import ctypes
import tempfile
import time
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from linearity import render, scene, timed, written

from sss_ref.interpret import finite
from sss_ref.interpret.kernel import elementary_rows, fragment_rows, modules, program, strips
from sss_ref.raster import rasterize
from sss_ref.rendering import draw

FUNCTION = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64, *[ctypes.c_void_p] * 3)
AROUND: list[tuple[ModuleType, str, str]] = [  # what is no call of a program: its module, its name, what it is told as
    (draw, "assemble", "clip, project, snap"),
    (draw, "bin_pieces", "sort triangles into bands"),
    (rasterize, "draw_band", "coverage and depth"),
    (finite, "largest_magnitude", "look for NaN"),
]
LEAST = 0.3  # ms: what is shown


def main() -> None:
    """The table of one picture."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--triangles", type=int, default=100_000)
    parser.add_argument("--preset", default="paper")
    parser.add_argument("--method", default="screen_space")
    parser.add_argument("--runs", type=int, default=5)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        drawn = scene(asked, asked.method, written(Path(folder), asked.triangles), asked.size)
    render(drawn, 1)
    print(f"{asked.method}, preset {asked.preset}, {asked.size}^2, {asked.triangles} triangles, the image alone")
    print(f"{min(timed(time.thread_time, drawn, 1) for _ in range(asked.runs)):.1f} ms; of them")
    for name, (milliseconds, count) in sorted(measured(drawn, asked.runs).items(), key=lambda each: -each[1][0]):
        if milliseconds >= LEAST:
            each = f"{1e6 * milliseconds / count:8.2f} ns for each of {count}" if count else ""
            print(f"  {name:34s}{milliseconds:8.2f} ms{each}", flush=True)


def measured(drawn: Any, runs: int) -> dict[str, tuple[float, int]]:
    """Part -> the milliseconds it takes at least, and for how many fragments it runs."""
    clock, least = Clock(), dict[str, tuple[float, int]]()
    clock.put_in()
    for _ in range(runs):
        clock.taken.clear()
        render(drawn, 1)
        for name, (milliseconds, count) in clock.taken.items():
            least[name] = min(least.get(name, (milliseconds, count)), (milliseconds, count))
    return least


class Clock:
    """Times the parts; taken: part -> milliseconds, and for how many fragments."""

    def __init__(self) -> None:
        self.taken: dict[str, tuple[float, int]] = {}
        nothing = FUNCTION(modules.address_of(fragment_rows.same)), *self.pointers([np.zeros(1)] * 4, 0)
        self.own = sorted(self.timed(*nothing)[0] for _ in range(1000))[500]
        rows = {**{each.__name__: each for each in fragment_rows.ALL}, **elementary_rows.ELEMENTARY_ROWS}
        self.names = {modules.address_of(function): name for name, function in rows.items()}

    def timed(self, function: Any, *arguments: Any) -> tuple[float, Any]:
        """Milliseconds of this thread, and the result."""
        start = time.thread_time_ns()
        result = function(*arguments)
        return 1e-6 * (time.thread_time_ns() - start), result

    def add(self, name: str, milliseconds: float, count: int) -> None:
        """Count the time of a part."""
        before, fragments = self.taken.get(name, (0.0, 0))
        self.taken[name] = before + milliseconds - self.own, fragments + count

    def put_in(self) -> None:
        """Put the clock into the package."""
        for module, name, part in AROUND:
            setattr(module, name, self.clocked(getattr(module, name), part))
        for codes in modules.CODES.values():
            for code in codes:
                self.names |= {address: call.function for address, call in code.calls if not call.elementary}
        strips.run_rows = self.run_rows

    def clocked(self, function: Any, part: str) -> Any:
        """A function that is timed."""

        def run(*arguments: Any) -> Any:
            milliseconds, result = self.timed(function, *arguments)
            self.add(part, milliseconds, 0)
            return result

        return run

    def run_rows(self, where: Any, first_row: int, filling: Any, clearing: Any, scratch: Any) -> None:
        """As `program.run_rows`, call by call; no strip goes over the end of a row."""
        numbers = scratch.view(np.int32).reshape(-1, program.STRIP)
        for row, inside in enumerate(where, start=first_row):
            for columns, calls in ((np.flatnonzero(inside), filling), (np.flatnonzero(~inside), clearing)):
                for first in range(0, len(columns), program.STRIP):
                    own = columns[first : first + program.STRIP]
                    numbers[[program.INDEX, program.EMPTY], : len(own)] = row * len(inside) + own
                    numbers[program.COLUMN, : len(own)], numbers[program.ROW, : len(own)] = own, row
                    self.run(calls, scratch, len(own))

    def run(self, calls: Any, scratch: Any, count: int) -> None:
        """As `program.run`, each call timed."""
        for k, address in enumerate(calls.address.tolist()):
            fragments = 1 if calls.single[k] else count
            tables = calls.uniforms[calls.uniform_at[k] :], calls.tables[calls.table_at[k] :]
            pointers = self.pointers([scratch, calls.rows[calls.row_at[k] :], *tables], fragments)
            milliseconds, _ = self.timed(FUNCTION(address), *pointers)
            self.add(self.names[address].rstrip("_0123456789"), milliseconds, fragments)

    def pointers(self, arrays: list[Any], count: int) -> list[int]:
        """The arguments of a function of rows: scratch, count, rows, uniforms, tables."""
        scratch, *others = (array.ctypes.data for array in arrays)
        return [scratch, count, *others]


if __name__ == "__main__":
    main()
