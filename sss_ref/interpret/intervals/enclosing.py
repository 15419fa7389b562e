"""A body of the language walked on intervals, once for all fragments of a chunk.

Where a position between texels may lie in several cells, the body that splits it is walked once for each of them, so
that the whole and the fractional part belong together.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import reduce
from typing import Any

import numpy as np

from sss_ref.errors import StageError
from sss_ref.interpret.intervals import value_sets
from sss_ref.interpret.intervals.operations import COMPARISONS, FILTERS, LOGIC, Operations, slackened, truncated
from sss_ref.interpret.intervals.value_sets import componentwise
from sss_ref.language import tree
from sss_ref.language.builtins import fract
from sss_ref.language.sampling import fractional_part, whole_part
from sss_ref.language.types import Vector, components, ivec2, mat3, mat4, vec2
from sss_ref.numerics import interval
from sss_ref.numerics.interval import Interval, each_end, negated, point

FURTHER_CELLS = ((1, 0), (0, 1), (1, 1))  # right of, above, and diagonally from the first cell of a position

# Why a value is a set of separate ones rather than one value with its error; bits that add up.
NO_DOUBT = np.uint8(0)
CONDITION = np.uint8(1)  # a condition could not be decided
WHICH_TEXEL = np.uint8(2)  # nor which texel is meant

Evaluated = tuple[int, int]  # which line of a body, counted as they are run, and the id of an expression in it


@dataclass(frozen=True, eq=False, slots=True)
class Outcome:
    """What an expression may give, for each fragment.

    value: an Interval or a vector of them. doubt: uint8, the sum of `CONDITION` and `WHICH_TEXEL` where the
    value is one of several because of a condition or a texel that could not be decided; 0 elsewhere.
    """

    value: Any
    doubt: Any = NO_DOUBT

    @property
    def unbounded(self) -> Any:
        """Where a component may be anything on at least one side."""
        ends = [np.isfinite(end) for part in components(self.value) for end in (part.low, part.high)]
        return ~reduce(np.logical_and, ends)


def enclosed(body: tree.Body, arguments: Mapping[str, Outcome], operations: Operations) -> dict[str, Outcome]:
    """What a body may return, by output: the hull over all cells that the position it splits may lie in."""
    return _over_cells(_Walk, body, arguments, operations)


def enclosed_lines(
    body: tree.Body, arguments: Mapping[str, Outcome], operations: Operations
) -> dict[Evaluated, Outcome]:
    """What each expression in the lines of a body may give, the hull over all cells; called functions stay closed."""
    return _over_cells(_LineByLine, body, arguments, operations)


def _over_cells(
    kind: type["_Walk"], body: tree.Body, arguments: Mapping[str, Outcome], operations: Operations
) -> dict[Any, Outcome]:
    """What a kind of walk finds, joined over all cells."""
    walk = kind(operations, dict(arguments))
    results = walk.run(body)
    for cell in FURTHER_CELLS:
        where = walk.reaches(cell)
        if np.any(where):
            there = {name: picked(outcome, where) for name, outcome in arguments.items()}
            again = kind(operations, there, cell).run(body)
            results = {name: _joined(results[name], where, again[name]) for name in results}
    return results


class _Walk:
    """One body; of a position between texels, the given cell."""

    def __init__(self, operations: Operations, names: dict[str, Outcome], cell: tuple[int, int] = (0, 0)) -> None:
        self.operations = operations
        self.names = names
        self.cell = cell
        self.position: Vector | None = None
        self.crossed: tuple[Any, ...] = (np.False_, np.False_)
        self.splits: dict[Any, Callable[..., Any]] = {
            whole_part: self.whole_part,
            fractional_part: self.fractional_part,
            fract: self.fract,
        }

    def reaches(self, cell: tuple[int, int]) -> Any:
        """Where the position may lie in that cell too."""
        column, row = self.crossed
        return (column if cell[0] else np.True_) & (row if cell[1] else np.True_)

    def run(self, body: tree.Body) -> dict[Any, Outcome]:
        """Walk the statements; output -> outcome."""
        for statement in body.statements:
            if isinstance(statement, tree.Loop):
                self.loop(statement)
            else:
                self.names[statement.name] = self.line(statement.value)
        return {name: self.line(value) for name, value in body.result.values.items()}

    def line(self, expression: tree.Expression) -> Outcome:
        """What a line of the body may give."""
        return self.outcome(expression)

    def loop(self, statement: tree.Loop) -> None:
        """Every turn; the bounds of a loop are the same for all fragments."""
        start, stop = (int(self.outcome(end).value.low) for end in (statement.start, statement.stop))
        for index in range(start, stop):
            self.names[statement.index] = Outcome(point(np.int64(index)))
            for assign in statement.block:
                self.names[assign.name] = self.line(assign.value)

    def outcome(self, expression: tree.Expression) -> Outcome:
        """What an expression may give."""
        match expression:
            case tree.Literal(value=value) | tree.Constant(value=value):
                return Outcome(point(value_sets.computable(value)))
            case tree.Variable(name=name):
                return self.names[name]
        inner = [self.outcome(child) for child in tree.children(expression)]
        if isinstance(expression, tree.Call):
            return self.call(expression, inner)
        return self.combined(expression, [outcome.value for outcome in inner], _doubts(inner))

    def combined(self, expression: tree.Expression, values: list[Any], doubt: Any) -> Outcome:
        """What an expression other than a call may give, from the values inside it."""
        match expression:
            case tree.Member(letters=letters):
                return Outcome(getattr(values[0], letters), doubt)
            case tree.Construct(type=kind):
                return Outcome(kind(*values), doubt)
            case tree.Element():
                return self.fetch(values[0].data, values[0].data, [values[1]], doubt)
            case tree.Operation(operator=sign) if sign in COMPARISONS:
                return _truth(COMPARISONS[sign](*values), np.where(doubt, doubt, CONDITION))
            case tree.Operation(operator="&" | "|" as sign):
                return _truth(LOGIC[sign](*values), doubt)
            case tree.Operation(operator="*") if isinstance(values[0], mat3 | mat4):
                return Outcome(self.operations.transformed(*values), doubt)
            case tree.Operation(operator=sign, type=kind):
                return Outcome(componentwise(self.operations.on_scalars(sign, kind), *values), doubt)
        raise AssertionError(expression)

    def call(self, expression: tree.Call, inner: list[Outcome]) -> Outcome:
        """What a call may give."""
        callee, values, doubt = expression.callee, [outcome.value for outcome in inner], _doubts(inner)
        for special in (self.splits, self.operations.whole):
            if callee in special:
                return Outcome(special[callee](*values), doubt)
        if expression.body is not None:
            names = dict(zip(expression.body.parameters, inner, strict=True))
            result = enclosed(expression.body, names, self.operations)["return"]
            return (
                replace(result, value=self.operations.filtered(values[0], result.value))
                if callee in FILTERS
                else result
            )
        match callee.name:
            case "select":
                return _selected(*inner)
            case "texel":
                return self.fetch(values[0].low, values[0].high, [values[1].y, values[1].x], doubt)
            case "size":
                height, width = values[0].low.shape[:2]
                return Outcome(ivec2(point(np.int64(width)), point(np.int64(height))))
        return Outcome(componentwise(self.operations.on_scalars(callee.name, expression.type), *values), doubt)

    def fetch(self, low: np.ndarray, high: np.ndarray, index: list[Interval], doubt: Any) -> Outcome:
        """An element of a texture or array, or the hull of all that the index may mean."""
        value, several = self.operations.fetched(low, high, index)
        value = componentwise(self.operations.read, value)
        return Outcome(value, doubt | np.where(several, WHICH_TEXEL, NO_DOUBT) if np.any(several) else doubt)

    # Positions between texels

    def whole_part(self, position: Vector) -> ivec2:
        """The cell that is being walked; any where there are more than two on an axis."""
        return ivec2(*self.split(position, self.operations.position_slack)[0])

    def fractional_part(self, position: Vector) -> Vector:
        """How far the position reaches into that cell."""
        return type(position)(*self.split(position, self.operations.position_slack)[1])

    def fract(self, x: Any) -> Any:
        """The same for texture coordinates, which have no slack; of other types what x - floor(x) may give."""
        if isinstance(x, vec2):
            return vec2(*self.split(x, 0.0)[1])
        add = self.operations.arithmetic.add
        return componentwise(lambda a: add(a, negated(each_end(np.floor, a))), x)

    def split(self, position: Vector, slack: float) -> tuple[list[Interval], list[Interval]]:
        """Per axis the cell that is being walked, and the fractions there; remembers where there are further ones.

        Raises StageError where a body splits two positions: which cells belong together, it alone could not tell.
        """
        if self.position is not None and self.position is not position:
            raise StageError("a body splits two positions between texels; put one of them into a function of its own")
        self.position = position
        reach = [slackened(x, slack) for x in position]
        first = [np.floor(x.low) for x in reach]
        last = [np.floor(x.high) for x in reach]
        cells = [b if step else a for a, b, step in zip(first, last, self.cell, strict=True)]
        self.crossed = tuple(b - a == 1 for a, b in zip(first, last, strict=True))
        too_many = [~(b - a <= 1) for a, b in zip(first, last, strict=True)]
        whole = map(value_sets.anything_where, too_many, (point(truncated(cell)) for cell in cells))
        inside = map(value_sets.anything_where, too_many, map(self.inside, reach, cells))
        return list(whole), list(inside)

    def inside(self, reach: Interval, cell: Any) -> Interval:
        """A position from the corner of a cell, 0 to 1."""
        return each_end(lambda end: np.clip(end, 0.0, 1.0), self.operations.arithmetic.add(reach, point(-cell)))


class _LineByLine(_Walk):
    """A walk that gives what each expression may give on the way, and not only what the body returns."""

    def run(self, body: tree.Body) -> dict[Evaluated, Outcome]:
        """Walk the statements; line and expression -> outcome."""
        self.number = -1  # of the line at work
        self.evaluated: dict[Evaluated, Outcome] = {}
        super().run(body)
        return self.evaluated

    def line(self, expression: tree.Expression) -> Outcome:
        """As of any walk; counts the lines."""
        self.number += 1
        return super().line(expression)

    def outcome(self, expression: tree.Expression) -> Outcome:
        """As of any walk; remembers numbers, not what is known exactly and holds many: textures, arrays, matrices."""
        found = super().outcome(expression)
        if all(isinstance(part, Interval) for part in components(found.value)):
            self.evaluated[self.number, id(expression)] = found
        return found


def picked(outcome: Outcome, where: Any) -> Outcome:
    """An outcome at some of the fragments."""
    if np.ndim(where) == 0:
        return outcome
    return Outcome(
        value_sets.picked(outcome.value, where), outcome.doubt[where] if np.ndim(outcome.doubt) else outcome.doubt
    )


def _joined(a: Outcome, where: Any, b: Outcome) -> Outcome:
    """The hull of a with b, which holds only the fragments `where`; where the two lie apart, it is in doubt."""
    value, apart = value_sets.joined(a.value, where, b.value)
    there = b.doubt | np.where(apart if np.ndim(where) == 0 else apart[where], WHICH_TEXEL, NO_DOUBT)
    if np.ndim(where) == 0:
        return Outcome(value, a.doubt | there)
    doubt = np.broadcast_to(a.doubt, np.shape(where)).copy()
    doubt[where] |= there
    return Outcome(value, doubt)


def _selected(condition: Outcome, if_true: Outcome, if_false: Outcome) -> Outcome:
    """Select; both values where the condition is undecided, which is a doubt where they differ."""
    truth = condition.value
    value = componentwise(lambda a, b: interval.chosen(truth, a, b), if_true.value, if_false.value)
    doubt = np.where(truth.low, if_true.doubt, if_false.doubt)
    if not np.any(truth.undecided):
        return Outcome(value, doubt if np.any(doubt) else NO_DOUBT)
    apart = componentwise(lambda a, b: (a.low != b.low) | (a.high != b.high), if_true.value, if_false.value)
    differ = reduce(np.logical_or, components(apart))
    cause = np.where(condition.doubt, condition.doubt, CONDITION)
    either = if_true.doubt | if_false.doubt | np.where(differ, cause, NO_DOUBT)
    return Outcome(value, np.where(truth.undecided, either, doubt))


def _truth(truth: Interval, doubt: Any) -> Outcome:
    """A truth value, in doubt where it is undecided."""
    return Outcome(truth, np.where(truth.undecided, doubt, NO_DOUBT) if np.any(truth.undecided) else NO_DOUBT)


def _doubts(outcomes: list[Outcome]) -> Any:
    return reduce(np.bitwise_or, [outcome.doubt for outcome in outcomes], NO_DOUBT)
