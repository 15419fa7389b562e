"""Writes the module of a pass: its stages, fused, as compiled loops over vertices and over the pixels of some rows."""

from collections.abc import Collection, Iterable, Mapping
from typing import Any, get_origin

from sss_ref.interpret.kernel.arguments import OUT, Arguments
from sss_ref.interpret.kernel.lower import INDENT, Lines, Lowering, Memory, Scalar, Value, channels, suffixes
from sss_ref.language.pipeline import CLIP_POSITION, PIXEL, Draw, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import Texture

HEADER = '''"""Pass {name}: {stages}. Written by sss_ref from the stages; do not edit."""

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.scalar import exp2_scalar, exp_scalar, log2_scalar, pow_scalar
from sss_ref.raster.interpolate import barycentric

'''

RESERVED = ("row", "column", "width", "step", "piece", "primitives", "here")
CORNER_NAMES = ("a", "b", "c", "wa", "wb", "wc", "weight", "varying")
CORNERS = (
    "a, b, c = primitives.corners[here, 0], primitives.corners[here, 1], primitives.corners[here, 2]",
    "wa, wb, wc = barycentric(primitives, here, column, row, step)",
    "weight = (wa + wb) + wc",
    "varying = primitives.attributes",
)
INTERPOLATED = "((varying[a, {k}] * wa + varying[b, {k}] * wb) + varying[c, {k}] * wc) / weight"  # rule R5


def vertex_source(this_pass: Pass, varyings: Mapping[str, int]) -> str:
    """The source of the module with `vertices`; varyings: the wanted ones -> their first attribute column."""
    (stage,), lines = this_pass.draw.vertex_stages, Lines(depth=2)
    return _module(this_pass, (stage,), vertex_function(stage, varyings, lines), lines)


def fragment_source(
    this_pass: Pass, buffers: Collection[str], outputs: Collection[str], varyings: Mapping[str, int]
) -> str:
    """The source of the module with `fragments`.

    buffers: the names it reads from earlier passes; outputs: those it is to fill; varyings: first attribute column.
    """
    arguments = Arguments.of_fragments(this_pass, buffers, outputs)
    writer = _FragmentLoop(this_pass, arguments, list(outputs), varyings)
    return _module(this_pass, this_pass.stages, writer.function(), writer.lines)


def _module(this_pass: Pass, stages: Iterable[Stage], function: str, lines: Lines) -> str:
    constants = "".join(f"{name} = {value}\n" for name, value in sorted(lines.literals.items()))
    header = HEADER.format(name=this_pass.name, stages=", ".join(stage.name for stage in stages))
    return header + constants + "\n\n" + function


def unpacked(arguments: Arguments, lines: Lines) -> dict[str, Value]:
    """The uniforms as values: the packed ones taken out of their array before the loop."""
    values: dict[str, Value] = {
        name: [lines.bind(name + end, Scalar(element, True, False)) for end, element in slots]
        for name, slots in arguments.slots.items()
    }
    for name in arguments.loose:
        kind = arguments.reads[name]
        if name not in arguments.arrays:
            values[name] = [Scalar(name, True, True)] if kind is int else Memory(name, kind)
    return values


def vertex_function(stage: Stage, varyings: Mapping[str, int], lines: Lines) -> str:
    """`vertices`, which fills `clip_position` and `attributes`."""
    arguments = Arguments.of_vertices(stage)
    for name in arguments.loose:
        lines.fresh(name)
    values = unpacked(arguments, lines)
    for name in (name for name in arguments.loose if name in arguments.arrays):
        ends = enumerate(suffixes(arguments.reads[name]))
        values[name] = [lines.bind(name + end, Scalar(f"{name}[vertex, {k}]", False, False)) for k, end in ends]
    names = {own: values[name] for own, name in stage.reads.items()}
    results = Lowering(lines, names).run(stage.body)
    for k, value in enumerate(results[CLIP_POSITION]):
        lines.add(f"clip_position[vertex, {k}] = {value.text}")
    for own, scalars in results.items():
        for k, value in enumerate(scalars if stage.writes[own] in varyings else []):
            lines.add(f"attributes[vertex, {varyings[stage.writes[own]] + k}] = {value.text}")
    loop = f"{INDENT}for vertex in range(len(clip_position)):"
    return _function("vertices", arguments, [*(INDENT + line for line in lines.before), loop, *lines.inside])


def _function(name: str, arguments: Arguments, body: list[str]) -> str:
    return f"@compiled\ndef {name}({arguments.signature}):\n" + "\n".join(body) + "\n"


class _FragmentLoop:
    """Writes `fragments`, which fills the outputs on some rows."""

    def __init__(self, this_pass: Pass, arguments: Arguments, outputs: list[str], varyings: Mapping[str, int]) -> None:
        self.this_pass, self.arguments, self.outputs, self.varyings = this_pass, arguments, outputs, varyings
        self.lines = Lines(depth=3)
        self.values: dict[str, Value] = {}
        for taken in (*RESERVED, *CORNER_NAMES, *this_pass.reads):
            self.lines.fresh(taken)

    def function(self) -> str:
        """The whole function."""
        self.values |= unpacked(self.arguments, self.lines)
        self.values[PIXEL] = [Scalar("column", False, True), Scalar("row", False, True)]
        draw = self.this_pass.draw
        if draw.vertex_stages:
            self.interpolation(draw)
        for stage in self.this_pass.stages:
            self.stage(stage)
        self.stores()
        loop = [
            *(INDENT + line for line in self.lines.before),
            f"{INDENT}for row in range(row0, row1):",
            f"{INDENT * 2}for column in range(width):",
            *self.skip(),
            *self.lines.inside,
        ]
        return _function("fragments", self.arguments, loop)

    def skip(self) -> list[str]:
        """Leave a pixel without fragment to the background."""
        if self.this_pass.draw.vertex_stages:
            test = [INDENT * 3 + "here = piece[row, column]", INDENT * 3 + "if here < 0:"]
        elif self.this_pass.draw.stencil:
            test = [INDENT * 3 + "if stencil[row, column] == 0:"]
        else:
            return []
        pairs = [(name, channel) for name in self.outputs for channel in channels(self.this_pass.values[name])]
        clear = [
            f"{INDENT * 4}{OUT}{name}[row, column{channel}] = background[{k}]"
            for k, (name, channel) in enumerate(pairs)
        ]
        return [*test, *clear, INDENT * 4 + "continue"]

    def interpolation(self, draw: Draw) -> None:
        """The varyings of this fragment."""
        for line in CORNERS:
            self.lines.add(line)
        for name, first in self.varyings.items():
            ends = enumerate(suffixes(draw.varyings[name]))
            texts = [(end, INTERPOLATED.format(k=first + k)) for k, end in ends]
            self.values[name] = [self.lines.bind(name + end, Scalar(text, False, False)) for end, text in texts]
        self.values[draw.triangle] = [Scalar("primitives.triangle[here]", False, False)]
        self.values[draw.coverage] = [Scalar("1", False, True)]

    def stage(self, stage: Stage) -> None:
        """One stage, in its own scope; its outputs are there for the stages after it."""
        self.lines.add(f"# {stage.name}")
        names = {own: self.read(stage.reads[own], kind) for own, kind in stage.parameters.items()}
        results = Lowering(self.lines, names, prefix=f"{stage.name}_").run(stage.body)
        for own, scalars in results.items():
            ends = suffixes(stage.outputs[own])
            name = stage.writes[own]
            pairs = zip(scalars, ends, strict=True)
            self.values[name] = [self.lines.bind(f"{name}{end}", per_fragment(value)) for value, end in pairs]

    def read(self, name: str, kind: Any) -> Value:
        """What a stage reads under a name, as in the array interpreter."""
        if get_origin(kind) is Texture:
            return Memory(name, kind)
        if name not in self.values:
            self.values[name] = self.own_pixel(name, kind)
        return self.values[name]

    def own_pixel(self, name: str, kind: Any) -> list[Scalar]:
        """A buffer's value at this very pixel."""
        test = " != 0" if kind is bool else ""
        return [
            self.lines.bind(f"{name}_here{end}", Scalar(f"{name}[row, column{channel}]{test}", False, False))
            for channel, end in zip(channels(kind), suffixes(kind), strict=True)
        ]

    def stores(self) -> None:
        """Write the outputs that are wanted."""
        for name in self.outputs:
            value = self.values[name]
            assert isinstance(value, list)
            for channel, scalar in zip(channels(self.this_pass.values[name]), value, strict=True):
                self.lines.add(f"{OUT}{name}[row, column{channel}] = {scalar.text}")


def per_fragment(value: Scalar) -> Scalar:
    """An output is a value of the fragment even where it depends on uniforms alone."""
    return Scalar(value.text, False, value.atomic)
