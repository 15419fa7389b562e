"""What tells one shading language from another, as far as the stages need it."""

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, get_args, get_origin

from sss_ref.language.types import Array, Texture, Vector, vec2, vec3, vec4
from sss_ref.language.typing_rules import type_name

ARRAY_WIDTH = 4096  # texels in a row of a texture that holds a long uniform array
FLOATING = (float, vec2, vec3, vec4)
TARGET_BYTES = {float: 4, int: 4, bool: 4, vec2: 8, vec3: 16, vec4: 16}  # of a pixel; a byte begins where 4 may
OUT = "out_"  # how the name of a fragment shader's output begins; the buffer's name follows


@dataclass(frozen=True)
class Parts:
    """What a complete shader consists of; `lines` are the statements of its `main`.

    about: its first comment. textures, uniforms: what the application binds, name -> type; a texture that holds a long
    uniform array has the type of that. lengths: of the arrays among the uniforms. varyings: what goes from vertex to
    fragment. definitions: constants, structs and functions. mesh: whether it draws the mesh, not a rectangle.
    attributes: what a vertex shader reads of its vertex. outputs: what a fragment shader writes, by buffer.
    read: the names that the stages of a fragment shader read.
    """

    about: str
    textures: Mapping[str, Any]
    uniforms: Mapping[str, Any]
    lengths: Mapping[str, int]
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
class Wording:
    """How a language writes definitions and statements; the defaults are those of C's kin.

    declaration: a variable, parameter or field of a name and a type. array: one of a length. fixed, changing: the
    statement that gives a variable {declared} its value, once or at first. function: the head of one. field,
    struct_end: a field of a struct, and its end. loop: the head of one, from {start} to below {stop}. stop: what ends
    a fragment for which {condition} does not hold. handed: how a shader sets one of its outputs. output: what finds in
    a fragment shader the outputs that it declares, as a regular expression; example: one of them.
    """

    declaration: str = "{type} {name}"
    array: str = "{type} {name}[{length}]"
    fixed: str = "{declared} = {value};"
    changing: str = "{declared} = {value};"
    function: str = "{result} {name}({parameters})"
    field: str = "{declared};"
    struct_end: str = "};"
    loop: str = "for (int {index} = {start}; {index} < {stop}; {index}++)"
    output: str = rf"layout\s*\(\s*location\s*=\s*(?P<at>\d+)\s*\)\s*(?:precise\s+)?out\s+\w+\s+{OUT}(?P<name>\w+)\s*;"
    example: str = f"layout(location = 0) out vec3 {OUT}NAME"
    stop: str = "if (!({condition})) discard;"
    handed: str = "{name} = {value};"


@dataclass(frozen=True)
class Dialect:
    """A shading language.

    title: its name. types: type -> its name. textures: type of a texel -> the texture's type. calls: primitive -> how
    it is written, with {0}, {1} for the arguments; also "!=" of two numbers, where the language's own is wrong for NaN.
    texel, element: how a texture {0}, or a long array in one, is read at {1}; {2} is the type of what is read.
    four_channels: whether a texel has four, whatever its texture holds.
    products: type of a matrix m -> its product with the vector v. splat: a vector of type {0}, each component {1}.
    written: how definitions and statements are written. constant: what stands before a constant. exact: what stands
    before values whose sums must stay as written; compilers look no further than the function, so that every function
    says it of its own. overloads: whether functions of one name may take other types.
    returned: how a function returns a struct. size: the statements that return the size of the texture `map`, where
    `calls` has it not. given: what the GPU tells a vertex ("vertex_number") or fragment ("pixel", "depth", "triangle").
    placed: how a vertex shader hands on the clip position {0}. reserved: the names that nothing of ours may have, words
    and built-in functions: some compilers let nobody define those anew, and none lets them stand beside a uniform of
    that name. most_outputs: colour attachments that every implementation has. head: the first lines of a shader.
    vertex, fragment: what lays out a complete shader. targets: of types that no target holds, the one that it holds in
    their place, and how a value becomes one. most_bytes: of all targets of a draw together, of each pixel.
    longest_array: elements of a uniform array; OpenGL 3.3 promises room for 1024 numbers in all. groups: the set or
    group of what the vertex shader reads, and of what the fragment shader does, where bindings have numbers; constants
    have number 0 there, textures those from `first_texture` on. indexed: whether triangles may be drawn with indices.
    """

    title: str
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
    written: Wording = Wording()
    overloads: bool = True
    targets: Mapping[Any, tuple[str, str]] = field(default_factory=lambda: {bool: ("uint", "uint({0})")})
    most_bytes: int | None = None
    longest_array: int = 64
    groups: tuple[int, int] | None = None
    first_texture: int = 1
    indexed: bool = True

    def name(self, name: str) -> str:
        """The name of a variable or function; one that the language keeps for itself ends in an underscore."""
        return clear_of(self.reserved, name)

    def type(self, kind: Any) -> str:
        """The name of a type: of a value, a texture, a uniform array that is a texture, or the struct of a stage."""
        if get_origin(kind) in (Texture, Array):
            return self.textures[get_args(kind)[0]]
        return self.types.get(kind) or type_name(kind)

    def declared(self, kind: Any, name: str, length: int | None = None) -> str:
        """A variable with its type; a uniform array is an array of this length or, without one, a texture."""
        if length is not None and get_origin(kind) is Array:
            element = self.types[get_args(kind)[0]]
            return self.written.array.format(type=element, name=self.name(name), length=length)
        return self.written.declaration.format(type=self.type(kind), name=self.name(name))

    def computed(self, kind: Any, name: str) -> str:
        """A variable whose sums must stay as written, also where they are only compared, with its type."""
        return f"{self.exact if kind in (*FLOATING, bool) else ''}{self.declared(kind, name)}"

    def defined(self, kind: Any, name: str, value: str) -> str:
        """The statement that gives a variable its only value."""
        return self.written.fixed.format(declared=self.declared(kind, name), value=value)

    def target(self, kind: Any, name: str) -> str:
        """What a fragment shader writes for a buffer, with its type."""
        stored = self.targets[kind][0] if kind in self.targets else self.types[kind]
        return self.written.declaration.format(type=stored, name=self.out(name))

    def stored(self, kind: Any, name: str) -> str:
        """The statement that writes a buffer."""
        form = self.targets[kind][1] if kind in self.targets else "{0}"
        return self.written.handed.format(name=self.out(name), value=form.format(self.name(name)))

    def bound(self, textures: Mapping[str, Any]) -> dict[str, int]:
        """Texture -> the number of its binding."""
        return {name: number for number, name in enumerate(textures, start=self.first_texture)}

    def has_room(self, kinds: Sequence[Any]) -> bool:
        """Whether a draw can fill targets of these types at once."""
        few_bytes = self.most_bytes is None or sum(TARGET_BYTES[kind] for kind in kinds) <= self.most_bytes
        return len(kinds) <= self.most_outputs and few_bytes

    def out(self, buffer: str) -> str:
        """The name of what a fragment shader writes for a buffer."""
        return clear_of((), OUT + buffer)

    def fetched(self, kind: Any, texture: str, at: str) -> str:
        """The texel of this type at `at`."""
        return self._typed(kind, self.texel.format(texture, at, type_name(kind)))

    def looked_up(self, kind: Any, texture: str, index: str) -> str:
        """The element of this type of a long uniform array."""
        return self._typed(kind, self.element.format(texture, index, type_name(kind)))

    def _typed(self, kind: Any, texel: str) -> str:
        vector = isinstance(kind, type) and issubclass(kind, Vector)
        letters = "xyzw"[: kind.count] if vector else "x"
        value = f"{texel}.{letters}" if self.four_channels and len(letters) < 4 else texel
        return f"{value} != 0u" if kind is bool else value
