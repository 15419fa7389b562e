"""The lines of a stage as its shader has them."""

from collections.abc import Callable

from sss_ref.explanation.traces import StageTrace
from sss_ref.interpret.shader import GLSL
from sss_ref.interpret.shader.expressions import Expressions
from sss_ref.interpret.shader.library import Library, local
from sss_ref.interpret.trace import Step
from sss_ref.language.tree import names_in
from sss_ref.language.types import Array

Translate = Callable[[Step], str]


def glsl_lines(traced: StageTrace) -> Translate:
    """What makes GLSL of the lines of a stage, and of the functions it calls; of all other steps nothing."""
    reads = zip(traced.stage.parameters, traced.reads.values(), strict=True)
    lengths = {own: len(value.data) for own, value in reads if isinstance(value, Array)}
    short = {own: length for own, length in lengths.items() if length <= GLSL.longest_array}
    expressions = Expressions(Library(GLSL), short)

    def translate(step: Step) -> str:
        if isinstance(step.source, str) or not step.name:
            return ""
        accumulates = step.name in names_in(step.source)
        left = GLSL.name(step.name) if accumulates else local(GLSL, step.name, step.source)
        return f"{left} = {expressions.text(step.source)};"

    return translate
