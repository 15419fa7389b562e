"""Complete shaders of a pass: what comes in, the stages' definitions, and a `main` that calls them in order."""

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from sss_ref.interpret.shader.dialect import GLSL
from sss_ref.interpret.shader.library import Library, comment, folded, indented, result_struct
from sss_ref.interpret.shader.reads import Reads
from sss_ref.language.pipeline import CLIP_POSITION, MESH_ATTRIBUTES, PIXEL, MeshDraw, Method, Pass, ScreenDraw
from sss_ref.language.stage import Stage

MOST_OUTPUTS = 8  # colour attachments that every OpenGL has
LONGEST_ARRAY = 64  # elements; OpenGL 3.3 promises room for 1024 numbers in all
VERSION = "#version 400 core"  # the first with `precise`: no sum reordered, nothing fused
OUT = "out_"  # how the name of a fragment shader's output begins; the buffer's name follows
RECTANGLE = [  # the whole target, as the four corners of a triangle strip
    "vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);",
    "gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);",
]


def draws(one: Pass, wanted: Collection[str], most: int = MOST_OUTPUTS) -> dict[str, tuple[str, ...]]:
    """The draws that fill the wanted buffers of a pass: name -> at most `most` buffers, in order.

    A draw has the name of its pass. Where there are several, each computes all that its own buffers need, and their
    names end in a number: camera_1, camera_2 ...
    """
    names = [name for name in one.outputs if name in wanted]
    parts = [tuple(names[first : first + most]) for first in range(0, len(names), most)]
    return {f"{one.name}_{k}" if len(parts) > 1 else one.name: part for k, part in enumerate(parts, 1)}


def shader_files(method: Method, lengths: Mapping[str, int]) -> dict[str, str]:
    """All shaders of a method: file name (PASS.vert, and DRAW.frag for each of its draws) -> source."""
    files: dict[str, str] = {}
    there: set[str] = set()
    for one in method.passes:
        files[f"{one.name}.vert"] = vertex_shader(one, lengths)
        for name, outputs in draws(one, one.outputs).items():
            files[f"{name}.frag"] = fragment_shader(one, there, outputs, lengths)
        there |= set(one.outputs)
    return files


def array_lengths(uniforms: Mapping[str, Any]) -> dict[str, int]:
    """Uniform array -> its length, of those short enough to be arrays of a shader; longer ones become textures."""
    return {name: len(value) for name, value in uniforms.items() if np.ndim(value) and len(value) <= LONGEST_ARRAY}


def vertex_shader(one: Pass, lengths: Mapping[str, int]) -> str:
    """The vertex shader of a pass; lengths: uniform array -> its length (an array that is not listed: a texture)."""
    about = f"Vertex shader of pass {one.name}, from the stages of sss_ref."
    library = Library(GLSL)
    if isinstance(one.draw, ScreenDraw):
        return _shader(about, [], library, RECTANGLE)
    stage = one.draw.vertex
    library.stage(stage, lengths)
    attributes = [f"in {GLSL.declared(kind, own)};" for own, kind in stage.parameters.items() if own in MESH_ATTRIBUTES]
    uniforms = Reads.of((stage,), MESH_ATTRIBUTES, ()).declarations(lengths)
    varyings = [f"precise out {GLSL.declared(kind, name)};" for name, kind in one.draw.varyings.items()]
    call = f"{stage.name}({', '.join(map(GLSL.name, stage.reads.values()))})"
    places = {own: "gl_Position" if own == CLIP_POSITION else GLSL.name(name) for own, name in stage.writes.items()}
    lines = [
        f"{result_struct(stage).__name__} vertex = {call};",
        *(f"{place} = vertex.{GLSL.name(own)};" for own, place in places.items()),
    ]
    return _shader(about, [attributes, uniforms, [*varyings, "precise gl_Position;"]], library, lines)


def fragment_shader(one: Pass, buffers: Collection[str], outputs: Collection[str], lengths: Mapping[str, int]) -> str:
    """The fragment shader that fills `outputs` of a pass, each by an `out` of its name.

    buffers: the names it reads from earlier passes. lengths: uniform array -> its length (of others: a texture).
    """
    one, library = one.only(set(outputs)), Library(GLSL)
    for stage in one.stages:
        library.stage(stage, lengths)
    read = {name for stage in one.stages for name in stage.reads.values()}
    reads = Reads.of(one.stages, {*one.values, *one.draw.varyings, PIXEL}, buffers)
    stencil = [one.draw.stencil] if isinstance(one.draw, ScreenDraw) and one.draw.stencil else []
    reads.textures |= dict.fromkeys(stencil, bool)
    varyings = [f"in {GLSL.declared(kind, name)};" for name, kind in one.draw.varyings.items() if name in read]
    written = [_output(k, name, one.outputs[name]) for k, name in enumerate(outputs)]
    lines = [
        *(["ivec2 pixel = ivec2(gl_FragCoord.xy);"] if stencil or reads.here or PIXEL in read else []),
        *(f"if (!({GLSL.fetched(bool, GLSL.name(name), PIXEL)})) discard;" for name in stencil),
        *reads.fetches(),
        *_rasterized(one, read | set(outputs)),
        *(line for stage in one.stages for line in _call(stage, reads, read | set(outputs))),
        *(f"{OUT}{name} = {_stored(one.outputs[name], GLSL.name(name))};" for name in outputs),
    ]
    about = f"Fragment shader of pass {one.name}, from the stages of sss_ref. Writes {', '.join(outputs)}."
    return _shader(about, [varyings, reads.declarations(lengths), written], library, lines)


def _shader(about: str, declarations: list[list[str]], library: Library, lines: list[str]) -> str:
    """The text of a shader."""
    blocks = [[VERSION, *comment(about)], *declarations, library.text.splitlines()]
    blocks.append(["void main()", "{", *indented(lines), "}"])
    return folded("\n\n".join("\n".join(block) for block in blocks if block)) + "\n"


def _rasterized(one: Pass, used: set[str]) -> list[str]:
    """What the rasterizer gives each fragment, by the pass's names."""
    if not isinstance(one.draw, MeshDraw):
        return []
    values = {one.draw.triangle: "gl_PrimitiveID", one.draw.depth: "gl_FragCoord.z", one.draw.coverage: "true"}
    kinds = one.draw.outputs.items()
    return [f"{GLSL.declared(kind, name)} = {values[name]};" for name, kind in kinds if name in used]


def _call(stage: Stage, reads: Reads, used: set[str]) -> list[str]:
    """The call of a stage; what is used of its result gets the pass's names."""
    arguments = [reads.argument(stage.reads[own], kind) for own, kind in stage.parameters.items()]
    call = f"{stage.name}({', '.join(arguments)})"
    wanted = {own: name for own, name in stage.writes.items() if name in used}
    if len(wanted) == 1:
        ((own, name),) = wanted.items()
        return [f"{GLSL.declared(stage.outputs[own], name)} = {call}.{GLSL.name(own)};"]
    own, name = next(iter(stage.writes.items()))
    result = name.replace(own, f"{stage.name}_result")  # numbered as its values are
    taken = [f"{GLSL.declared(stage.outputs[own], name)} = {result}.{GLSL.name(own)};" for own, name in wanted.items()]
    return [f"{result_struct(stage).__name__} {result} = {call};", *taken]


def _output(location: int, name: str, kind: Any) -> str:
    """The declaration of what a fragment shader writes; none can write truth values."""
    kept = "" if kind in (bool, int) else "precise "
    return f"{kept}layout(location = {location}) out {'uint' if kind is bool else GLSL.types[kind]} {OUT}{name};"


def _stored(kind: Any, value: str) -> str:
    return f"uint({value})" if kind is bool else value
