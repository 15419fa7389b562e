"""Lines of scalar Python in the order of their writing, each with what it uses, so that they can be put into loops.

A stage is cut into **parts**, loops over the fragments of a strip one after the other. A new part begins where a value
comes from a function that computes a whole row at once: pow and its like, or a loop of the language, whose turns are
done for all fragments before the next. `part` says of a value in which of these loops it is known first.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from sss_ref.numerics.scalar import SCALARS

INDENT = "    "
FIRST = "_first"  # added to the name of a texel's number: that of the first fragment, were all side by side


@dataclass(frozen=True)
class Scalar:
    """One component as an expression.

    kind: float, int or bool. uniform: the same for all fragments. atomic: a name or a literal. part: as above.
    uses: the names it mentions.
    """

    text: str
    kind: type
    uniform: bool
    atomic: bool
    part: int = 0
    uses: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Memory:
    """A texture or uniform array: where it begins, and of a texture its width and height in texels."""

    kind: Any
    address: Scalar
    size: tuple[Scalar, ...]


Value = list[Scalar] | Memory


@dataclass(frozen=True)
class Line:
    """An assignment, or a loop inside the loop over fragments that assigns several names; kinds: those of the names.

    along: of the number of a texel or of its components, the text where the fragments' texels lie side by side.
    """

    kinds: dict[str, type]
    text: tuple[str, ...]
    uses: frozenset[str]
    uniform: bool
    part: int
    along: str = ""


@dataclass(frozen=True)
class RowCall:
    """A function of whole rows, called after its part: `result` = function(arguments); uniform: of one element."""

    function: str
    arguments: tuple[str, ...]
    result: str
    uniform: bool
    part: int
    kinds: dict[str, type]

    @property
    def uses(self) -> frozenset[str]:
        """The names of its arguments."""
        return frozenset(self.arguments)


@dataclass(frozen=True)
class Accumulator:
    """What a loop of the language sums up in a row: its name outside and inside, its value before and after a turn."""

    row: str
    inside: str
    before: Scalar
    after: Scalar


@dataclass(frozen=True)
class RowLoop:
    """A loop of the language as a function of rows, called after its part: every turn is done for all fragments."""

    header: str
    lines: tuple[Line, ...]
    sums: tuple[Accumulator, ...]
    uses: frozenset[str]
    part: int
    kinds: dict[str, type]


Item = Line | RowCall | RowLoop


@dataclass
class Shared:
    """What all lines of a stage have in common: the names that are taken, and the constants of the module."""

    taken: set[str] = field(default_factory=set)
    literals: dict[str, str] = field(default_factory=dict)

    def fresh(self, name: str) -> str:
        """A variable name not used so far: the name itself if it is free."""
        chosen, number = name, 2
        while chosen in self.taken:
            chosen, number = f"{name}_{number}", number + 1
        self.taken.add(chosen)
        return chosen


class StageLines:
    """The lines of a stage."""

    def __init__(self, shared: Shared) -> None:
        self.shared = shared
        self.items: list[Item] = []

    def bind(self, name: str, value: Scalar, along: str = "") -> Scalar:
        """Give an expression a name, {0} in `along`, which is the expression where texels lie side by side."""
        variable = self.shared.fresh(name)
        beside = f"{variable} = {along.format(variable)}" if along else ""
        text = (f"{variable} = {value.text}",)
        self.items.append(Line({variable: value.kind}, text, value.uses, value.uniform, value.part, beside))
        return replace(value, text=variable, atomic=True, uses=frozenset({variable}))

    def atom(self, name: str, value: Scalar) -> Scalar:
        """The expression itself if it is a name or a literal, else a name for it."""
        return value if value.atomic else self.bind(name, value)

    def place(self, name: str, template: str, *parts: Scalar) -> Scalar:
        """Give the place of a component of a texel a name; where texels lie side by side it has 64 bits."""
        value = self.join(f"np.int32({template})", int, *parts)
        return self.bind(name, value, template.format(*(part.text for part in parts)))

    def texel(self, name: str, value: Scalar) -> Scalar:
        """Give the number of a texel a name; where texels lie side by side it is counted on from that of the first."""
        return self.bind(name, value, f"{{0}}{FIRST} + k")

    def literal(self, value: float | int | bool) -> Scalar:
        """A literal; numbers become constants of the module, since bare ones compute in 64 bits."""
        if isinstance(value, bool):
            return Scalar(repr(value), bool, True, True)
        letter, dtype = ("F", "float32") if isinstance(value, float) else ("I", "int32")
        name = f"{letter}_" + repr(value).replace("-", "m").replace(".", "_").replace("+", "")
        self.shared.literals[name] = f"np.{dtype}({value!r})"
        return Scalar(name, type(value), True, True)

    def join(self, template: str, kind: type, *parts: Scalar) -> Scalar:
        """An expression made of others; uniform parts of a varying whole get names of their own."""
        uniform = all(part.uniform for part in parts)
        if not uniform:
            parts = tuple(self.atom("uniform", part) if part.uniform else part for part in parts)
        text = template.format(*(part.text for part in parts))
        return Scalar(text, kind, uniform, False, max(p.part for p in parts), used(parts))

    def elementary(self, function: str, arguments: Sequence[Scalar]) -> Scalar:
        """One of the elementary functions, as a function of rows."""
        uniform = all(argument.uniform for argument in arguments)
        part = max(argument.part for argument in arguments)
        names = [self.bind(f"{function}_of", replace(each, uniform=uniform, part=part)) for each in arguments]
        result = self.shared.fresh(function)
        rows = tuple(each.text for each in names)
        self.items.append(RowCall(function, rows, result, uniform, part, {result: float}))
        return Scalar(result, float, uniform, True, part + 1, frozenset({result}))

    def loop(self, name: str, start: Scalar, stop: Scalar) -> "WrittenLoop":
        """A loop of the language: of rows if all fragments have the same number of turns."""
        kind = LoopOfRows if start.uniform and stop.uniform else NestedLoop
        return kind(self, name, start, stop)


class LoopLines(StageLines):
    """The lines of a loop's turn: elementary functions are called for each fragment, loops stand inside."""

    def elementary(self, function: str, arguments: Sequence[Scalar]) -> Scalar:
        """One of the elementary functions, as a function of numbers."""
        places = ", ".join(f"{{{k}}}" for k in range(len(arguments)))
        return self.join(f"{SCALARS[function].__name__}({places})", float, *arguments)

    def loop(self, name: str, start: Scalar, stop: Scalar) -> "WrittenLoop":
        """A loop inside this one."""
        return NestedLoop(self, name, start, stop)


class WrittenLoop(ABC):
    """A loop being written: `lines` of its turn, its `index`, what it accumulates."""

    index_is_uniform = True

    def __init__(self, outer: StageLines, name: str, start: Scalar, stop: Scalar) -> None:
        self.outer, self.bounds, self.lines = outer, (start, stop), LoopLines(outer.shared)
        variable = outer.shared.fresh(name)
        self.part = max(start.part, stop.part)
        self.index = Scalar(variable, int, self.index_is_uniform, True, self.part, frozenset({variable}))
        self.header = f"for {variable}_wide in range({start.text}, {stop.text}):"
        self.first = f"{variable} = np.int32({variable}_wide)"
        self.before: list[Scalar] = []
        self.inside: list[Scalar] = []

    def accumulators(self, before: list[Scalar]) -> list[Scalar]:
        """The names under which a turn finds what was summed up so far; before: the values before the first turn."""
        self.before = before
        names = [self.outer.shared.fresh("sum") for _ in before]
        pairs = zip(names, before, strict=True)
        self.inside = [Scalar(name, value.kind, False, True, value.part, frozenset({name})) for name, value in pairs]
        return self.inside

    @abstractmethod
    def close(self, after: list[Scalar]) -> list[Scalar]:
        """End the loop; after: the values after a turn. What it has accumulated."""

    def reach(self, after: list[Scalar]) -> tuple[int, frozenset[str]]:
        """The part that the loop belongs to, and the names it uses from outside."""
        own = {name for item in self.lines.items for name in item.kinds}
        own |= self.index.uses | used(self.inside)
        values = [*self.bounds, *self.before, *after]
        parts = [item.part for item in self.lines.items] + [value.part for value in values]
        uses = used(values).union(*(item.uses for item in self.lines.items)) - own
        return max(parts), uses


class LoopOfRows(WrittenLoop):
    """A loop around the loop over fragments: it writes what it accumulates to rows, turn after turn."""

    def close(self, after: list[Scalar]) -> list[Scalar]:
        """Each sum gets a row, which is read and written again in every turn."""
        part, uses = self.reach(after)
        rows = [self.outer.shared.fresh("total") for _ in after]
        sums = tuple(
            Accumulator(row, inside.text, before, value)
            for row, inside, before, value in zip(rows, self.inside, self.before, after, strict=True)
        )
        kinds = {each.row: each.after.kind for each in sums}
        first = Line({self.index.text: int}, (self.first,), frozenset(), True, 0)
        lines = (first, *(item for item in self.lines.items if isinstance(item, Line)))
        self.outer.items.append(RowLoop(self.header, lines, sums, uses, part, kinds))
        return [Scalar(row, kind, False, True, part + 1, frozenset({row})) for row, kind in kinds.items()]


class NestedLoop(WrittenLoop):
    """A loop inside the loop over fragments."""

    index_is_uniform = False

    def close(self, after: list[Scalar]) -> list[Scalar]:
        """Each sum is a variable, assigned again in every turn."""
        part, uses = self.reach(after)
        names = [each.text for each in self.inside]
        turn = [self.first, *(line for item in self.lines.items if isinstance(item, Line) for line in item.text)]
        turn.append(f"{', '.join(names)} = {', '.join(value.text for value in after)}")
        starts = [f"{name} = {value.text}" for name, value in zip(names, self.before, strict=True)]
        kinds = {each.text: each.kind for each in self.inside}
        text = (*starts, self.header, *(INDENT + line for line in turn))
        self.outer.items.append(Line(kinds, text, uses, False, part))
        return [replace(each, part=part) for each in self.inside]


def used(values: Sequence[Scalar]) -> frozenset[str]:
    """The names that some expressions mention."""
    return frozenset().union(*(value.uses for value in values))
