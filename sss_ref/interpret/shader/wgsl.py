"""WGSL, for WebGPU: no overloads, no `precise`, no three channels in a target, 32 bytes of targets in a draw.

As Direct3D, WebGPU counts rows from the top and has depths 0 <= z <= w. The vertex shaders turn the picture over, so
that row 0 in memory is the bottom row. It has no number of a triangle without an extension, so triangles are drawn
without indices, and a corner knows its triangle. What a shader reads is a group, 0 of the vertex shader and 1 of the
fragment shader: binding 0 the constants, then the textures. A uniform array is always a texture, for WGSL has elements
of an array among constants start 16 bytes apart.
"""

from collections.abc import Sequence
from typing import Any

from sss_ref.interpret.shader.dialect import ARRAY_WIDTH, OUT, Dialect, Parts, Wording
from sss_ref.interpret.shader.glsl import GLSL, TRIANGLE
from sss_ref.interpret.shader.reserved import WGSL_BUILT_INS, WGSL_WORDS
from sss_ref.interpret.shader.text import braced, comment, indented, joined
from sss_ref.language.types import ivec2, mat3, mat4, vec2, vec3, vec4

NUMBER, WINDOW, CLIP, TURNED = "vertex_number", "window", "clip_position", "turned"  # names of our own in `main`
CONSTANTS, VARYINGS, TARGETS = "Uniforms", "Varyings", "Targets"  # the structs of a complete shader


def vertex(parts: Parts, dialect: Dialect) -> str:
    """A complete vertex shader."""
    attributes = _located([dialect.declared(kind, name) for name, kind in parts.attributes.items()])
    varyings = _located([dialect.declared(kind, name) for name, kind in parts.varyings.items()])
    handed, lines = [CLIP, *map(dialect.name, parts.varyings)], [*_taken(parts, dialect), *parts.lines]
    if parts.mesh:
        varyings.append(_triangle(parts))
        handed.append(TRIANGLE)
        lines.append(f"let {TRIANGLE} = i32({NUMBER} / 3u);")
    struct = _struct(VARYINGS, [f"@builtin(position) @invariant {CLIP}: vec4<f32>", *varyings])
    main = _main("@vertex", [*attributes, f"@builtin(vertex_index) {NUMBER}: u32"], lines, VARYINGS, handed)
    return _shader(parts, dialect, 0, struct, main)


def fragment(parts: Parts, dialect: Dialect) -> str:
    """A complete fragment shader."""
    located = _located([dialect.declared(kind, name) for name, kind in parts.varyings.items()])
    varyings = [each for each, name in zip(located, parts.varyings, strict=True) if name in parts.read]
    number = [_triangle(parts)] if parts.mesh else []
    outputs = _located([dialect.target(kind, name) for name, kind in parts.outputs.items()])
    given = [f"@builtin(position) {WINDOW}: vec4<f32>", *varyings, *number]
    lines, values = [*_taken(parts, dialect), *parts.lines], [*map(dialect.out, parts.outputs)]
    main = _main("@fragment", given, lines, TARGETS, values)
    return _shader(parts, dialect, 1, _struct(TARGETS, outputs), main)


def _triangle(parts: Parts) -> str:
    return f"@location({len(parts.varyings)}) @interpolate(flat) {TRIANGLE}: i32"


def _located(declared: Sequence[str]) -> list[str]:
    return [f"@location({k}) {each}" for k, each in enumerate(declared)]


def _struct(name: str, fields: Sequence[str]) -> list[str]:
    return braced(f"struct {name}", [f"{each}," for each in fields])


def _main(head: str, given: Sequence[str], lines: Sequence[str], result: str, values: Sequence[str]) -> list[str]:
    """The function of a shader; head: what stands before it. It returns a struct of these values."""
    listed = indented([f"{each}," for each in given])
    return [head, "fn main(", *listed, *braced(f") -> {result}", [*lines, f"return {result}({', '.join(values)});"])]


def _shader(parts: Parts, dialect: Dialect, stage: int, struct: list[str], main: list[str]) -> str:
    assert dialect.groups
    group, bound = dialect.groups[stage], dialect.bound(parts.textures)
    fields = [_constant(kind, name, dialect) for name, kind in parts.uniforms.items()]
    bindings = [f"@group({group}) @binding(0) var<uniform> uniforms: {CONSTANTS};"] if fields else []
    bindings += [
        f"@group({group}) @binding({bound[name]}) var {dialect.declared(kind, name)};"
        for name, kind in parts.textures.items()
    ]
    head = [comment(parts.about), _struct(CONSTANTS, fields) if fields else [], bindings, struct]
    return joined([*head, parts.definitions.splitlines(), main])


def _constant(kind: Any, name: str, dialect: Dialect) -> str:
    """A field of the constants; WGSL lets none of them hold truth values."""
    return f"{dialect.name(name)}: u32" if kind is bool else dialect.declared(kind, name)


def _taken(parts: Parts, dialect: Dialect) -> list[str]:
    """The statements that take the constants out of their struct."""
    return [
        dialect.defined(kind, name, f"uniforms.{dialect.name(name)}{' != 0u' * (kind is bool)}")
        for name, kind in parts.uniforms.items()
    ]


WGSL = Dialect(
    title="WGSL",
    types={
        float: "f32",
        int: "i32",
        bool: "bool",
        vec2: "vec2<f32>",
        vec3: "vec3<f32>",
        vec4: "vec4<f32>",
        ivec2: "vec2<i32>",
        mat3: "mat3x3<f32>",
        mat4: "mat4x4<f32>",
    },
    textures={
        int: "texture_2d<i32>",
        bool: "texture_2d<u32>",
        **dict.fromkeys((float, vec2, vec3, vec4), "texture_2d<f32>"),
    },
    calls={
        **GLSL.calls,
        "float32": "f32({0})",
        "int32": "i32({0})",
        "select": "select({2}, {1}, {0})",
        "size": "vec2<i32>(textureDimensions({0}))",
        "!=": "!({0} == {1})",  # naga's own is false where one of them is NaN
    },
    texel="textureLoad({0}, {1}, 0)",
    element=f"textureLoad({{0}}, vec2<i32>({{1}} % {ARRAY_WIDTH}, {{1}} / {ARRAY_WIDTH}), 0)",
    four_channels=True,
    products=GLSL.products,
    splat="{0}({1})",
    constant="const",
    exact="",
    returned=GLSL.returned,
    given={
        "pixel": f"vec2<i32>({WINDOW}.xy)",
        "depth": f"{WINDOW}.z",
        "triangle": TRIANGLE,
        "vertex_number": f"i32({NUMBER})",
    },
    placed=(
        f"let {TURNED} = {{0}} * vec4<f32>(1.0, -1.0, 1.0, 1.0);",
        f"let {CLIP} = vec4<f32>({TURNED}.xy, ({TURNED}.z + {TURNED}.w) * 0.5, {TURNED}.w);",
    ),
    reserved=WGSL_WORDS | WGSL_BUILT_INS | {"main", "uniforms", NUMBER, WINDOW, TURNED, TRIANGLE},
    most_outputs=8,
    head=(),
    vertex=vertex,
    fragment=fragment,
    written=Wording(
        declaration="{name}: {type}",
        fixed="let {declared} = {value};",
        changing="var {declared} = {value};",
        function="fn {name}({parameters}) -> {result}",
        field="{declared},",
        struct_end="}",
        loop="for (var {index}: i32 = {start}; {index} < {stop}; {index}++)",
        stop="if (!({condition})) {{ discard; }}",
        output=rf"@location\((?P<at>\d+)\)\s*{OUT}(?P<name>\w+)\s*:",
        example=f"@location(0) {OUT}NAME: vec4<f32>",
        handed="let {name} = {value};",
    ),
    overloads=False,
    targets={bool: ("u32", "u32({0})"), vec3: ("vec4<f32>", "vec4<f32>({0}, 1.0)")},
    most_bytes=32,
    longest_array=0,
    groups=(0, 1),
    indexed=False,
)
