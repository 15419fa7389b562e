"""Formats of textures, told from values put there by hand."""

import numpy as np
import pytest
from checked import check_of

from sss_ref.validation.cause.formats import formats

CODES = {  # storage -> its name, numbers that it holds, the least step between these
    "unorm8": ("8-bit unorm", [0, 51 / 255, 1], 1 / 255),
    "rgb10a2": ("RGB10A2", [0, 341 / 1023, 2 / 1023], 1 / 1023),
    "unorm16": ("16-bit unorm", [0, 13107 / 65535, 3 / 65535], 1 / 65535),
    "r11g11b10f": ("R11G11B10F", [0.25, 1.0, 3.0], 2.0**-5),
    "rgb9e5": ("RGB9E5", [0.25, 1.0, 1.0 + 2.0**-8], 2.0**-8),
    "float16": ("float16", [0.25, 1.0, 2.0 - 2.0**-10], 2.0**-10),
}


def told(check):
    """In words -> where they explain what was got."""
    return {text.partition(":")[0].removeprefix("it was stored as "): holds for text, holds in formats(check)}


@pytest.mark.parametrize("storage", CODES)
def test_a_format_explains_what_is_a_step_beside_what_it_should_be(storage):
    name, values, step = CODES[storage]
    got = np.array([[values]])
    assert (f'it was stored as {name}: declare encoding = "{storage}"') in dict(formats(check_of(got, got)))
    size = max(values) if storage == "rgb9e5" else values[1] if storage in ("r11g11b10f", "float16") else 1
    for off, holds in ((0.9 * step * size, True), (-0.9 * step * size, True), (1.2 * step * size, False)):
        beside = got + off * np.array([0, 1, 0])
        assert told(check_of(beside, got))[name].tolist() == [[holds]]
    assert told(check_of(got + 1.2 * step * size * np.array([0, 1, 0]), got, 0.3 * step * size))[name].all()


def test_what_lies_beyond_the_ends_of_a_format_is_cut_off():
    got, expected = np.array([[0.0, 1.0, 1.0, 51 / 255]]), np.array([[-3.0, 7.0, 0.9, 7.0]])
    assert told(check_of(expected, got))["8-bit unorm"].tolist() == [[True, True, False, False]]


def test_formats_of_three_channels_are_those_of_colours():
    one = np.array([[0.25, 1.0, 2.0]])
    assert set(told(check_of(one, one))) == {"float16"}
    assert set(told(check_of(one[..., None], one[..., None]))) == {"float16"}
    assert set(told(check_of([one], [one]))) == {"R11G11B10F", "RGB9E5", "float16"}
    tens = np.array([[1 / 1023, 341 / 1023, 2 / 1023]])
    assert not told(check_of(tens, tens)) and set(told(check_of([tens], [tens]))) == {"RGB10A2"}


def test_only_compared_pixels_count_and_each_must_be_held():
    got, where = np.array([[0.5, 1 / 3, np.inf]]), [[True, False, False]]
    assert set(told(check_of(got, got, where=where))) == {"float16"}
    assert not told(check_of(got, got, where=[[True, True, False]]))
    assert not told(check_of(got, got, where=[[True, False, True]]))


def test_a_number_may_be_rounded_on_its_way_to_float32():
    codes = np.array([[7, 85, 201]]) / 255
    assert "8-bit unorm" in told(check_of(codes, codes * (1 + 2.0**-23)))
    assert "8-bit unorm" not in told(check_of(codes, codes * (1 + 2.0**-20)))


@pytest.mark.parametrize(("code", "off", "holds"), [(200, 3.2, True), (200, 3.4, False), (200, -3.2, True)])
def test_a_step_of_srgb_near_white_is_more_than_a_code(code, off, holds):
    linear = ((code / 255 + 0.055) / 1.055) ** 2.4
    assert told(check_of([[linear + off / 255]], [[linear]]))["sRGB8"].tolist() == [[holds]]
