"""Stages where rays are parallel: what a stage computes for a light, or an eye, that is infinitely far away.

A stage that takes rays from one point O, a light's position or the camera's, asks three things of them: the direction
towards O, the direction away from it, and the distance from it. Where all rays go the same way, each has one answer:

    normalize(O - P)  ->  -direction                 normalize(P - O)  ->  direction
    length(P - O), length(O - P)  ->  dot(P - O, direction)

So no such stage is written twice. The distance counts from the plane through O at right angles to the direction.
"""

from dataclasses import dataclass, replace
from typing import Any, cast

from sss_ref.errors import StageError
from sss_ref.language import tree
from sss_ref.language.builtins import dot, length, normalize
from sss_ref.language.names import Name
from sss_ref.language.stage import Stage
from sss_ref.language.types import vec3

DOT = cast(tree.Callee, dot)


@dataclass(frozen=True)
class Rays:
    """Parallel rays, by names: `origin`, the uniform of the point they came from, `direction`, that of their way.

    suffix: what is added to the name of a stage.
    """

    origin: str
    direction: str
    suffix: str

    def of(self, stage: Stage) -> Stage:
        """The stage for these rays; as it is where it reads no origin, or reads the direction by itself.

        Raises StageError where it asks the origin for something else.
        """
        own = next((own for own, name in stage.reads.items() if name == self.origin), "")
        if not own or self.direction in stage.reads.values():
            return stage
        direction = tree.Variable(vec3, _free(Name.of(self.direction).base, stage.body))
        body = _Turning(stage.name, own, direction).of_body(stage.body)
        named = {**stage.reads, direction.name: self.direction}
        name, told = stage.variant
        variant = (name + self.suffix, f"{told} The rays of {own} are parallel, along {direction.name}.".strip())
        return replace(stage, body=body, reads={each: named[each] for each in body.parameters}, variant=variant)


@dataclass(frozen=True)
class _Turning:
    """The body of a stage being rewritten. origin, direction: the stage's own names for them."""

    name: str
    origin: str
    direction: tree.Variable

    def of_body(self, body: tree.Body) -> tree.Body:
        """The body for parallel rays; its parameters are those that it still reads, the direction behind the origin."""
        turned = tree.mapped(body, self.put)
        read = {name for expression in tree.expressions(turned) for name in tree.names_in(expression)}
        parameters: dict[str, Any] = {}
        for own, kind in body.parameters.items():
            parameters |= {own: kind} if own != self.origin or own in read else {}
            parameters |= {self.direction.name: vec3} if own == self.origin else {}
        return replace(turned, parameters=parameters)

    def put(self, expression: tree.Expression) -> tree.Expression:
        """An expression with all that it asks of the origin answered. Raises StageError for any other question."""
        if isinstance(expression, tree.Variable) and expression.name == self.origin:
            raise StageError(
                f"stage {self.name}: expected {self.origin} as O in normalize(O - P), normalize(P - O) or "
                f"length(P - O) where rays are parallel, got it elsewhere; let the stage read {self.direction.name} too"
            )
        match expression:
            case tree.Call(callee=callee, arguments=(tree.Operation(operator="-", operands=(first, second)),)):
                if callee in (length, normalize) and self.origin in map(name_of, (first, second)):
                    return self.answer(callee, first, second)
        for k, child in enumerate(tree.children(expression)):
            changed = self.put(child)
            expression = expression if changed is child else tree.with_child(expression, k, changed)
        return expression

    def answer(self, callee: Any, first: tree.Expression, second: tree.Expression) -> tree.Expression:
        """What stands for normalize(first - second) or length(first - second), one of them being the origin."""
        towards = name_of(first) == self.origin
        if callee == normalize:
            return tree.Operation(vec3, "neg", (self.direction,)) if towards else self.direction
        point, origin = (second, first) if towards else (first, second)
        away = tree.Operation(vec3, "-", (self.put(point), origin))
        return tree.Call(float, DOT, (away, self.direction), DOT.body((vec3, vec3)))


def _free(name: str, body: tree.Body) -> str:
    """A name that a body has not given yet."""
    taken = {*body.parameters, *(each.name for each in body.statements if isinstance(each, tree.Assign))}
    return name if name not in taken else _free(f"{name}_", body)


def name_of(expression: tree.Expression) -> str:
    """The name that an expression is, or ""."""
    return expression.name if isinstance(expression, tree.Variable) else ""
