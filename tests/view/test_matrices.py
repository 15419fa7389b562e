import numpy as np
import pytest

from sss_ref.errors import SceneError
from sss_ref.view.matrices import (
    look_at,
    mirrors,
    normal_matrix,
    orthographic,
    outward,
    perspective,
    placement,
    product,
    rotation,
    scaling,
    transformed,
)


def vector(*components):
    return np.array(components, np.float64)


def test_product_sums_in_the_written_order():
    generator = np.random.default_rng(1)
    for a, b in generator.standard_normal((20, 2, 4, 4)):
        for row, column in np.ndindex(4, 4):
            p = [float(a[row, k]) * float(b[k, column]) for k in range(4)]
            assert product(a, b)[row, column] == ((p[0] + p[1]) + p[2]) + p[3]


def test_points_are_transformed_in_the_written_order():
    generator = np.random.default_rng(2)
    matrix, points = generator.standard_normal((4, 4)), generator.standard_normal((20, 3)).astype(np.float32)
    for point, found in zip(points.astype(float).tolist(), transformed(matrix, points).tolist(), strict=True):
        assert found == [((m[0] * point[0] + m[1] * point[1]) + m[2] * point[2]) + m[3] for m in matrix[:3].tolist()]


@pytest.mark.parametrize(
    ("azimuth", "elevation", "expected"),
    [(60, 30, (0.75, 0.5, 0.75**0.5 / 2)), (-30, 60, (-0.25, 0.75**0.5, 0.75**0.5 / 2)), (0, -90, (0, -1, 0))],
)
def test_a_place_on_the_globe(azimuth, elevation, expected):
    assert outward(azimuth, elevation) == pytest.approx(expected, rel=1e-15)


def test_placement_scales_then_turns_about_x_y_z_then_moves():
    x = vector([1, 0, 0])
    assert np.array_equal(transformed(placement((2, 1, 1), (0, 0, 0), (0, 0, 0)), x), [[2, 0, 0]])
    assert np.array_equal(transformed(placement((2, 1, 1), (0, 0, 90), (5, 0, 0)), x), [[5, 2, 0]])
    assert np.array_equal(transformed(placement((1, 1, 1), (0, 90, 90), (0, 0, 0)), x), [[0, 0, -1]])
    assert np.array_equal(transformed(placement((1, 1, 1), (90, 90, 0), (0, 0, 0)), vector([0, 1, 0])), [[1, 0, 0]])


@pytest.mark.parametrize("axis, before, after", [(0, 1, 2), (1, 2, 0), (2, 0, 1)])
def test_rotation_is_counter_clockwise(axis, before, after):
    assert np.array_equal(rotation(axis, 90)[:3, before], np.eye(3)[after])


def test_rotation_of_a_quarter_about_z_by_hand():
    assert np.array_equal(rotation(2, 90), [[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def test_look_at_by_hand():
    # An eye at (3, 2, 0) looking along -X: right is -Z, up is +Y, backward is +X.
    expected = [[0, 0, -1, 0], [0, 1, 0, -2], [1, 0, 0, -3], [0, 0, 0, 1]]
    assert np.array_equal(look_at(vector(3, 2, 0), vector(0, 2, 0), vector(0, 7, 0)), expected)


@pytest.mark.parametrize("height", [1.0, -1.0])
def test_looking_along_up_takes_z_for_up(height):
    matrix = look_at(vector(0, height, 0), vector(0, 0, 0), vector(0, 1, 0))
    assert np.array_equal(matrix[1, :3], [0, 0, 1])


def test_up_holds_until_the_cosine_is_9999():
    # cos = 1 / sqrt(1 + t^2): t = .0142 gives .999899 < .9999, t = .0141 gives .9999006.
    def upright(t):
        return look_at(vector(t, -1, 0), vector(0, 0, 0), vector(0, 1, 0))[1, :3]

    assert upright(0.0142)[2] == 0
    assert upright(0.0141)[2] == 1
    across = (1 - 0.9999**2) ** 0.5
    assert look_at(vector(across, -0.9999, 0), vector(0, 0, 0), vector(0, 1, 0))[1, 2] == 0  # the bound itself


def test_no_up_is_left_along_z():
    with pytest.raises(SceneError) as error:
        look_at(vector(0, 0, 1), vector(0, 0, 0), vector(0, 0, 1))
    assert str(error.value) == ("expected an up across the line of sight, got one along it; give up = [0.0, 1.0, 0.0]")


def test_eye_at_target_is_refused():
    with pytest.raises(SceneError, match=r"^expected a line of sight, got an eye at its target; move one of the two$"):
        look_at(vector(1, 2, 3), vector(1, 2, 3), vector(0, 1, 0))


def test_perspective_by_hand():
    # tan 45 = 1; aspect 2; near 1, far 3: z = (-2 z - 3), w = -z.
    expected = [[0.5, 0, 0, 0], [0, 1, 0, 0], [0, 0, -2, -3], [0, 0, -1, 0]]
    assert np.array_equal(perspective(90, 2, 1, 3), expected)


def test_a_perspective_from_beyond_1():
    # Near 2, far 6: z = (-2 z - 6), which is -2 and 6 there, and w is 2 and 6.
    assert np.array_equal(perspective(90, 1, 2, 6)[2], [0, 0, -2, -6])


def test_a_narrow_perspective():
    """Tan 30 = 1 / sqrt 3: what lies at that angle comes to the upper edge."""
    matrix = perspective(60, 2, 1, 3)
    assert (matrix[0, 0], matrix[1, 1]) == pytest.approx((3**0.5 / 2, 3**0.5), rel=1e-15)


def test_a_placement_is_a_matrix_of_four_rows():
    expected = [[2, 0, 0, 5], [0, 3, 0, 6], [0, 0, 4, 7], [0, 0, 0, 1]]
    assert np.array_equal(placement((2, 3, 4), (0, 0, 0), (5, 6, 7)), expected)


def test_normal_matrix_is_the_inverse_transpose():
    assert np.array_equal(normal_matrix(placement((2, 4, -8), (0, 0, 0), (1, 2, 3))), np.diag([0.5, 0.25, -0.125]))
    turned = rotation(1, 90)
    assert np.array_equal(normal_matrix(turned), turned[:3, :3])
    # A shear x' = x + 2 y keeps the plane y = 0 and tilts x = 0: its normal (1, 0, 0) becomes (1, -2, 0).
    sheared = np.eye(4)
    sheared[0, 1] = 2
    assert np.array_equal(normal_matrix(sheared), [[1, 0, 0], [-2, 1, 0], [0, 0, 1]])


def test_orthographic():
    """4 x 2 units wide and high, from 1 to 5 ahead: its corners are those of the clip space, and w is 1."""
    corners = np.array([[-2, -1, -1, 1], [2, 1, -5, 1], [0, 0, -3, 1]]) @ orthographic(2.0, 2.0, 1.0, 5.0).T
    assert corners.tolist() == [[-1, -1, -1, 1], [1, 1, 1, 1], [0, 0, 0, 1]]


@pytest.mark.parametrize(
    "factors, expected", [((0.5, 0.5, 0.5), False), ((0.5, -0.5, 0.5), True), ((-2, -3, 4), False), ((0, 1, 1), False)]
)
def test_an_odd_number_of_mirrored_axes_mirrors(factors, expected):
    """However small: the determinant is .125, -.125, 24, 0."""
    assert mirrors(scaling(factors)) == expected
