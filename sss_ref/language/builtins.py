"""The built-ins that are written in the language itself, named as in GLSL; no interpreter needs to know them."""

from sss_ref.language.intrinsics import floor, genType, max, min, number, select, sqrt
from sss_ref.language.stage import function
from sss_ref.language.types import vec3


@function
def clamp(x: number, low: number, high: number) -> number:
    """x, but not below low nor above high."""
    return min(max(x, low), high)


@function
def fract(x: genType) -> genType:
    """How far x lies above floor(x), x - floor(x); rounding makes it 1 just below 0."""
    return x - floor(x)


@function
def mix(a: genType, b: genType, t: float) -> genType:
    """Linear blend a*(1 - t) + b*t (rule A3)."""
    return a * (1.0 - t) + b * t


@function
def dot(a: vec3, b: vec3) -> float:
    """Scalar product (x*x' + y*y') + z*z' (rule A3)."""
    return (a.x * b.x + a.y * b.y) + a.z * b.z


@function
def cross(a: vec3, b: vec3) -> vec3:
    """Vector product, each component y*z' - z*y' (rule A3)."""
    return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)


@function
def length(v: vec3) -> float:
    """Euclidean length sqrt(dot(v, v)) (rule A3)."""
    return sqrt(dot(v, v))


@function
def normalize(v: vec3) -> vec3:
    """v / length(v); the zero vector stays zero, unlike GLSL, where it is undefined (rule A3)."""
    magnitude = length(v)
    return select(magnitude > 0.0, v / magnitude, vec3(0.0, 0.0, 0.0))


@function
def reflect(i: vec3, n: vec3) -> vec3:
    """Mirror image i - n*(2*dot(n, i)) of a direction at a surface with unit normal n (rule A3)."""
    return i - n * (2.0 * dot(n, i))
