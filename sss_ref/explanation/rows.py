"""An explanation as a list of headed tables, for the terminal and for a page alike."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from sss_ref.errors import SceneError
from sss_ref.explanation.shader_lines import Translate, glsl_lines
from sss_ref.explanation.traces import PassTrace, StageTrace, TriangleTrace
from sss_ref.explanation.values import between, bits, shown
from sss_ref.interpret.trace import Bounds, Step
from sss_ref.language.pipeline import MESH_ATTRIBUTES
from sss_ref.language.types import mat3, mat4, vec3, vec4
from sss_ref.passes.buffers import described, is_listed


@dataclass(frozen=True)
class Row:
    """A line of a table.

    depth: how far it is indented. kind: "read", "line", "call", "turn" or "got". glsl: in GLSL. bounds: what the value
    may be at least and at most on another processor; None where that was not asked for.
    """

    kind: str
    depth: int
    text: str
    value: str = ""
    bits: str = ""
    unit: str = ""
    glsl: str = ""
    bounds: Bounds | None = None

    @property
    def may_be(self) -> str:
        """The bounds as text."""
        return between(self.bounds) if self.bounds else ""


@dataclass(frozen=True)
class Detail:
    """How much is shown; see `sections`."""

    depth: int
    glsl: bool


@dataclass
class Section:
    """A pass (level 1), or a stage or draw in it (level 2), with what it says about itself."""

    level: int
    title: str
    note: str
    rows: list[Row] = field(default_factory=list)

    @property
    def has_bounds(self) -> bool:
        """Whether it was asked what the values may be on another processor."""
        return any(row.bounds for row in self.rows)


def sections(
    passes: Sequence[PassTrace], stage: str | None = None, depth: int = 1, glsl: bool = False
) -> list[Section]:
    """The tables of what made a pixel.

    stage: show this one only. depth: how many calls inside each other are opened; 1 shows what the calls in a line of
    a stage give, 2 also the lines of those functions. glsl: with every line as the shader has it.
    Raises SceneError for a stage that is not there.
    """
    detail = Detail(depth, glsl)
    found = [section for each in passes for section in _of_pass(each, detail)]
    if stage is None:
        return found
    chosen = [section for section in found if section.level == 2 and section.title.split()[0] == stage]
    if not chosen:
        names = dict.fromkeys(traced.stage.name for each in passes for traced in each.stages)
        raise SceneError(f"stage: expected one of {', '.join(names)}, got {stage!r}; none of that name made this pixel")
    return chosen


def _of_pass(this_pass: PassTrace, detail: Detail) -> Iterator[Section]:
    at = "" if this_pass.place.pixel is None else f"pixel {this_pass.place.pixel[0]},{this_pass.place.pixel[1]}: "
    yield Section(1, f"pass {this_pass.name}", at + this_pass.place.reason)
    if this_pass.drawn:
        told: set[str] = set()  # the uniforms are the same at every corner
        for vertex in this_pass.drawn.vertices:
            yield section_of(vertex, detail, told)
            told = set(vertex.reads) - set(MESH_ATTRIBUTES)
        yield _of_draw(this_pass.drawn)
    for traced in this_pass.stages:
        yield section_of(traced, detail)


def _of_draw(drawn: TriangleTrace) -> Section:
    """The triangle, the weights of its corners, and what is interpolated."""
    cut = " (a piece of it: the clipper has cut it, and its corners are new vertices)" if drawn.clipped else ""
    section = Section(2, f"triangle {drawn.triangle}", f"rules R1 to R5{cut}")
    total = sum(float(corner.weight) for corner in drawn.corners)
    for corner in drawn.corners:
        share = f"{float(corner.weight) / total:.1%} of the three"
        section.rows.append(row_of("read", f"weight of corner {corner.vertex}", corner.weight, unit=share))
    section.rows += [row_of("line", name, value) for name, value in drawn.values.items()]
    return section


def section_of(traced: StageTrace, detail: Detail, told: Collection[str] = ()) -> Section:
    """A stage: what it reads, but for what was told before, and its lines."""
    about = traced.stage.description
    where = f" at {traced.at}" if traced.at else ""
    section = Section(2, traced.stage.name + where, f"{traced.stage.source}. {about.splitlines()[0]}")
    for own, name in traced.stage.reads.items():
        if name not in told:
            called = name if name == own else f"{own} = {name}"  # the lines call it as the stage does
            section.rows += _of_read(called, traced.reads[name], traced.bounds.get(name))
    units = {name: described(name).unit for name in traced.writes if is_listed(name)}
    glsl = glsl_lines(traced) if detail.glsl else lambda step: ""
    section.rows += [row for step in traced.steps for row in _of_step(step, 0, detail.depth, units, glsl)]
    return section


def _of_read(name: str, value: Any, bounds: Bounds | None) -> Iterator[Row]:
    """A value that a stage reads; matrices row by row."""
    yield replace(row_of("read", name, value), bounds=bounds)
    if isinstance(value, mat3 | mat4):
        yield from (row_of("read", f"row {k}", (vec3, vec4)[len(row) - 3](*row), 1) for k, row in enumerate(value.rows))


def _of_step(step: Step, indent: int, depth: int, units: Mapping[str, str], glsl: Translate) -> Iterator[Row]:
    """A step and, as far as `depth` allows, what is inside it."""
    is_loop = isinstance(step.source, str)
    kind = "turn" if is_loop else "line" if step.name else "call"
    if step.text == step.name:
        return  # a value returned under the name it has
    text = f"{step.name} = {step.text}" if step.name else step.text
    row = Row(kind, indent, text) if is_loop else row_of(kind, text, step.value, indent, units.get(step.name, ""))
    yield replace(row, glsl=glsl(step), bounds=step.bounds)
    left = depth - (kind == "call")
    for inner in step.inner if left > 0 or is_loop else ():
        if inner.source is step.source:  # the whole line is one call, which gives what the line gives
            lines = inner.inner if left > 1 else ()
            yield from (row for line in lines for row in _of_step(line, indent + 1, left - 1, units, glsl))
        else:
            yield from _of_step(inner, indent + 1, left, units, glsl)


def row_of(kind: str, text: str, value: Any, indent: int = 0, unit: str = "") -> Row:
    """A row for a value of the language."""
    return Row(kind, indent, text, shown(value), bits(value), unit)
