"""Complete shaders of a pass: what comes in, the stages' definitions, and a `main` that calls them in order."""

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from sss_ref.interpret.shader.dialect import OUT, Dialect, Parts
from sss_ref.interpret.shader.glsl import GLSL
from sss_ref.interpret.shader.library import Library, result_struct
from sss_ref.interpret.shader.reads import Reads
from sss_ref.language.pipeline import CLIP_POSITION, MESH_ATTRIBUTES, PIXEL, MeshDraw, Method, Pass, ScreenDraw
from sss_ref.language.stage import Stage
from sss_ref.language.types import ivec2, vec2, vec4

LONGEST_ARRAY = 64  # elements; OpenGL 3.3 promises room for 1024 numbers in all


def draws(one: Pass, wanted: Collection[str], most: int = GLSL.most_outputs) -> dict[str, tuple[str, ...]]:
    """The draws that fill the wanted buffers of a pass: name -> at most `most` buffers, in order.

    A draw has the name of its pass. Where there are several, each computes all that its own buffers need, and their
    names end in a number: camera_1, camera_2 ...
    """
    names = [name for name in one.values if name in wanted]
    parts = [tuple(names[first : first + most]) for first in range(0, len(names), most)]
    return {f"{one.name}_{k}" if len(parts) > 1 else one.name: part for k, part in enumerate(parts, 1)}


def shader_files(
    method: Method, lengths: Mapping[str, int], dialect: Dialect = GLSL, registers: bool = False
) -> dict[str, str]:
    """All shaders of a method: file name (PASS.vert, and DRAW.frag for each of its draws) -> source.

    lengths: uniform array -> its length, see `array_lengths`. dialect: one of `DIALECTS`. registers: whether they also
    write what no buffer keeps.
    """
    files: dict[str, str] = {}
    there: set[str] = set()
    for one in method.passes:
        files[f"{one.name}.vert"] = vertex_shader(one, lengths, dialect)
        for name, outputs in draws(one, one.values if registers else one.outputs, dialect.most_outputs).items():
            files[f"{name}.frag"] = fragment_shader(one, there, outputs, lengths, dialect)
        there |= set(one.outputs)
    return files


def array_lengths(uniforms: Mapping[str, Any]) -> dict[str, int]:
    """The lengths of those arrays among `uniforms` that are short enough for a shader; longer ones become textures."""
    return {name: len(value) for name, value in uniforms.items() if np.ndim(value) and len(value) <= LONGEST_ARRAY}


def vertex_shader(one: Pass, lengths: Mapping[str, int], dialect: Dialect = GLSL) -> str:
    """The vertex shader of a pass; lengths: uniform array -> its length (an array that is not listed: a texture)."""
    about, mesh, library = f"Vertex shader of pass {one.name}, from the stages of sss_ref.", one.draw, Library(dialect)
    if isinstance(mesh, ScreenDraw):
        return dialect.vertex(Parts(about, [], [], {}, "", _rectangle(dialect), mesh=False), dialect)
    stage = mesh.vertex
    library.stage(stage, lengths)
    reads = Reads.of((stage,), MESH_ATTRIBUTES, ())
    parts = Parts(
        about=about,
        textures=reads.declared_textures(lengths, dialect),
        uniforms=reads.declared_uniforms(lengths, dialect),
        varyings=mesh.varyings,
        definitions=library.text,
        lines=_vertex_lines(stage, dialect),
        mesh=True,
        attributes={own: kind for own, kind in stage.parameters.items() if own in MESH_ATTRIBUTES},
    )
    return dialect.vertex(parts, dialect)


def fragment_shader(
    one: Pass,
    buffers: Collection[str],
    outputs: Collection[str],
    lengths: Mapping[str, int],
    dialect: Dialect = GLSL,
) -> str:
    """The fragment shader that fills `outputs` of a pass, each by an output of its name.

    buffers: the names it reads from earlier passes. lengths: uniform array -> its length (of others: a texture).
    """
    one, library = one.only(set(outputs)), Library(dialect)
    for stage in one.stages:
        library.stage(stage, lengths)
    read = {name for stage in one.stages for name in stage.reads.values()}
    reads = Reads.of(one.stages, {*one.values, *one.draw.varyings, PIXEL}, buffers)
    reads.textures |= dict.fromkeys(_stencil(one), bool)
    parts = Parts(
        about=f"Fragment shader of pass {one.name}, from the stages of sss_ref. Writes {', '.join(outputs)}.",
        textures=reads.declared_textures(lengths, dialect),
        uniforms=reads.declared_uniforms(lengths, dialect),
        varyings=one.draw.varyings,
        definitions=library.text,
        lines=_fragment_lines(one, outputs, reads, dialect),
        mesh=isinstance(one.draw, MeshDraw),
        outputs={name: one.values[name] for name in outputs},
        read=read,
    )
    return dialect.fragment(parts, dialect)


def _rectangle(dialect: Dialect) -> list[str]:
    """The whole target, as the four corners of a triangle strip."""
    number, pair, place = dialect.given["vertex_number"], dialect.types[vec2], dialect.types[vec4]
    corner = f"{pair} corner = {pair}({number} & 1, {number} >> 1);"
    return [corner, *(line.format(f"{place}(corner * 2.0 - 1.0, 0.0, 1.0)") for line in dialect.placed)]


def _vertex_lines(stage: Stage, dialect: Dialect) -> list[str]:
    """The call of a vertex stage; its results become the varyings and the clip position."""
    call = f"{stage.name}({', '.join(map(dialect.name, stage.reads.values()))})"
    lines = [f"{result_struct(stage).__name__} vertex = {call};"]
    for own, name in stage.writes.items():
        value = f"vertex.{dialect.name(own)}"
        varying = [f"{dialect.name(name)} = {value};"]
        lines += [line.format(value) for line in dialect.placed] if own == CLIP_POSITION else varying
    return lines


def _fragment_lines(one: Pass, outputs: Collection[str], reads: Reads, dialect: Dialect) -> list[str]:
    """Fetch what stands at the pixel, call the stages in order, write the outputs."""
    read, stencil = {name for stage in one.stages for name in stage.reads.values()}, _stencil(one)
    at_pixel = stencil or reads.here or PIXEL in read
    used = read | set(outputs)
    return [
        *([f"{dialect.declared(ivec2, PIXEL)} = {dialect.given[PIXEL]};"] if at_pixel else []),
        *(f"if (!({dialect.fetched(bool, dialect.name(name), PIXEL)})) discard;" for name in stencil),
        *reads.fetches(dialect),
        *_rasterized(one, used, dialect),
        *(line for stage in one.stages for line in _call(stage, reads, used, dialect)),
        *(f"{OUT}{name} = {_stored(one.values[name], dialect.name(name))};" for name in outputs),
    ]


def _stencil(one: Pass) -> list[str]:
    """The buffer that limits a rectangle, if there is one."""
    return [one.draw.stencil] if isinstance(one.draw, ScreenDraw) and one.draw.stencil else []


def _rasterized(one: Pass, used: set[str], dialect: Dialect) -> list[str]:
    """What the rasterizer gives each fragment, by the pass's names."""
    if not isinstance(one.draw, MeshDraw):
        return []
    given = {**dialect.given, "coverage": "true"}
    values = {one.draw.triangle: "triangle", one.draw.depth: "depth", one.draw.coverage: "coverage"}
    kinds = one.draw.outputs.items()
    return [f"{dialect.declared(kind, name)} = {given[values[name]]};" for name, kind in kinds if name in used]


def _call(stage: Stage, reads: Reads, used: set[str], dialect: Dialect) -> list[str]:
    """The call of a stage; what is used of its result gets the pass's names."""
    arguments = [reads.argument(stage.reads[own], kind, dialect) for own, kind in stage.parameters.items()]
    call = f"{stage.name}({', '.join(arguments)})"
    wanted = {own: name for own, name in stage.writes.items() if name in used}
    if len(wanted) == 1:
        ((own, name),) = wanted.items()
        return [f"{dialect.declared(stage.outputs[own], name)} = {call}.{dialect.name(own)};"]
    own, name = next(iter(stage.writes.items()))
    result = name.replace(own, f"{stage.name}_result")  # numbered as its values are
    taken = [
        f"{dialect.declared(stage.outputs[own], name)} = {result}.{dialect.name(own)};" for own, name in wanted.items()
    ]
    return [f"{result_struct(stage).__name__} {result} = {call};", *taken]


def _stored(kind: Any, value: str) -> str:
    return f"uint({value})" if kind is bool else value
