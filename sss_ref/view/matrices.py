"""The matrices of a scene: float64, row-major M[row, column], acting on column vectors.

Every product is written out in a fixed order, because a matrix library may choose its own (rule A4). Space names
read from left to right: `world_from_model` takes model space to world space.
"""

import math

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.numerics.trigonometry import cosine, sine, tangent

Matrix = NDArray[np.float64]
Vector = NDArray[np.float64]

NEARLY_PARALLEL = 0.9999  # |cosine| beyond which `up` says nothing about the image's upright


def product(left: Matrix, right: Matrix) -> Matrix:
    """The product of 4 x 4 matrices: each element ((l0*r0 + l1*r1) + l2*r2) + l3*r3."""
    terms: list[Matrix] = [left[:, k, np.newaxis] * right[k] for k in range(4)]
    return ((terms[0] + terms[1]) + terms[2]) + terms[3]


def transformed(matrix: Matrix, points: NDArray[np.floating]) -> NDArray[np.float64]:
    """Points (N, 3) under an affine 4 x 4 matrix, float64: ((m0*x + m1*y) + m2*z) + m3."""
    x, y, z = points.astype(np.float64).T
    return np.stack([((row[0] * x + row[1] * y) + row[2] * z) + row[3] for row in matrix[:3]], axis=1)


def dot(a: Vector, b: Vector) -> float:
    """(a0*b0 + a1*b1) + a2*b2."""
    return float((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2])


def cross(a: Vector, b: Vector) -> Vector:
    """The vector product, each component one difference of two products."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def length(v: Vector) -> float:
    """sqrt(dot(v, v))."""
    return math.sqrt(dot(v, v))


def translation(offset: Vector) -> Matrix:
    """Moves by `offset`."""
    matrix = np.eye(4)
    matrix[:3, 3] = offset
    return matrix


def scaling(factors: Vector) -> Matrix:
    """Multiplies each axis by its factor."""
    return np.diag([*factors, 1.0])


def rotation(axis: int, degrees: float) -> Matrix:
    """Turns about a coordinate axis (0, 1, 2 = X, Y, Z), counter-clockwise seen from its tip."""
    c, s = cosine(degrees), sine(degrees)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(4)
    matrix[first, first], matrix[first, second] = c, -s
    matrix[second, first], matrix[second, second] = s, c
    return matrix


def outward(azimuth: float, elevation: float) -> Vector:
    """The direction from the middle of a globe to a place on it: (cos el * sin az, sin el, cos el * cos az).

    azimuth: degrees about +Y, 0 towards +Z, 90 towards +X. elevation: degrees above the horizon.
    """
    level = cosine(elevation)
    return np.array([level * sine(azimuth), sine(elevation), level * cosine(azimuth)])


def placement(scale: Vector, rotate_degrees: Vector, translate: Vector) -> Matrix:
    """world_from_model = translate * (Z * (Y * (X * scale))): scaled first, translated last."""
    matrix = scaling(scale)
    for axis, degrees in enumerate(rotate_degrees):
        matrix = product(rotation(axis, degrees), matrix)
    return product(translation(translate), matrix)


def look_at(eye: Vector, target: Vector, up: Vector) -> Matrix:
    """view_from_world of an eye that looks at `target`: right, up and backward become X, Y and Z.

    Where `up` is nearly parallel to the line of sight, +Z is used. Raises SceneError where that fails too, or where
    the eye is at its target.
    """
    forward = _unit(target - eye)
    if abs(dot(forward, _unit(up))) > NEARLY_PARALLEL:
        up = np.array([0.0, 0.0, 1.0])
    if abs(dot(forward, _unit(up))) > NEARLY_PARALLEL:
        raise SceneError("expected an up across the line of sight, got one along it; give up = [0.0, 1.0, 0.0]")
    right = _unit(cross(forward, up))
    matrix = np.eye(4)
    for row, axis in enumerate((right, cross(right, forward), -forward)):
        matrix[row, :3] = axis
        matrix[row, 3] = -dot(axis, eye)
    return matrix


def perspective(fov_y: float, aspect: float, near: float, far: float) -> Matrix:
    """clip_from_view in OpenGL's convention: z in [-w, w], w = -z_view.

    fov_y: vertical field of view, degrees; aspect: width / height; near, far: distances, scene units.
    """
    half_height = tangent(fov_y / 2)
    matrix = np.zeros((4, 4))
    matrix[0, 0] = 1 / (half_height * aspect)
    matrix[1, 1] = 1 / half_height
    matrix[2, 2] = (far + near) / (near - far)
    matrix[2, 3] = (2 * far * near) / (near - far)
    matrix[3, 2] = -1
    return matrix


def orthographic(view_height: float, aspect: float, near: float, far: float) -> Matrix:
    """clip_from_view in OpenGL's convention for parallel rays: z in [-1, 1], w = 1.

    view_height: of what the picture shows, scene units; the others as in `perspective`.
    """
    matrix = np.zeros((4, 4))
    matrix[0, 0] = 2 / (view_height * aspect)
    matrix[1, 1] = 2 / view_height
    matrix[2, 2] = 2 / (near - far)
    matrix[2, 3] = (far + near) / (near - far)
    matrix[3, 3] = 1
    return matrix


def normal_matrix(matrix: Matrix) -> Matrix:
    """The 3 x 3 inverse transpose of a 4 x 4 matrix's upper part, by cofactors: what normals are multiplied by.

    Rule R6. The determinant must not be 0.
    """
    x, y, z = matrix[:3, :3]
    cofactors = np.array([cross(y, z), cross(z, x), cross(x, y)])
    return cofactors / dot(x, cofactors[0])


def mirrors(matrix: Matrix) -> bool:
    """Whether a 4 x 4 matrix turns left into right: the determinant of its upper part is below 0."""
    x, y, z = matrix[:3, :3]
    return dot(x, cross(y, z)) < 0


def _unit(v: Vector) -> Vector:
    size = length(v)
    if size == 0:
        raise SceneError("expected a line of sight, got an eye at its target; move one of the two")
    return v / size
