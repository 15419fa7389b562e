"""Stages for one fragment, line by line: what each line gives, and what the calls in it give.

The values are NumPy scalars of the array interpreter's kind, so every one has the bits of the buffers.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.language import tree
from sss_ref.language.evaluation import Evaluation
from sss_ref.language.notation import written
from sss_ref.language.stage import Stage
from sss_ref.language.types import Vector

Bounds = tuple[Any, Any]
TOLD = ("pow", "exp", "exp2", "log2", "texel")  # the primitives whose results are worth a line of their own


@dataclass(frozen=True)
class Step:
    """A line of a stage, or a call in it.

    name: what the line assigns, or "". source: the expression, or the head of a loop or the number of its turn as text.
    value: what it gives; None for loops. bounds: what it gives at least and at most on another processor, as values of
    the language, if that was asked for. inner: of a line the calls in it, of a call the lines of the function, of a
    loop its turns, of a turn its lines.
    """

    name: str
    source: tree.Expression | str
    value: Any
    inner: tuple["Step", ...] = ()
    bounds: Bounds | None = None

    @property
    def text(self) -> str:
        """The source as Python."""
        return self.source if isinstance(self.source, str) else written(self.source)


def trace(stage: Stage, inputs: Sequence[Any]) -> tuple[tuple[Step, ...], dict[str, Any]]:
    """Run a stage for one fragment; its steps, and buffer -> value of what it writes.

    inputs: one value of the language per parameter, in order, each a scalar or made of scalars.
    """
    lines = _Lines(dict(zip(stage.parameters, inputs, strict=True)))
    with np.errstate(all="ignore"):
        results = lines.run(stage.body, stage.writes)
    return tuple(lines.steps), {stage.writes[own]: value for own, value in results.items()}


class _Lines(Evaluation):
    """The lines of one body as they are run; `steps` grows, and `calls` holds those of the line at work."""

    def __init__(self, names: dict[str, Any]) -> None:
        super().__init__(names)
        self.steps: list[Step] = []
        self.calls: list[Step] = []

    def line(self, name: str, expression: tree.Expression) -> Any:
        """Evaluate an expression as a line of its own."""
        self.calls = []
        value = self.value(expression)
        self.steps.append(Step(name, expression, value, tuple(self.calls)))
        return value

    def loop(self, statement: tree.Loop) -> None:
        """Run a loop; its turns become steps of their own."""
        outside, turns = self.steps, []
        start, stop = self.value(statement.start), self.value(statement.stop)
        for index in range(start, stop):
            self.steps = []
            self.turn(statement, index)
            turns.append(Step(statement.index, str(index), None, tuple(self.steps)))
        self.steps = outside
        head = f"for {statement.index} in range({written(statement.start)}, {written(statement.stop)})"
        self.steps.append(Step("", head, None, tuple(turns)))

    def element(self, expression: tree.Element) -> Any:
        """An element of a uniform array is worth telling."""
        return self.told(expression, super().element(expression))

    def call(self, expression: tree.Call) -> Any:
        """A call of a primitive, or of a function with lines of its own."""
        arguments = list(map(self.value, expression.arguments))
        if expression.body is None:
            value = expression.callee(*arguments)
            return self.told(expression, value) if expression.callee.name in TOLD else value
        function = type(self)(dict(zip(expression.body.parameters, arguments, strict=True)))
        value = function.run(expression.body, {})["return"]
        return self.told(expression, value, tuple(function.steps))

    def told(self, expression: tree.Expression, value: Any, inner: tuple[Step, ...] = ()) -> Any:
        """Note what a part of the line at work gives."""
        self.calls.append(Step("", expression, value, inner))
        return value


def scalar(value: Any) -> Any:
    """A value of one fragment, which array code holds in arrays of one element."""
    if isinstance(value, Vector):
        return type(value)(*map(scalar, value))
    return value[0] if isinstance(value, np.ndarray) else value
