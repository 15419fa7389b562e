"""What stages are assembled into: a draw or a full-screen rectangle, a pass, a method."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from sss_ref.language.names import INNER, Name
from sss_ref.language.stage import Stage

CLIP_POSITION = "clip_position"  # the one output of a vertex stage that is no varying: GLSL's gl_Position
MESH_ATTRIBUTES = ("position", "normal", "uv", "tangent")  # what a vertex stage may read of its vertex, in model space
MESH, INNER_MESH = "mesh", str(Name("mesh", body=INNER))  # the surface, and that of a body inside it
REGISTERS = "registers"  # the group of all values that a pass computes on the way and no buffer keeps
PIXEL = "pixel"  # the built-in input of every fragment: ivec2(column, row), row 0 at the bottom

T = TypeVar("T")


@dataclass(frozen=True)
class MeshDraw:
    """The mesh, rasterized from one view with depth test LESS.

    vertex: stage over the vertices; its outputs but `clip_position` are varyings, interpolated for each fragment.
    triangle, depth, coverage: the buffers that the rasterizer itself writes, by their names ("" = none).
    layout: whether triangles lie side by side in the picture (a UV layout), so that covering a sample twice is an
        accident, for which the scene has a policy.
    mesh: which one is drawn, MESH or INNER_MESH.
    """

    vertex: Stage
    triangle: str = ""
    depth: str = ""
    coverage: str = ""
    layout: bool = False
    mesh: str = MESH
    stencil = ""  # it is limited by nothing but the mesh

    @property
    def vertex_stages(self) -> tuple[Stage, ...]:
        """The stages that run on vertices: one."""
        return (self.vertex,)

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

    @property
    def extent(self) -> str:
        """The buffer that says where fragments are, or ""."""
        return self.triangle or self.coverage

    def covered_by(self, reads: set[str]) -> set[str]:
        """The buffer that decides whether stages that read these names run: none if they read no varying."""
        return {self.extent} if reads & set(self.varyings) else set()

    def renamed(self, rename: Callable[[str], str]) -> "MeshDraw":
        """The same draw with the names of what it reads and writes replaced."""
        triangle, depth, coverage = map(rename, (self.triangle, self.depth, self.coverage))
        vertex = self.vertex.renamed(rename)
        return replace(self, vertex=vertex, triangle=triangle, depth=depth, coverage=coverage)


@dataclass(frozen=True)
class ScreenDraw:
    """A rectangle of exactly the size of the target; `stencil` names a buffer that limits it to where that is 1."""

    stencil: str = ""
    triangle = depth = coverage = ""  # no rasterizer writes anything
    mesh = ""
    layout = False

    @property
    def vertex_stages(self) -> tuple[Stage, ...]:
        """A rectangle has no vertices to be shaded."""
        return ()

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

    @property
    def extent(self) -> str:
        """The buffer that says where fragments are, or "" where they are everywhere."""
        return self.stencil

    def covered_by(self, reads: set[str]) -> set[str]:
        """The stencil, whatever the stages read."""
        return set(self.reads)

    def renamed(self, rename: Callable[[str], str]) -> "ScreenDraw":
        """The same draw with the name of its stencil replaced."""
        return replace(self, stencil=rename(self.stencil))


Draw = MeshDraw | ScreenDraw


@dataclass(frozen=True)
class Pass:
    """Stages that run one after the other on every fragment of one draw.

    target: the scene table that has its width and height. on_demand: not part of "all" buffers, run if asked for.
    registers: names that stages hand on inside the pass and that are no buffers, beside those that say so themselves
        (`Name.is_register`); a GPU has them in its registers alone, unless a shader is told to write them.
    rounds, feedback: a pass that runs several times: before each round but the first, an output (value) takes the place
        of an input (key); with no round at all the outputs are the inputs. Only `folded` reads them.
    """

    name: str
    target: str
    draw: Draw
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
        return {name: kind for name, kind in self.values.items() if not self.is_register(name)}

    def is_register(self, name: str) -> bool:
        """Whether a value of the pass is none of its buffers."""
        return Name.of(name).is_register or name in self.registers

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

    @property
    def fed_back(self) -> dict[str, Any]:
        """Output -> type of those that the pass gives even where it runs no round; empty where it runs just once."""
        return {own: self.values[own] for own in self.feedback.values()}

    def folded(self, there: Mapping[str, T], run: Callable[[Mapping[str, T]], Mapping[str, T]]) -> Mapping[str, T]:
        """Run the pass as often as it has rounds; what it gives, by name.

        there: name -> what the first round reads, be it a buffer, a texture or bounds. run: one round.
        """
        outputs: Mapping[str, T] = {own: there[name] for name, own in self.feedback.items()}
        for _ in range(self.rounds):
            outputs = run({**there, **{name: outputs[own] for name, own in self.feedback.items()}})
        return outputs

    @property
    def repetition(self) -> dict[str, Any]:
        """How `folded` runs it, as JSON has it, for a program that folds in another language."""
        return {"rounds": self.rounds, "feedback": dict(self.feedback)}

    def renamed(self, rename: Callable[[str], str]) -> "Pass":
        """The same pass with every name in it replaced, but its own."""
        return replace(
            self,
            draw=self.draw.renamed(rename),
            stages=tuple(stage.renamed(rename) for stage in self.stages),
            registers=tuple(map(rename, self.registers)),
            feedback={rename(name): rename(own) for name, own in self.feedback.items()},
        )


@dataclass(frozen=True)
class Method:
    """A named tuple of passes, folded over a dictionary of buffers.

    constants: the uniforms that the choice of stages decides -> float.
    """

    name: str
    passes: tuple[Pass, ...]
    constants: Mapping[str, float] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Pass:
        """The pass of a name."""
        return next(each for each in self.passes if each.name == name)

    @property
    def stages(self) -> dict[str, Stage]:
        """Name -> stage of all fragment stages; of one that runs for several lights, the last."""
        return {stage.name: stage for each in self.passes for stage in each.stages}

    @property
    def outputs(self) -> Mapping[str, Any]:
        """Buffer -> type of everything the method writes unless told otherwise, in order."""
        return {name: kind for each in self.passes if not each.on_demand for name, kind in each.outputs.items()}

    @property
    def values(self) -> Mapping[str, Any]:
        """Name -> type of everything the method can write, in order: `outputs`, and what it has on demand."""
        return {name: kind for each in self.passes for name, kind in each.values.items()}

    def only(self, wanted: set[str]) -> "Method":
        """The same method with just the passes and stages that `wanted` buffers depend on."""
        needed = set(wanted)
        passes: list[Pass] = []
        for each in reversed(self.passes):
            if needed & set(each.values):
                passes.insert(0, each.only(needed))
                needed |= passes[0].needs
        return replace(self, passes=tuple(passes))

    def in_order(self) -> Iterator[tuple[Pass, set[str]]]:
        """Each pass, with the names that the passes after it read."""
        for number, each in enumerate(self.passes, start=1):
            yield each, {name for later in self.passes[number:] for name in later.needs}

    @property
    def on_demand(self) -> dict[str, list[str]]:
        """Group -> names that are written only if asked for: each pass on demand, and the registers of all passes."""
        passes = {each.name: list(each.outputs) for each in self.passes if each.on_demand}
        return passes | {REGISTERS: [name for each in self.passes for name in each.values if each.is_register(name)]}
