"""What a shading language calls the types and built-ins of ours."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, get_args, get_origin

from sss_ref.language.types import Array, Texture, Vector, ivec2, mat3, mat4, vec2, vec3, vec4

GLSL_WORDS = """
active asm attribute buffer case cast centroid class coherent common const default discard enum extern external
filter fixed flat goto half highp inline inout input interface invariant layout long lowp mediump namespace noinline
noperspective out output packed partition patch precise precision public readonly resource restrict row_major sample
shared short sizeof smooth static struct subroutine superp switch template this typedef uniform union unsigned using
varying void volatile writeonly
"""  # those that Python allows as a name
ARRAY_WIDTH = 4096  # texels in a row of a texture that holds a long uniform array


@dataclass(frozen=True)
class Dialect:
    """A shading language.

    types: type -> its name. textures: type of a texel -> the texture's type. calls: primitive -> how it is written,
    with {0}, {1} for the arguments. texel, element: how a texture, or a long array in one, is read.
    products: type of a matrix m -> its product with the vector v. returned: how a function returns a struct.
    reserved: words that no variable may have.
    """

    types: Mapping[Any, str]
    textures: Mapping[Any, str]
    calls: Mapping[str, str]
    texel: str
    element: str
    products: Mapping[Any, str]
    returned: tuple[str, ...]
    reserved: frozenset[str]

    def name(self, name: str) -> str:
        """A variable's name; one that the language reserves ends in an underscore."""
        return f"{name}_" if name in self.reserved else name

    def declared(self, kind: Any, name: str, length: int | None = None) -> str:
        """`type name`; a uniform array is an array of this length or, without one, a texture."""
        if length is not None and get_origin(kind) is Array:
            return f"{self.types[get_args(kind)[0]]} {self.name(name)}[{length}]"
        texture = get_origin(kind) in (Texture, Array)
        return f"{self.textures[get_args(kind)[0]] if texture else self.types[kind]} {self.name(name)}"

    def fetched(self, kind: Any, texture: str, at: str) -> str:
        """The texel of this type at `at`."""
        return self._typed(kind, self.texel.format(texture, at))

    def looked_up(self, kind: Any, texture: str, index: str) -> str:
        """The element of this type of a long uniform array."""
        return self._typed(kind, self.element.format(texture, index))

    def _typed(self, kind: Any, texel: str) -> str:
        if kind is bool:
            return f"{texel}.x != 0u"
        vector = isinstance(kind, type) and issubclass(kind, Vector)
        letters = "xyzw"[: kind.count] if vector else "x"
        return texel if len(letters) == 4 else f"{texel}.{letters}"


GLSL = Dialect(
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
    products={
        mat3: "(m[0] * v.x + m[1] * v.y) + m[2] * v.z",
        mat4: "((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3] * v.w",
    },
    returned=("return {struct}({values});",),
    reserved=frozenset(GLSL_WORDS.split()),
)
