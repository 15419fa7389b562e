"""Writes the module of a stage: its parts and its loops, each a function of the rows of a strip."""

from collections.abc import Collection, Iterable
from dataclasses import replace

from sss_ref.interpret.kernel.lines import FIRST, INDENT, Accumulator, Line, RowCall, RowLoop
from sss_ref.interpret.kernel.stage_rows import READ, StageCall, StageRows
from sss_ref.language.stage import Stage
from sss_ref.numerics.scalar import SCALARS

HEADER = '''"""Stage {name}: {source}. Written by sss_ref from the stage; do not edit."""

import numpy as np

from sss_ref.interpret.kernel.plain_memory import (
    chosen,
    read_float,
    read_int,
    reread_float,
    reread_int,
    texel_byte,
    texel_float,
    texel_int,
    write_float,
    write_int,
)
from sss_ref.interpret.kernel.row_function import row_function
'''
ELEMENTARY = f"from sss_ref.numerics.scalar import {', '.join(sorted(each.__name__ for each in SCALARS.values()))}\n"
REREAD = {
    float: "reread_float({2}, {0}, {1})",
    int: "reread_int({2}, {0}, {1})",
    bool: "(reread_int({2}, {0}, {1}) != 0)",
}
WRITE = {
    float: "write_float({2}, {0}, {1}, {3})",
    int: "write_int({2}, {0}, {1}, {3})",
    bool: "write_int({2}, {0}, {1}, np.int32({3}))",
}
WHERE_BESIDE = (
    "last_apart = chosen(apart & (k < middle), np.int32(k + 1), np.int32(0))",
    "next_apart = chosen(apart & (k > middle), np.int32(k), np.int32(count))",
    "low = chosen(low < last_apart, last_apart, low)",
    "high = chosen(next_apart < high, next_apart, high)",
)

SIDES = "begin, end = chosen(side == 0, np.int64(0), np.int64(high)), chosen(side == 0, np.int64(low), count)"


class StageSource:
    """The source of a stage's module, `text`, and the `calls` of its functions in order; uniform: as in StageRows."""

    def __init__(self, stage: Stage, uniform: Collection[str]) -> None:
        self.stage, self.rows = stage, StageRows(stage, uniform)
        self.functions: list[str] = []
        self.calls: list[StageCall] = []
        for part in self.rows.parts:
            self.part(part)
            for item in self.rows.calls_after(part):
                self.row_loop(item) if isinstance(item, RowLoop) else self.row_call(item)

    @property
    def text(self) -> str:
        """The whole module."""
        header = HEADER.format(name=self.stage.name, source=self.stage.source)
        functions = "\n\n".join(self.functions)
        literals = sorted(self.rows.lines.shared.literals.items())
        constants = "".join(f"{name} = {value}\n" for name, value in literals)
        return f"{header}{ELEMENTARY if '_scalar(' in functions else ''}\n{constants}\n\n{functions}"

    def add(self, function: "RowFunction") -> None:
        """A function of the module, and its call."""
        name = f"{self.stage.name}_{len(self.functions)}"
        self.functions.append(function.text(name))
        self.calls.append(StageCall(name))

    def part(self, part: int) -> None:
        """One loop over the fragments."""
        lines = self.rows.lines_of(part)
        singles = [name for call in self.rows.calls_after(part) if is_single(call) for name in sorted(call.uses)]
        written = self.rows.handed_on(part)
        if lines or singles:
            function = RowFunction(self.rows)
            function.uniform({*uses(lines), *singles})
            for name in singles:
                function.body.append(function.written(name, name, "0"))
            function.over_fragments(lines, written)
            self.add(function)

    def row_call(self, call: RowCall) -> None:
        """One of the elementary functions."""
        rows = tuple(self.rows.row(name) for name in (*call.arguments, call.result))
        self.calls.append(StageCall(call.function, rows, elementary=True, single=call.uniform))

    def row_loop(self, loop: RowLoop) -> None:
        """A loop of the language."""
        function = RowFunction(self.rows)
        function.uniform(set(loop.uses))
        function.starts(loop.sums)
        function.body.append(loop.header)
        function.depth += 1
        function.body += [INDENT + text for line in loop.lines if line.uniform for text in line.text]
        function.turn([line for line in loop.lines if not line.uniform], loop.sums)
        self.add(function)


class RowFunction:
    """A function of rows being written."""

    def __init__(self, rows: StageRows) -> None:
        self.rows, self.depth = rows, 0
        self.places: dict[int, str] = {}  # number of a row -> the variable that holds its place in the scratch
        self.owned: dict[int, int] = {}  # number of a row that is written -> its number among these
        self.before: list[str] = []
        self.body: list[str] = []

    def text(self, name: str) -> str:
        """The whole function."""
        places = [f"{variable} = rows[{number}]" for number, variable in self.places.items()]
        lines = [*places, *self.before, *self.body]
        head = f"@row_function\ndef {name}(scratch, count, rows, uniforms, tables):\n"
        return head + "".join(f"{INDENT}{line}\n" for line in lines)

    def uniform(self, names: set[str]) -> None:
        """Compute what is the same for all fragments, and everything it comes from."""
        items, wanted, todo = self.rows.uniform_items, set(), list(names)
        while todo:
            name = todo.pop()
            if name in items and name not in wanted:
                wanted.add(name)
                todo += items[name].uses if isinstance(items[name], Line) else ()
        for name, item in items.items():
            if name in wanted:
                self.before += item.text if isinstance(item, Line) else [f"{name} = {self.single(name)}"]

    def single(self, name: str) -> str:
        """The one element of a row."""
        return READ[float].format("scratch", f"rows[{self.rows.row(name)}]")

    def place(self, name: str) -> str:
        """The variable with the place of a value's row."""
        number = self.rows.row(name)
        return self.places.setdefault(number, f"row_{number}")

    def read(self, name: str) -> str:
        """Take a value out of its row."""
        return f"{name} = " + READ[self.rows.kinds[name]].format("scratch", f"{self.place(name)} + k")

    def written(self, name: str, value: str, index: str = "k") -> str:
        """Put a value into the row of a name."""
        owned = self.owned.setdefault(self.rows.row(name), len(self.owned))
        return WRITE[self.rows.kinds[name]].format("scratch", f"{self.place(name)} + {index}", owned, value)

    def loop(self, lines: Iterable[str], fragments: str = "count") -> None:
        """Add a loop over the fragments, or some of them."""
        self.body.append(f"{INDENT * self.depth}for k in range({fragments}):")
        self.body += [INDENT * (self.depth + 1) + line for line in lines]

    def reads(self, names: Iterable[str]) -> list[str]:
        """Take those of some names that differ between fragments out of their rows."""
        return [
            self.read(name) for name in sorted(names) if name in self.rows.kinds and name not in self.rows.uniform_items
        ]

    def over_fragments(self, lines: list[Line], written: list[str]) -> None:
        """The loop of a part."""
        own = {name for line in lines for name in line.kinds}
        body = [*self.reads(uses(lines) - own), *(text for line in lines for text in line.text)]
        body += [self.written(name, name) for name in written]
        if body:
            self.loop(body)

    def starts(self, sums: tuple[Accumulator, ...]) -> None:
        """The loop that puts down what is accumulated before the first turn."""
        needed = frozenset().union(*(each.before.uses for each in sums))
        self.loop([*self.reads(needed), *(self.written(each.row, each.before.text) for each in sums)])

    def turn(self, lines: list[Line], sums: tuple[Accumulator, ...]) -> None:
        """The loop over the fragments in one turn, or two where texels may lie side by side.

        Those of the fragments from `low` to `high` then do, counted on from the one in the middle: a strip may begin or
        end at the picture's edge, where texels are clamped, or in another row of pixels.
        """
        first = {name: f"{name}{FIRST}" for line in lines if line.along.endswith(" + k") for name in line.kinds}
        if not first:
            self.one_turn(lines, sums)
            return
        to_texels = leading_to(lines, set(first))
        body = [*self.reads(uses(to_texels)), *(text for line in to_texels for text in line.text)]
        indent = INDENT * self.depth
        self.body += [indent + text for text in ("k = middle = count >> 1", *body)]
        self.body += [f"{indent}{start} = np.int32({name} - k)" for name, start in first.items()]
        self.body.append(f"{indent}low, high = np.int32(0), np.int32(count)")
        apart = " | ".join(f"({name} ^ np.int32({start} + k))" for name, start in first.items())
        self.loop([*body, f"apart = ({apart}) != 0", *WHERE_BESIDE])
        self.body += [f"{indent}for side in range(2):", f"{indent}{INDENT}{SIDES}"]
        self.depth += 1
        self.one_turn(lines, sums, "begin, end")
        self.depth -= 1
        self.one_turn(
            [replace(line, text=(line.along,)) if line.along else line for line in lines],
            sums,
            "np.int64(low), np.int64(high)",
        )

    def one_turn(self, lines: list[Line], sums: tuple[Accumulator, ...], fragments: str = "count") -> None:
        """The loop itself; fragments: from which to which, as Python's `range` has it."""
        own = {name for line in lines for name in line.kinds} | {each.inside for each in sums}
        needed = uses(lines).union(*(each.after.uses for each in sums)) - own
        taken = [f"{each.inside} = {self.reread(each.row)}" for each in sums]
        stored = [self.written(each.row, each.after.text) for each in sums]
        body = [*self.reads(needed), *taken, *(text for line in lines for text in line.text), *stored]
        self.loop(body, fragments)

    def reread(self, name: str) -> str:
        """What a row that this function writes holds by now."""
        owned = self.owned[self.rows.row(name)]
        return REREAD[self.rows.kinds[name]].format("scratch", f"{self.place(name)} + k", owned)


def uses(lines: Iterable[Line]) -> frozenset[str]:
    """The names that some lines mention."""
    return frozenset().union(*(line.uses for line in lines))


def leading_to(lines: list[Line], names: set[str]) -> list[Line]:
    """Those of some lines that the values of some names come from."""
    wanted, found = set(names), list[Line]()
    for line in reversed(lines):
        if wanted & line.kinds.keys():
            found.insert(0, line)
            wanted |= line.uses
    return found


def is_single(call: RowCall | RowLoop) -> bool:
    """Whether a function of rows computes one element for all fragments."""
    return isinstance(call, RowCall) and call.uniform
