"""Vectors and matrices component by component, in the order written (rules A1 and A3), by hand."""

import numpy as np
import pytest

from sss_ref.language.types import Array, Texture, components, ivec2, mat3, mat4, vec2, vec3, vec4

F = np.float32


def values(vector):
    return [float(each) for each in vector]


@pytest.mark.parametrize(
    ("made", "expected"),
    [
        (lambda a, b: a + b, [5, 10, 4]),
        (lambda a, b: a - b, [3, 6, -4]),
        (lambda a, b: a * b, [4, 16, 0]),
        (lambda a, b: b / a, [0.25, 0.25, None]),
        (lambda a, b: a + F(2), [6, 10, 2]),
        (lambda a, b: a - F(2), [2, 6, -2]),
        (lambda a, b: a * F(2), [8, 16, 0]),
        (lambda a, b: a / F(2), [2, 4, 0]),
        (lambda a, b: 2.0 + a, [6, 10, 2]),
        (lambda a, b: 2.0 - a, [-2, -6, 2]),
        (lambda a, b: 2.0 * a, [8, 16, 0]),
        (lambda a, b: 2.0 / b, [2, 1, 0.5]),
        (lambda a, b: -b, [-1, -2, -4]),
    ],
)
def test_arithmetic(made, expected):
    with np.errstate(divide="ignore"):
        found = values(made(vec3(F(4), F(8), F(0)), vec3(F(1), F(2), F(4))))
    assert [each for each, known in zip(found, expected, strict=True) if known is not None] == [
        known for known in expected if known is not None
    ]


def test_a_matrix_acts_on_a_column_row_by_row():
    assert values(mat3([[1, 2, 3], [4, 5, 6], [7, 8, 10]]) * vec3(F(1), F(-2), F(3))) == [6, 12, 21]
    four = mat4([[1, 2, 3, 4], [5, 6, 7, 8], [0, 1, 0, 2], [0, 0, 0, 1]])
    assert values(four * vec4(F(1), F(-2), F(3), F(-4))) == [-10, -18, -10, -4]


def test_the_sums_of_a_row_are_rounded_from_the_left():
    """1 + 2^-24 is 1 in float32, 2^-24 + 2^-24 is not nothing."""
    tiny = F(2.0**-24)
    assert values(mat3([[1, 1, 1], [1, 1, 1], [1, 1, 1]]) * vec3(F(1), tiny, tiny))[0] == 1.0
    assert values(mat3([[1, 1, 1], [1, 1, 1], [1, 1, 1]]) * vec3(tiny, tiny, F(1)))[0] == 1.0 + 2.0**-23
    row = [[1, 1, 1, 1]] * 4
    assert values(mat4(row) * vec4(F(1), tiny, tiny, tiny))[0] == 1.0
    assert values(mat4(row) * vec4(tiny, tiny, F(1), F(0)))[0] == 1.0 + 2.0**-23


def test_a_vector_is_made_of_vectors_and_numbers():
    assert values(vec4(vec2(F(1), F(2)), vec2(F(3), F(4))).xyz) == [1, 2, 3]
    assert values(vec4(vec3(F(1), F(2), F(3)), F(4)).xy) == [1, 2]
    with pytest.raises(TypeError, match=r"^vec3 has 3 components, got 2$"):
        vec3(F(1), F(2))
    assert components(vec2(F(1), F(2))) == [1, 2] and components(F(3)) == [3]


def test_a_texel_is_at_its_column_and_row():
    numbers, colors = np.arange(6, dtype=F).reshape(2, 3), np.arange(18, dtype=F).reshape(2, 3, 3)
    at = ivec2(2, 1)
    assert Texture(numbers).fetch(at) == 5.0
    assert values(Texture(colors).fetch(at)) == [15, 16, 17]
    assert [bool(Texture(np.array([[0, 1]], np.uint8)).fetch(ivec2(k, 0))) for k in (0, 1)] == [False, True]
    assert values(Array(colors[0])[1]) == [3, 4, 5] and Array(numbers[0])[2] == 2.0


@pytest.mark.parametrize("vector", [vec2, vec3, vec4])
def test_a_texel_of_several_channels_is_a_vector_of_as_many(vector):
    """Of 5 x 7 texels, and of 7 elements."""
    stored = np.arange(7 * 5 * vector.count, dtype=F).reshape(7, 5, vector.count)
    for found, expected in (
        (Texture(stored).fetch(ivec2(4, 6)), stored[6, 4]),
        (Texture(stored).fetch(ivec2(0, 5)), stored[5, 0]),
        (Array(stored[:, 1])[6], stored[6, 1]),
    ):
        assert type(found) is vector and values(found) == expected.tolist()
