"""GLSL 4.00 for OpenGL, and GLSL ES 3.00 for WebGL 2 and OpenGL ES."""

from dataclasses import replace

from sss_ref.interpret.shader.dialect import ARRAY_WIDTH, Dialect, Parts
from sss_ref.interpret.shader.reserved import GLSL_BUILT_INS, GLSL_WORDS
from sss_ref.interpret.shader.text import braced, comment, joined
from sss_ref.language.types import ivec2, mat3, mat4, vec2, vec3, vec4

TRIANGLE = "triangle_number"  # GLSL ES knows no gl_PrimitiveID: drawn without indices, a corner knows its triangle


def vertex(parts: Parts, dialect: Dialect) -> str:
    """A complete vertex shader."""
    attributes = [f"in {dialect.declared(kind, name)};" for name, kind in parts.attributes.items()]
    varyings = [f"{dialect.exact}out {dialect.declared(kind, name)};" for name, kind in parts.varyings.items()]
    position = ["precise gl_Position;"] if dialect.exact else []
    if not parts.mesh:
        return _shader(parts, dialect, [], position)
    if not dialect.indexed:
        numbered = replace(parts, lines=[*parts.lines, f"{TRIANGLE} = gl_VertexID / 3;"])
        return _shader(numbered, dialect, attributes, [*varyings, f"flat out int {TRIANGLE};"])
    return _shader(parts, dialect, attributes, [*varyings, *position])


def fragment(parts: Parts, dialect: Dialect) -> str:
    """A complete fragment shader."""
    varyings = [f"in {dialect.declared(kind, name)};" for name, kind in parts.varyings.items() if name in parts.read]
    number = [f"flat in int {TRIANGLE};"] if parts.mesh and not dialect.indexed else []
    written = [
        f"{'' if kind in (bool, int) else dialect.exact}layout(location = {k}) out {dialect.target(kind, name)};"
        for k, (name, kind) in enumerate(parts.outputs.items())
    ]
    return _shader(parts, dialect, varyings + number, written)


def _shader(parts: Parts, dialect: Dialect, inputs: list[str], outputs: list[str]) -> str:
    given = {**parts.textures, **parts.uniforms}
    uniforms = [f"uniform {dialect.declared(kind, name, parts.lengths.get(name))};" for name, kind in given.items()]
    head = [*dialect.head, *comment(parts.about)]
    return joined([head, inputs, uniforms, outputs, parts.definitions.splitlines(), braced("void main()", parts.lines)])


GLSL = Dialect(
    title="GLSL",
    types={
        float: "float",
        int: "int",
        bool: "bool",
        vec2: "vec2",
        vec3: "vec3",
        vec4: "vec4",
        ivec2: "ivec2",
        mat3: "mat3",
        mat4: "mat4",
    },
    textures={int: "isampler2D", bool: "usampler2D", **dict.fromkeys((float, vec2, vec3, vec4), "sampler2D")},
    calls={
        "sqrt": "sqrt({0})",
        "floor": "floor({0})",
        "pow": "pow({0}, {1})",
        "exp": "exp({0})",
        "exp2": "exp2({0})",
        "log2": "log2({0})",
        "float32": "float({0})",
        "int32": "int({0})",
        "size": "textureSize({0}, 0)",
    },
    texel="texelFetch({0}, {1}, 0)",
    element=f"texelFetch({{0}}, ivec2({{1}} % {ARRAY_WIDTH}, {{1}} / {ARRAY_WIDTH}), 0)",
    four_channels=True,
    products={
        mat3: "(m[0] * v.x + m[1] * v.y) + m[2] * v.z",
        mat4: "((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3] * v.w",
    },
    splat="{0}({1})",
    constant="const",
    exact="precise ",
    returned=("return {struct}({values});",),
    given={
        "pixel": "ivec2(gl_FragCoord.xy)",
        "depth": "gl_FragCoord.z",
        "triangle": "gl_PrimitiveID",
        "vertex_number": "gl_VertexID",
    },
    placed=("gl_Position = {0};",),
    reserved=GLSL_WORDS | GLSL_BUILT_INS | {"main"},
    most_outputs=8,
    head=("#version 400 core",),  # the first with `precise`: no sum reordered, nothing fused
    vertex=vertex,
    fragment=fragment,
)

PRECISION = [f"precision highp {kind};" for kind in ("float", "int", "sampler2D", "isampler2D", "usampler2D")]
ESSL = replace(
    GLSL,
    title="GLSL ES",
    exact="",
    given={**GLSL.given, "triangle": TRIANGLE},
    most_outputs=4,
    indexed=False,
    head=("#version 300 es", *PRECISION),
)
