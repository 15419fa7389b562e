"""What tells one shading language from another, as far as the stages need it."""

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, get_args, get_origin

from sss_ref.language.types import Array, Texture, Vector, vec2, vec3, vec4

ARRAY_WIDTH = 4096  # texels in a row of a texture that holds a long uniform array
FLOATING = (float, vec2, vec3, vec4)
OUT = "out_"  # how the name of a fragment shader's output begins; the buffer's name follows


@dataclass(frozen=True)
class Parts:
    """What a complete shader consists of; `lines` are the statements of its `main`.

    about: its first comment. textures, uniforms: what the application binds, as `type name`. varyings: what goes from
    vertex to fragment. definitions: constants, structs and functions. mesh: whether it draws the mesh, not a rectangle.
    attributes: what a vertex shader reads of its vertex. outputs: what a fragment shader writes, by buffer.
    read: the names that the stages of a fragment shader read.
    """

    about: str
    textures: Sequence[str]
    uniforms: Sequence[str]
    varyings: Mapping[str, Any]
    definitions: str
    lines: Sequence[str]
    mesh: bool
    attributes: Mapping[str, Any] = field(default_factory=dict)
    outputs: Mapping[str, Any] = field(default_factory=dict)
    read: Collection[str] = ()


def clear_of(reserved: Collection[str], name: str) -> str:
    """A name that no shading language keeps for itself: as it is, or changed so that no two become one.

    reserved: the language's words. None of these languages takes other letters than ASCII's; GLSL also keeps names that
    begin with gl_ or have two underscores in a row.
    """
    plain = re.sub(r"[^\x00-\x7f]", lambda letter: f"u{ord(letter[0]):x}", name)
    plain = re.sub("_(?=_)", "_0", plain)
    if name.endswith("_"):
        return f"{plain}0_"
    if name in reserved or plain != name:
        return f"{plain}_"
    return f"own_{plain}_" if name.startswith("gl_") else name


@dataclass(frozen=True)
class Dialect:
    """A shading language.

    types: type -> its name. textures: type of a texel -> the texture's type. calls: primitive -> how it is written,
    with {0}, {1} for the arguments. texel, element: how a texture, or a long array in one, is read.
    four_channels: whether a texel has four, whatever its texture holds.
    products: type of a matrix m -> its product with the vector v. splat: a vector of type {0}, each component {1}.
    constant: what stands before a constant. exact: what stands before values whose sums must stay as written; compilers
    look no further than the function, so that every function says it of its own.
    returned: how a function returns a struct. size: the statements that return the size of the texture `map`, where
    `calls` has it not. given: what the GPU tells a vertex ("vertex_number") or fragment ("pixel", "depth", "triangle").
    placed: how a vertex shader hands on the clip position {0}. reserved: the names that nothing of ours may have, words
    and built-in functions: some compilers let nobody define those anew, and none lets them stand beside a uniform of
    that name. most_outputs: colour attachments that every implementation has. head: the first lines of a shader.
    vertex, fragment: what lays out a complete shader.
    """

    types: Mapping[Any, str]
    textures: Mapping[Any, str]
    calls: Mapping[str, str]
    texel: str
    element: str
    four_channels: bool
    products: Mapping[Any, str]
    splat: str
    constant: str
    exact: str
    returned: tuple[str, ...]
    given: Mapping[str, str]
    placed: tuple[str, ...]
    reserved: frozenset[str]
    most_outputs: int
    head: tuple[str, ...]
    vertex: "Callable[[Parts, Dialect], str]"
    fragment: "Callable[[Parts, Dialect], str]"
    size: tuple[str, ...] = ()

    def name(self, name: str) -> str:
        """The name of a variable or function; one that the language keeps for itself ends in an underscore."""
        return clear_of(self.reserved, name)

    def declared(self, kind: Any, name: str, length: int | None = None) -> str:
        """`type name`; a uniform array is an array of this length or, without one, a texture."""
        if length is not None and get_origin(kind) is Array:
            return f"{self.types[get_args(kind)[0]]} {self.name(name)}[{length}]"
        texture = get_origin(kind) in (Texture, Array)
        return f"{self.textures[get_args(kind)[0]] if texture else self.types[kind]} {self.name(name)}"

    def computed(self, kind: Any, name: str) -> str:
        """`type name` of a variable whose sums must stay as written, also where they are only compared."""
        return f"{self.exact if kind in (*FLOATING, bool) else ''}{self.declared(kind, name)}"

    def written(self, kind: Any, name: str) -> str:
        """`type name` of what a fragment shader writes for a buffer; none can write truth values."""
        return f"{'uint' if kind is bool else self.types[kind]} {self.out(name)}"

    def out(self, buffer: str) -> str:
        """The name of what a fragment shader writes for a buffer."""
        return clear_of((), OUT + buffer)

    def fetched(self, kind: Any, texture: str, at: str) -> str:
        """The texel of this type at `at`."""
        return self._typed(kind, self.texel.format(texture, at))

    def looked_up(self, kind: Any, texture: str, index: str) -> str:
        """The element of this type of a long uniform array."""
        return self._typed(kind, self.element.format(texture, index))

    def _typed(self, kind: Any, texel: str) -> str:
        vector = isinstance(kind, type) and issubclass(kind, Vector)
        letters = "xyzw"[: kind.count] if vector else "x"
        value = f"{texel}.{letters}" if self.four_channels and len(letters) < 4 else texel
        return f"{value} != 0u" if kind is bool else value
