"""The arguments of a generated function, listed once: its signature is written and its calls are made from the list."""

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np

from sss_ref.interpret.kernel.lower import suffixes
from sss_ref.language.layout import FLOAT32
from sss_ref.language.pipeline import MESH_ATTRIBUTES, Draw, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import mat3, mat4, vec2, vec3, vec4

FLOATS: dict[Any, list[str]] = {  # type -> how its floats are named
    **{kind: suffixes(kind) for kind in (float, vec2, vec3, vec4)},
    mat3: [f"_{row}{column}" for row in range(3) for column in range(3)],
    mat4: [f"_{row}{column}" for row in range(4) for column in range(4)],
}
UNIFORMS = "uniforms"  # the float32 array that holds all uniforms made of floats, one after the other
OUT = "out_"  # how the name of an array to fill begins; the buffer's name follows


@dataclass(frozen=True)
class Arguments:
    """What a function takes, in order: `drawn`, the uniforms, whatever else its stages read, `filled`.

    drawn: what it is told of the draw. reads: name -> type of what its stages read from outside.
    arrays: those that are no uniforms, but attributes of the mesh or buffers. filled: what it fills, and with what.
    """

    drawn: tuple[str, ...]
    reads: Mapping[str, Any]
    arrays: Collection[str]
    filled: tuple[str, ...]

    @classmethod
    def of_vertices(cls, stage: Stage) -> "Arguments":
        """Those of `vertices`, which runs a vertex stage."""
        return cls((), vertex_reads(stage), MESH_ATTRIBUTES, ("clip_position", "attributes"))

    @classmethod
    def of_fragments(cls, this_pass: Pass, buffers: Collection[str], outputs: Iterable[str]) -> "Arguments":
        """Those of `fragments`, which runs the stages of a pass on the rows row0 to row1 - 1.

        buffers: the names it reads from earlier passes; outputs: those it is to fill.
        """
        drawn = ("row0", "row1", "width", *_of_draw(this_pass.draw))
        return cls(drawn, this_pass.reads, buffers, (*(OUT + name for name in outputs), "background"))

    @property
    def packed(self) -> list[str]:
        """The uniforms that come together in one array, in the order in which they lie there."""
        return [name for name, kind in self.reads.items() if name not in self.arrays and kind in FLOATS]

    @property
    def loose(self) -> list[str]:
        """What the stages read that has an argument of its own: attributes, buffers, uniform arrays and integers."""
        together = set(self.packed)
        return [name for name in self.reads if name not in together]

    @property
    def slots(self) -> dict[str, list[tuple[str, str]]]:
        """Packed uniform -> the suffix of each of its floats, and the element that holds it."""
        elements = (f"{UNIFORMS}[{k}]" for k in count())
        return {name: [(end, next(elements)) for end in FLOATS[self.reads[name]]] for name in self.packed}

    @property
    def names(self) -> list[str]:
        """All of them."""
        return [*self.drawn, UNIFORMS, *self.loose, *self.filled]

    @property
    def signature(self) -> str:
        """What stands in the parentheses of the definition."""
        return ", ".join(self.names)

    def bound(
        self, function: Callable[..., None], read: Mapping[str, Any], own: Mapping[str, Any]
    ) -> Callable[..., None]:
        """A function of these arguments with its values; those that are missing are given in the call, by name.

        read: name -> value of what the stages read. own: argument -> value of what is drawn and filled.
        """
        uniforms = np.concatenate([np.empty(0, FLOAT32), *(np.ravel(read[name]) for name in self.packed)])
        names, values = self.names, {name: read[name] for name in self.loose} | {UNIFORMS: uniforms, **own}

        def call(**missing: Any) -> None:
            function(*({**values, **missing}[name] for name in names))

        return call


def vertex_reads(stage: Stage) -> dict[str, Any]:
    """Name -> type of what `vertices` reads: attributes of the mesh, uniforms and textures."""
    return {stage.reads[own]: kind for own, kind in stage.parameters.items()}


def _of_draw(draw: Draw) -> tuple[str, ...]:
    """What tells where a draw has fragments."""
    if draw.vertex_stages:
        return "piece", "primitives", "step"
    return ("stencil",) if draw.stencil else ()
