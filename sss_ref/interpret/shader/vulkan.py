"""GLSL 4.50 for Vulkan: as for OpenGL, but with a place for everything that comes in or goes out.

As Direct3D, Vulkan counts rows from the top and has depths 0 <= z <= w; the vertex shaders turn the picture over, so
that row 0 in memory is the bottom row. What a shader reads is a set, 0 of the vertex shader and 1 of the fragment
shader: binding 0 the constants, laid out by std140, then the textures. gl_PrimitiveID wants the feature geometryShader.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from sss_ref.interpret.shader.dialect import Dialect, Parts
from sss_ref.interpret.shader.glsl import GLSL
from sss_ref.interpret.shader.text import braced, comment, joined


def vertex(parts: Parts, dialect: Dialect) -> str:
    """A complete vertex shader."""
    inputs = _located("in", parts.attributes, dialect)
    outputs = _located(f"{dialect.exact}out", parts.varyings, dialect)
    return _shader(parts, dialect, 0, inputs, [*outputs, f"{dialect.exact}gl_Position;"])


def fragment(parts: Parts, dialect: Dialect) -> str:
    """A complete fragment shader."""
    places = {name: place for place, name in enumerate(parts.varyings)}
    read = {name: kind for name, kind in parts.varyings.items() if name in parts.read}
    inputs = [f"layout(location = {places[name]}) in {dialect.declared(kind, name)};" for name, kind in read.items()]
    outputs = [
        f"{'' if kind in (bool, int) else dialect.exact}layout(location = {k}) out {dialect.target(kind, name)};"
        for k, (name, kind) in enumerate(parts.outputs.items())
    ]
    return _shader(parts, dialect, 1, inputs, outputs)


def _located(word: str, named: Mapping[str, Any], dialect: Dialect) -> list[str]:
    return [f"layout(location = {k}) {word} {dialect.declared(kind, n)};" for k, (n, kind) in enumerate(named.items())]


def _shader(parts: Parts, dialect: Dialect, stage: int, inputs: list[str], outputs: list[str]) -> str:
    assert dialect.groups
    number, bound = dialect.groups[stage], dialect.bound(parts.textures)
    fields = [f"{dialect.declared(kind, name, parts.lengths.get(name))};" for name, kind in parts.uniforms.items()]
    head = f"layout(std140, set = {number}, binding = 0) uniform Uniforms"
    textures = [
        f"layout(set = {number}, binding = {bound[name]}) uniform {dialect.declared(kind, name)};"
        for name, kind in parts.textures.items()
    ]
    constants = braced(head, fields, end="};") if fields else []
    first = [*dialect.head, *comment(parts.about)]
    main = braced("void main()", parts.lines)
    return joined([first, inputs, constants, textures, outputs, parts.definitions.splitlines(), main])


VULKAN = replace(
    GLSL,
    title="GLSL for Vulkan",
    given={**GLSL.given, "vertex_number": "gl_VertexIndex"},
    placed=(
        "gl_Position = {0} * vec4(1.0, -1.0, 1.0, 1.0);",
        "gl_Position.z = (gl_Position.z + gl_Position.w) * 0.5;",
    ),
    head=("#version 450",),
    most_outputs=4,  # maxColorAttachments, specification of Vulkan 1.0 to 1.3, Required Limits; in 1.4 it is 8
    groups=(0, 1),
    vertex=vertex,
    fragment=fragment,
)
