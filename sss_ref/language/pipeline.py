"""What stages are assembled into: a draw or a full-screen rectangle, a pass, a method."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from sss_ref.language.stage import Stage

CLIP_POSITION = "clip_position"  # the one output of a vertex stage that is no varying: GLSL's gl_Position
MESH_ATTRIBUTES = ("position", "normal", "uv")  # what a vertex stage may read of its vertex, in model space
REGISTERS = "registers"  # the group of all values that a pass computes on the way and no buffer keeps
PIXEL = "pixel"  # the built-in input of every fragment: ivec2(column, row), row 0 at the bottom


@dataclass(frozen=True)
class MeshDraw:
    """The mesh, rasterized from one view with depth test LESS.

    vertex: stage over the vertices; its outputs but `clip_position` are varyings, interpolated for each fragment.
    triangle, depth, coverage: the buffers that the rasterizer itself writes, by their names ("" = none).
    layout: whether triangles lie side by side in the picture (a UV layout), so that covering a sample twice is an
        accident, for which the scene has a policy.
    """

    vertex: Stage
    triangle: str = ""
    depth: str = ""
    coverage: str = ""
    layout: bool = False

    @property
    def varyings(self) -> dict[str, Any]:
        """Varying -> type, by the names that fragment stages read."""
        return {self.vertex.writes[own]: kind for own, kind in self.vertex.outputs.items() if own != CLIP_POSITION}

    @property
    def reads(self) -> dict[str, Any]:
        """Name -> type of what the vertex stage reads beside its vertex: uniforms, and buffers of earlier passes."""
        read = {self.vertex.reads[own]: kind for own, kind in self.vertex.parameters.items()}
        return {name: kind for name, kind in read.items() if name not in MESH_ATTRIBUTES}

    @property
    def outputs(self) -> dict[str, Any]:
        """Buffer -> type of what the rasterizer writes."""
        named = {self.triangle: int, self.depth: float, self.coverage: bool}
        return {name: kind for name, kind in named.items() if name}


@dataclass(frozen=True)
class ScreenDraw:
    """A rectangle of exactly the size of the target; `stencil` names a buffer that limits it to where that is 1."""

    stencil: str = ""

    @property
    def varyings(self) -> dict[str, Any]:
        """A rectangle interpolates nothing."""
        return {}

    @property
    def reads(self) -> dict[str, Any]:
        """The stencil, if there is one."""
        return {self.stencil: bool} if self.stencil else {}

    @property
    def outputs(self) -> dict[str, Any]:
        """A rectangle writes nothing but what its stages do."""
        return {}


@dataclass(frozen=True)
class Pass:
    """Stages that run one after the other on every fragment of one draw.

    target: the scene table that has its width and height. on_demand: not part of "all" buffers, run if asked for.
    registers: prefixes of the names that stages hand on inside the pass and that are no buffers; a GPU has them in its
        registers alone, unless a shader is told to write them.
    rounds, feedback: a pass that runs several times: before each round but the first, an output (value) takes the place
        of an input (key); with no round at all the outputs are the inputs.
    """

    name: str
    target: str
    draw: MeshDraw | ScreenDraw
    stages: tuple[Stage, ...]
    on_demand: bool = False
    registers: tuple[str, ...] = ()
    rounds: int = 1
    feedback: Mapping[str, str] = field(default_factory=dict)

    @property
    def values(self) -> dict[str, Any]:
        """Name -> type of everything the draw and the stages give, in stage order."""
        written = {s.writes[own]: kind for s in self.stages for own, kind in s.outputs.items()}
        return self.draw.outputs | written

    @property
    def outputs(self) -> dict[str, Any]:
        """Buffer -> type of everything this pass can write, in stage order."""
        return {name: kind for name, kind in self.values.items() if not name.startswith(self.registers)}

    def only(self, wanted: set[str]) -> "Pass":
        """The same pass with just the stages that `wanted` outputs depend on."""
        needed = set(wanted)
        stages: list[Stage] = []
        for stage in reversed(self.stages):
            if needed & set(stage.writes.values()):
                needed |= set(stage.reads.values())
                stages.insert(0, stage)
        return replace(self, stages=tuple(stages))

    @property
    def reads(self) -> dict[str, Any]:
        """Name -> type of what the stages read from outside: uniforms, and buffers of earlier passes."""
        inside = {*self.values, *self.draw.varyings, PIXEL}
        read = {stage.reads[own]: kind for stage in self.stages for own, kind in stage.parameters.items()}
        return {name: kind for name, kind in sorted(read.items()) if name not in inside}

    @property
    def needs(self) -> set[str]:
        """What must be there before the pass runs: what the draw and the stages read."""
        return {*self.reads, *self.draw.reads}


@dataclass(frozen=True)
class Method:
    """A named tuple of passes, folded over a dictionary of buffers."""

    name: str
    passes: tuple[Pass, ...]

    @property
    def outputs(self) -> Mapping[str, Any]:
        """Buffer -> type of everything the method writes unless told otherwise, in order."""
        return {name: kind for one in self.passes if not one.on_demand for name, kind in one.outputs.items()}

    @property
    def values(self) -> Mapping[str, Any]:
        """Name -> type of everything the method can write, in order: `outputs`, and what it has on demand."""
        return {name: kind for one in self.passes for name, kind in one.values.items()}

    def only(self, wanted: set[str]) -> "Method":
        """The same method with just the passes and stages that `wanted` buffers depend on."""
        needed = set(wanted)
        passes: list[Pass] = []
        for one in reversed(self.passes):
            if needed & set(one.values):
                passes.insert(0, one.only(needed))
                needed |= passes[0].needs
        return replace(self, passes=tuple(passes))

    @property
    def on_demand(self) -> dict[str, list[str]]:
        """Group -> names that are written only if asked for: each pass on demand, and the registers of all passes."""
        passes = {one.name: list(one.outputs) for one in self.passes if one.on_demand}
        return passes | {REGISTERS: [name for one in self.passes for name in one.values if name not in one.outputs]}
