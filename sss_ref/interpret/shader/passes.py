"""Complete shaders of a pass: what comes in, the stages' definitions, and a `main` that calls them in order."""

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from sss_ref.interpret.shader.dialect import Dialect, Parts
from sss_ref.interpret.shader.glsl import GLSL
from sss_ref.interpret.shader.library import Library
from sss_ref.interpret.shader.reads import Reads
from sss_ref.language.names import Name
from sss_ref.language.pipeline import CLIP_POSITION, MESH_ATTRIBUTES, PIXEL, Method, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import ivec2, vec2, vec4


def draws(this_pass: Pass, wanted: Collection[str], dialect: Dialect = GLSL) -> dict[str, tuple[str, ...]]:
    """The draws that fill the wanted buffers of a pass: name -> as many buffers as the dialect has room for, in order.

    A draw has the name of its pass. Where there are several, each computes all that its own buffers need, and their
    names end in a number: camera_1, camera_2 ...
    """
    parts: list[tuple[str, ...]] = []
    for name in (name for name in this_pass.values if name in wanted):
        longer = (*parts[-1], name) if parts else (name,)
        if parts and dialect.has_room([this_pass.values[each] for each in longer]):
            parts[-1] = longer
        else:
            parts.append((name,))
    return {f"{this_pass.name}_{k}" if len(parts) > 1 else this_pass.name: part for k, part in enumerate(parts, 1)}


def shader_files(
    method: Method, lengths: Mapping[str, int], dialect: Dialect = GLSL, registers: bool = False
) -> dict[str, str]:
    """All shaders of a method: file name (PASS.vert, and DRAW.frag for each of its draws) -> source.

    lengths: uniform array -> its length, see `array_lengths`. dialect: one of `DIALECTS`. registers: whether they also
    write what no buffer keeps.
    """
    files: dict[str, str] = {}
    there: set[str] = set()
    for this_pass in method.passes:
        files[f"{this_pass.name}.vert"] = vertex_shader(this_pass, lengths, dialect)
        wanted = this_pass.values if registers else this_pass.outputs
        for name, outputs in draws(this_pass, wanted, dialect).items():
            files[f"{name}.frag"] = fragment_shader(this_pass, there, outputs, lengths, dialect)
        there |= set(this_pass.outputs)
    return files


def array_lengths(uniforms: Mapping[str, Any], dialect: Dialect = GLSL) -> dict[str, int]:
    """The lengths of the arrays among `uniforms` that are short enough for a dialect; longer ones are textures."""
    longest = dialect.longest_array
    return {name: len(value) for name, value in uniforms.items() if np.ndim(value) and len(value) <= longest}


def vertex_shader(this_pass: Pass, lengths: Mapping[str, int], dialect: Dialect = GLSL) -> str:
    """The vertex shader of a pass; lengths: uniform array -> its length (an array that is not listed: a texture)."""
    return dialect.vertex(vertex_parts(this_pass, lengths, dialect), dialect)


def vertex_parts(this_pass: Pass, lengths: Mapping[str, int], dialect: Dialect = GLSL) -> Parts:
    """What the vertex shader of a pass consists of; the arguments are those of `vertex_shader`."""
    about = f"Vertex shader of pass {this_pass.name}, from the stages of sss_ref."
    mesh, library = this_pass.draw, Library(dialect)
    if not mesh.vertex_stages:
        return Parts(about, {}, {}, {}, {}, "", _rectangle(dialect), mesh=False)
    (stage,) = mesh.vertex_stages
    library.stage(stage, lengths)
    reads = Reads.of((stage,), MESH_ATTRIBUTES, ())
    return Parts(
        about=about,
        textures=reads.all_textures(lengths),
        uniforms=reads.values(lengths),
        lengths=lengths,
        varyings=mesh.varyings,
        definitions=library.text,
        lines=_vertex_lines(stage, dialect),
        mesh=True,
        attributes={own: kind for own, kind in stage.parameters.items() if own in MESH_ATTRIBUTES},
    )


def fragment_shader(
    this_pass: Pass,
    buffers: Collection[str],
    outputs: Collection[str],
    lengths: Mapping[str, int],
    dialect: Dialect = GLSL,
) -> str:
    """The fragment shader that fills `outputs` of a pass, each by an output of its name.

    buffers: the names it reads from earlier passes. lengths: uniform array -> its length (of others: a texture).
    """
    return dialect.fragment(fragment_parts(this_pass, buffers, outputs, lengths, dialect), dialect)


def fragment_parts(
    this_pass: Pass,
    buffers: Collection[str],
    outputs: Collection[str],
    lengths: Mapping[str, int],
    dialect: Dialect = GLSL,
) -> Parts:
    """What the fragment shader that fills `outputs` consists of; the arguments are those of `fragment_shader`."""
    this_pass, library = this_pass.only(set(outputs)), Library(dialect)
    for stage in this_pass.stages:
        library.stage(stage, lengths)
    read = {name for stage in this_pass.stages for name in stage.reads.values()}
    reads = Reads.of(this_pass.stages, {*this_pass.values, *this_pass.draw.varyings, PIXEL}, buffers)
    reads.textures |= dict.fromkeys(_stencil(this_pass), bool)
    return Parts(
        about=f"Fragment shader of pass {this_pass.name}, from the stages of sss_ref. Writes {', '.join(outputs)}.",
        textures=reads.all_textures(lengths),
        uniforms=reads.values(lengths),
        lengths=lengths,
        varyings=this_pass.draw.varyings,
        definitions=library.text,
        lines=_fragment_lines(this_pass, outputs, reads, dialect),
        mesh=bool(this_pass.draw.vertex_stages),
        outputs={name: this_pass.values[name] for name in outputs},
        read=read,
    )


def _rectangle(dialect: Dialect) -> list[str]:
    """The whole target, as the four corners of a triangle strip."""
    number, pair, place = dialect.given["vertex_number"], dialect.types[vec2], dialect.types[vec4]
    x, y = (dialect.calls["float32"].format(f"{number} {part}") for part in ("& 1", ">> 1"))
    corner = dialect.defined(vec2, "corner", f"{pair}({x}, {y})")
    return [corner, *(line.format(f"{place}(corner * 2.0 - 1.0, 0.0, 1.0)") for line in dialect.placed)]


def _vertex_lines(stage: Stage, dialect: Dialect) -> list[str]:
    """The call of a vertex stage; its results become the varyings and the clip position."""
    call = f"{dialect.name(stage.name)}({', '.join(map(dialect.name, stage.reads.values()))})"
    lines = [dialect.defined(stage.result_struct, "vertex", call)]
    for own, name in stage.writes.items():
        value = f"vertex.{dialect.name(own)}"
        varying = [dialect.written.handed.format(name=dialect.name(name), value=value)]
        lines += [line.format(value) for line in dialect.placed] if own == CLIP_POSITION else varying
    return lines


def _fragment_lines(this_pass: Pass, outputs: Collection[str], reads: Reads, dialect: Dialect) -> list[str]:
    """Fetch what stands at the pixel, call the stages in order, write the outputs."""
    read, stencil = {name for stage in this_pass.stages for name in stage.reads.values()}, _stencil(this_pass)
    at_pixel = stencil or reads.here or PIXEL in read
    used = read | set(outputs)
    return [
        *([dialect.defined(ivec2, PIXEL, dialect.given[PIXEL])] if at_pixel else []),
        *(dialect.written.stop.format(condition=dialect.fetched(bool, dialect.name(n), PIXEL)) for n in stencil),
        *reads.fetches(dialect),
        *_rasterized(this_pass, used, dialect),
        *(line for stage in this_pass.stages for line in _call(stage, reads, used, dialect)),
        *(dialect.stored(this_pass.values[name], name) for name in outputs),
    ]


def _stencil(this_pass: Pass) -> list[str]:
    """The buffer that limits a rectangle, if there is one."""
    return [this_pass.draw.stencil] if this_pass.draw.stencil else []


def _rasterized(this_pass: Pass, used: set[str], dialect: Dialect) -> list[str]:
    """What the rasterizer gives each fragment, by the pass's names."""
    given = {**dialect.given, "coverage": "true"}
    values = {this_pass.draw.triangle: "triangle", this_pass.draw.depth: "depth", this_pass.draw.coverage: "coverage"}
    kinds = this_pass.draw.outputs.items()
    return [dialect.defined(kind, name, given[values[name]]) for name, kind in kinds if name in used]


def _call(stage: Stage, reads: Reads, used: set[str], dialect: Dialect) -> list[str]:
    """The call of a stage; what is used of its result gets the pass's names."""
    arguments = [reads.argument(stage.reads[own], kind, dialect) for own, kind in stage.parameters.items()]
    call = f"{dialect.name(stage.name)}({', '.join(arguments)})"
    wanted = {own: name for own, name in stage.writes.items() if name in used}
    if len(wanted) == 1:
        ((own, name),) = wanted.items()
        return [dialect.defined(stage.outputs[own], name, f"{call}.{dialect.name(own)}")]
    own, first = next((own, Name.of(name)) for own, name in stage.writes.items())
    called = stage.name if first.base == own else first.base  # a pass may have a stage twice, bound to other names
    whole = str(replace(first, base=f"{called}_result"))  # numbered as its values are
    result = dialect.name(whole)
    taken = [dialect.defined(stage.outputs[own], name, f"{result}.{dialect.name(own)}") for own, name in wanted.items()]
    return [dialect.defined(stage.result_struct, whole, call), *taken]
