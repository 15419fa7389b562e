"""Values as the bits of their numbers: IEEE 754, two's complement and base 64 (RFC 4648), typed by hand."""

import numpy as np
import pytest

from sss_ref.language.types import Array, Texture, components, ivec2, mat3, mat4, vec2, vec3
from sss_ref.validation.witness.bits_text import (
    bits_of,
    element_of,
    elements_in,
    elements_text,
    ends_in,
    ends_of,
    is_many,
    value_of,
)

F = np.float32
COUNTED = ["00000000", "3f800000", "40000000", "40400000", "40800000", "40a00000", "40c00000", "40e00000", "41000000"]
COUNTED += ["41100000", "41200000", "41300000", "41400000", "41500000", "41600000", "41700000"]  # 0 to 15
TEXTS = {
    "3f800000": (float, F(1)),
    "80000000": (float, F(-0.0)),
    "fffffffe": (int, -2),
    "00000001": (bool, True),
    "00000000": (bool, False),
    "00000003 ffffffff": (ivec2, ivec2(3, -1)),
    "3f800000 c0000000": (vec2, vec2(F(1), F(-2))),
    "3f800000 c0000000 3e800000": (vec3, vec3(F(1), F(-2), F(0.25))),
    " ".join(COUNTED[:9]): (mat3, mat3(np.arange(9).reshape(3, 3))),
    " ".join(COUNTED): (mat4, mat4(np.arange(16).reshape(4, 4))),
}


@pytest.mark.parametrize("text", TEXTS)
def test_a_value_as_its_bits_and_back(text):
    kind, value = TEXTS[text]
    assert bits_of(kind, value) == text
    again = value_of(kind, text)
    assert type(again) is type(value)
    if kind in (mat3, mat4):
        assert again.rows == value.rows
    else:
        assert components(again) == components(value)
        assert [*map(type, components(again))] == [*map(type, components(value))]
        assert bits_of(kind, again) == text


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        (float, ""),
        (float, "3f80"),
        (float, "3f800000 3f800000"),
        (float, "one"),
        (vec3, "3f800000 3f800000"),
        (vec2, "3f800000 3f800000 3f800000"),
        (mat3, " ".join(COUNTED[:8])),
        (mat4, " ".join(COUNTED[:9])),
    ],
)
def test_other_bits_are_no_value(kind, text):
    with pytest.raises(ValueError):
        value_of(kind, text)


@pytest.mark.parametrize(
    ("kind", "ends", "text"),
    [
        (float, [1.0], "3ff0000000000000"),
        (vec2, [1.0, -np.inf], "3ff0000000000000 fff0000000000000"),
        (int, [3], "00000003"),
        (ivec2, [3, -1], "00000003 ffffffff"),
        (bool, [1], "00000001"),
    ],
)
def test_ends_have_twice_the_bits_of_a_float(kind, ends, text):
    assert ends_of(kind, ends) == text
    assert ends_in(kind, text).tolist() == ends
    with pytest.raises(ValueError):
        ends_in(kind, text[:-2])


@pytest.mark.parametrize(
    ("kind", "elements", "text"),
    [
        (Texture[float], F([[1]]), "AACAPw=="),
        (Array[float], F([[1], [2]]), "AACAPwAAAEA="),
        (Texture[vec2], F([[1, 2]]), "AACAPwAAAEA="),
        (Texture[int], np.int32([[-2]]), "/v///w=="),
        (Texture[bool], np.uint8([[1], [0]]), "AQA="),
        (Texture[float], np.zeros((0, 1), F), ""),
    ],
)
def test_elements_in_base_64_and_back(kind, elements, text):
    assert elements_text(kind, elements) == text
    again = elements_in(kind, text)
    assert again.dtype == elements.dtype and np.array_equal(again, elements) and again.shape == elements.shape


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        (Texture[float], "AACA?Pw=="),  # a letter that there is none of
        (Texture[float], "AACAPw"),
        (Texture[float], "AACAP0A="),  # five bytes
        (Texture[vec2], "AACAPw=="),  # half an element
        (Texture[vec2], "AACAPwAAAEAAAEBA"),  # one and a half
    ],
)
def test_other_text_is_no_elements(kind, text):
    with pytest.raises(ValueError):
        elements_in(kind, text)


def test_what_holds_many_elements():
    assert is_many(Texture[vec3]) and is_many(Array[int]) and not is_many(vec3) and not is_many(mat4)
    assert element_of(Texture[vec3]) is vec3 and element_of(Array[int]) is int
