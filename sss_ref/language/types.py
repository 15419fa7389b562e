"""The types of the shader language, as values: vectors, matrices, textures and uniform arrays.

A component of a vector is whatever the interpreter computes with: a float32 scalar, an array with one float32 per
fragment, later an interval. All arithmetic is component by component, in the order written (rules A1 and A3).
"""

from collections.abc import Iterator
from typing import Any, ClassVar, Generic, Self, TypeVar

import numpy as np

T = TypeVar("T")


def constant(value: float) -> float:
    """A named constant of a stage's module, rounded to float32: literals in a stage must be exact, these need not."""
    return np.float32(value)  # type: ignore[return-value]


class Vector:
    """What vec2, vec3, vec4 and ivec2 share: component-wise + - * / with their like or with a scalar."""

    __slots__ = ("w", "x", "y", "z")
    __array_ufunc__ = None  # so that ndarray * vec3 asks vec3, not NumPy
    count: ClassVar[int]

    def __init__(self, *parts: Any) -> None:
        components = [component for part in parts for component in (part if isinstance(part, Vector) else (part,))]
        if len(components) != self.count:
            raise TypeError(f"{type(self).__name__} has {self.count} components, got {len(components)}")
        for name, component in zip("xyzw", components, strict=False):
            setattr(self, name, component)

    def __iter__(self) -> Iterator[Any]:
        return (getattr(self, name) for name in "xyzw"[: self.count])

    def _paired(self, other: Any) -> Iterator[tuple[Any, Any]]:
        if isinstance(other, Vector):
            return zip(self, other, strict=True)
        return ((component, other) for component in self)

    def __add__(self, other: Self | float) -> Self:
        return type(self)(*(a + b for a, b in self._paired(other)))

    def __sub__(self, other: Self | float) -> Self:
        return type(self)(*(a - b for a, b in self._paired(other)))

    def __mul__(self, other: Self | float) -> Self:
        return type(self)(*(a * b for a, b in self._paired(other)))

    def __truediv__(self, other: Self | float) -> Self:
        return type(self)(*(a / b for a, b in self._paired(other)))

    def __radd__(self, other: float) -> Self:
        return type(self)(*(other + a for a in self))

    def __rsub__(self, other: float) -> Self:
        return type(self)(*(other - a for a in self))

    def __rmul__(self, other: float) -> Self:
        return type(self)(*(other * a for a in self))

    def __rtruediv__(self, other: float) -> Self:
        return type(self)(*(other / a for a in self))

    def __neg__(self) -> Self:
        return type(self)(*(-a for a in self))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(map(str, self))})"


class vec2(Vector):
    """Two floats: a texture coordinate, an offset in pixels."""

    __slots__ = ()
    count = 2
    x: float
    y: float


class vec3(Vector):
    """Three floats: a position, a direction, a linear RGB colour."""

    __slots__ = ()
    count = 3
    x: float
    y: float
    z: float


class vec4(Vector):
    """Four floats: a clip-space position."""

    __slots__ = ()
    count = 4
    x: float
    y: float
    z: float
    w: float

    @property
    def xy(self) -> vec2:
        """The first two components."""
        return vec2(self.x, self.y)

    @property
    def xyz(self) -> vec3:
        """The first three components."""
        return vec3(self.x, self.y, self.z)


class ivec2(Vector):
    """Two integers: a pixel or texel (column, row), row 0 at the bottom."""

    __slots__ = ()
    count = 2
    x: int
    y: int


class _Matrix:
    """A square matrix of uniforms, M[row][column], that acts on column vectors."""

    __slots__ = ("rows",)

    def __init__(self, values: Any) -> None:
        self.rows = [[np.float32(value) for value in row] for row in values]


class mat3(_Matrix):
    """3 x 3; mat3 * vec3 = per row (m0*x + m1*y) + m2*z (rule A3)."""

    __slots__ = ()

    def __mul__(self, v: vec3) -> vec3:
        return vec3(*((row[0] * v.x + row[1] * v.y) + row[2] * v.z for row in self.rows))


class mat4(_Matrix):
    """4 x 4; mat4 * vec4 = per row ((m0*x + m1*y) + m2*z) + m3*w (rule A3)."""

    __slots__ = ()

    def __mul__(self, v: vec4) -> vec4:
        return vec4(*(((row[0] * v.x + row[1] * v.y) + row[2] * v.z) + row[3] * v.w for row in self.rows))


def components(value: Any) -> list[Any]:
    """The scalars a value consists of: a vector's components, or the value itself."""
    return list(value) if isinstance(value, Vector) else [value]


class _Rows(Generic[T]):
    """An ndarray whose last axis, if there is one more than the index has, holds the components of a T."""

    __slots__ = ("data",)
    index_axes: ClassVar[int]

    def __init__(self, data: np.ndarray) -> None:
        self.data = data

    def _at(self, index: Any) -> Any:
        values = self.data[index]
        if self.data.ndim == self.index_axes:
            return values
        vector = {2: vec2, 3: vec3, 4: vec4}[self.data.shape[-1]]
        return vector(*(values[..., k][()] for k in range(self.data.shape[-1])))


class Texture(_Rows[T]):
    """A finished buffer that a stage reads at any texel: Texture[float], Texture[vec3]; data (H, W) or (H, W, C)."""

    __slots__ = ()
    index_axes = 2

    def fetch(self, at: ivec2) -> T:
        """The stored value at a texel inside the texture (GLSL texelFetch)."""
        value = self._at((at.y, at.x))
        stored: T = value != 0 if self.data.dtype == np.uint8 else value
        return stored


class Array(_Rows[T]):
    """A uniform array: Array[float], Array[vec3]; data (N,) or (N, C)."""

    __slots__ = ()
    index_axes = 1

    def __getitem__(self, index: int) -> T:
        element: T = self._at(index)
        return element
