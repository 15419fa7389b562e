"""HLSL, Shader Model 4 and newer, for Direct3D.

Direct3D counts rows from the top and has depths 0 <= z <= w. The vertex shaders turn the picture over, so that row 0 in
memory is the bottom row, as everywhere in this package, and a sample on an edge belongs to the same triangle (rule R3).
Hence textures, pixels and what is read back need no flip. Depth is that of (z + w)/2, rounded otherwise than in OpenGL.
All constants lie in one buffer, each where it says so itself: a row has 16 bytes, and a vector lies in one of them.
Matrices lie there row after row; elements of arrays start 16 bytes apart, as always in Direct3D.
"""

from sss_ref.interpret.shader.constants import ROW, places
from sss_ref.interpret.shader.dialect import ARRAY_WIDTH, OUT, Dialect, Parts, Wording
from sss_ref.interpret.shader.glsl import GLSL
from sss_ref.interpret.shader.reserved import HLSL_BUILT_INS, HLSL_WORDS
from sss_ref.interpret.shader.text import braced, comment, indented, joined
from sss_ref.language.types import ivec2, mat3, mat4, vec2, vec3, vec4

NUMBER, WINDOW, PRIMITIVE, CLIP = "vertex_number", "window", "primitive", "clip_position"  # inputs and output of `main`


def vertex(parts: Parts, dialect: Dialect) -> str:
    """A complete vertex shader."""
    attributes = [f"{dialect.declared(kind, name)} : {name.upper()}" for name, kind in parts.attributes.items()]
    number = [] if parts.mesh else [f"uint {NUMBER} : SV_VertexID"]
    position = [f"out precise float4 {CLIP} : SV_Position"]
    return _shader(parts, dialect, [*attributes, *number, *position, *_varyings(parts, dialect, "out precise ")])


def fragment(parts: Parts, dialect: Dialect) -> str:
    """A complete pixel shader; it names all that the vertex shader hands on, in that order, as Direct3D wants it."""
    window, primitive = [f"float4 {WINDOW} : SV_Position"], [f"uint {PRIMITIVE} : SV_PrimitiveID"] * parts.mesh
    written = [
        f"out {'' if kind in (bool, int) else dialect.exact}{dialect.target(kind, name)} : SV_Target{k}"
        for k, (name, kind) in enumerate(parts.outputs.items())
    ]
    return _shader(parts, dialect, [*window, *_varyings(parts, dialect, ""), *primitive, *written])


def _varyings(parts: Parts, dialect: Dialect, before: str) -> list[str]:
    return [
        f"{before}{dialect.declared(kind, name)} : TEXCOORD{k}" for k, (name, kind) in enumerate(parts.varyings.items())
    ]


def _shader(parts: Parts, dialect: Dialect, parameters: list[str]) -> str:
    bound = dialect.bound(parts.textures)
    textures = [f"{dialect.declared(kind, name)} : register(t{bound[name]});" for name, kind in parts.textures.items()]
    where = places(parts.uniforms, parts.lengths)
    uniforms = [
        f"{'row_major ' * (kind in (mat3, mat4))}{dialect.declared(kind, name, parts.lengths.get(name))} : "
        f"packoffset({_row(where.offsets[name])});"
        for name, kind in parts.uniforms.items()
    ]
    constants = braced("cbuffer Uniforms : register(b0)", uniforms, end="};") if uniforms else []
    ends = ["," for _ in parameters[1:]] + [""]
    listed = indented([parameter + end for parameter, end in zip(parameters, ends, strict=True)])
    main = ["void main(", *listed, *braced(")", parts.lines)]
    return joined([comment(parts.about), textures, constants, parts.definitions.splitlines(), main])


def _row(offset: int) -> str:
    """A place in the constant buffer as Direct3D tells it: its row of 16 bytes, and where in that."""
    row, rest = divmod(offset, ROW)
    return f"c{row}{'.' * (rest > 0)}{'xyzw'[rest // 4] * (rest > 0)}"


HLSL = Dialect(
    title="HLSL",
    types={
        float: "float",
        int: "int",
        bool: "bool",
        vec2: "float2",
        vec3: "float3",
        vec4: "float4",
        ivec2: "int2",
        mat3: "float3x3",
        mat4: "float4x4",
    },
    textures={
        int: "Texture2D<int>",
        bool: "Texture2D<uint>",
        float: "Texture2D<float>",
        vec2: "Texture2D<float2>",
        vec3: "Texture2D<float3>",
        vec4: "Texture2D<float4>",
    },
    calls={name: call for name, call in GLSL.calls.items() if name != "size"},
    texel="{0}.Load(int3({1}, 0))",
    element=f"{{0}}.Load(int3({{1}} % {ARRAY_WIDTH}, {{1}} / {ARRAY_WIDTH}, 0))",
    four_channels=False,
    products={  # m[0] is a row here and a column in GLSL
        mat3: "(transpose(m)[0] * v.x + transpose(m)[1] * v.y) + transpose(m)[2] * v.z",
        mat4: "((transpose(m)[0] * v.x + transpose(m)[1] * v.y) + transpose(m)[2] * v.z) + transpose(m)[3] * v.w",
    },
    splat="({0}){1}",
    constant="static const",
    exact="precise ",
    returned=("{struct} returned = {{{values}}};", "return returned;"),
    given={
        "pixel": f"int2({WINDOW}.xy)",
        "depth": f"{WINDOW}.z",
        "triangle": f"int({PRIMITIVE})",
        "vertex_number": NUMBER,
    },
    placed=(
        f"{CLIP} = {{0}} * float4(1.0, -1.0, 1.0, 1.0);",
        f"{CLIP}.z = ({CLIP}.z + {CLIP}.w) * 0.5;",
    ),
    reserved=HLSL_WORDS | HLSL_BUILT_INS | {"main", "returned"},  # the last: the struct that a function returns
    most_outputs=8,
    groups=(0, 0),
    first_texture=0,
    head=(),
    vertex=vertex,
    fragment=fragment,
    written=Wording(
        output=rf"out\s+(?:precise\s+)?\w+\s+{OUT}(?P<name>\w+)\s*:\s*SV_Target(?P<at>\d+)",
        example=f"out float3 {OUT}NAME : SV_Target0",
    ),
    size=("uint width, height;", "map.GetDimensions(width, height);", "return int2(width, height);"),
)
