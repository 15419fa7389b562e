"""What tells one shading language from another, as far as the stages need it."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, get_args, get_origin

from sss_ref.language.types import Array, Texture, Vector

ARRAY_WIDTH = 4096  # texels in a row of a texture that holds a long uniform array
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


@dataclass(frozen=True)
class Dialect:
    """A shading language.

    types: type -> its name. textures: type of a texel -> the texture's type. calls: primitive -> how it is written,
    with {0}, {1} for the arguments. texel, element: how a texture, or a long array in one, is read.
    four_channels: whether a texel has four, whatever its texture holds.
    products: type of a matrix m -> its product with the vector v. splat: a vector of type {0}, each component {1}.
    constant: what stands before a constant. exact: what stands before outputs whose sums must stay as written.
    returned: how a function returns a struct. size: the statements that return the size of the texture `map`, where
    `calls` has it not. given: what the GPU tells a vertex ("vertex_number") or fragment ("pixel", "depth", "triangle").
    placed: how a vertex shader hands on the clip position {0}. variables, functions: the names that none may have.
    most_outputs: colour attachments that every implementation has. head: the first lines of a shader.
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
    variables: frozenset[str]
    functions: frozenset[str]
    most_outputs: int
    head: tuple[str, ...]
    vertex: "Callable[[Parts, Dialect], str]"
    fragment: "Callable[[Parts, Dialect], str]"
    size: tuple[str, ...] = ()

    def name(self, name: str) -> str:
        """A variable's name; one that the language reserves ends in an underscore."""
        return f"{name}_" if name in self.variables else name

    def function(self, name: str) -> str:
        """A function's name; one that the language reserves ends in an underscore."""
        return f"{name}_" if name in self.functions else name

    def declared(self, kind: Any, name: str, length: int | None = None) -> str:
        """`type name`; a uniform array is an array of this length or, without one, a texture."""
        if length is not None and get_origin(kind) is Array:
            return f"{self.types[get_args(kind)[0]]} {self.name(name)}[{length}]"
        texture = get_origin(kind) in (Texture, Array)
        return f"{self.textures[get_args(kind)[0]] if texture else self.types[kind]} {self.name(name)}"

    def written(self, kind: Any, name: str) -> str:
        """`type name` of what a fragment shader writes for a buffer; none can write truth values."""
        return f"{'uint' if kind is bool else self.types[kind]} {OUT}{name}"

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
