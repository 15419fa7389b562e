"""Compiling stages before anybody runs them."""

from collections.abc import Collection
from typing import get_origin

from sss_ref.interpret.kernel import fragment_rows
from sss_ref.interpret.kernel.elementary_rows import ELEMENTARY_ROWS
from sss_ref.interpret.kernel.modules import address_of, code_of
from sss_ref.language.pipeline import MESH_ATTRIBUTES, PIXEL, Method
from sss_ref.language.stage import Stage
from sss_ref.language.types import Array, Texture


def compile_method(method: Method) -> None:
    """Compile all stages of a method, as its passes run them."""
    for each in method.passes:
        there = {PIXEL, *MESH_ATTRIBUTES, *each.draw.varyings, *method.values}
        for stage in (*each.draw.vertex_stages, *each.stages):
            compile_stage(stage, there)


def compile_alone(stages: Collection[Stage]) -> None:
    """Compile stages that no method at hand has; what none of them writes is a uniform."""
    there = {PIXEL, *MESH_ATTRIBUTES, *(name for stage in stages for name in stage.writes.values())}
    for stage in stages:
        compile_stage(stage, there)


def compile_stage(stage: Stage, there: Collection[str]) -> None:
    """Compile a stage; there: the names of all that differs between fragments."""
    values = [own for own, kind in stage.parameters.items() if get_origin(kind) not in (Texture, Array)]
    code_of(stage, frozenset(own for own in values if stage.reads[own] not in there))


def compile_rows() -> None:
    """Compile what passes call beside their stages."""
    for function in (*fragment_rows.ALL, *ELEMENTARY_ROWS.values()):
        address_of(function)
