"""The loss of a storage, carried along through what a mapping file says of the numbers, by hand."""

import numpy as np
import pytest

from sss_ref.dump.loss import DIAGONAL, LOSSES, ROUNDING, Loss
from sss_ref.dump.mapping import BufferTable
from sss_ref.dump.precision import encoding_of, largest

STORED = np.float32([[[0.75, -0.5, np.inf]]])  # the largest finite number is .75


def encoding(storage, loss=None, **said):
    return encoding_of(BufferTable(file="a.exr", **said), storage, loss, STORED)


def test_what_is_plain_has_the_loss_of_its_storage():
    plain = encoding("float16")
    assert plain.loss is None and plain.rounded_from is None and plain.storage == "float16"


MOVED = {
    "a scale": ({"scale": 2.0}, "unorm8", Loss(ROUNDING, 2 / 255, 0.0, 2.0)),
    "an offset": ({"offset": -0.5}, "unorm8", Loss(0.0, 1 / 255 + ROUNDING * 1.25, -0.5, 0.5)),
    "both": ({"scale": -1.0, "offset": 1.0}, "snorm8", Loss(0.0, 1 / 127 + ROUNDING * 1.75, 0.0, 2.0)),
    "scales": ({"scale": [2.0, -4.0, 0.5]}, "unorm8", Loss(ROUNDING, 4 / 255)),
    "offsets": ({"offset": [0.25, -3.0, 0.0]}, "unorm8", Loss(0.0, 1 / 255 + ROUNDING * 3.75)),
    "scales and an offset": ({"scale": [1.0, -2.0], "offset": 1.0}, "unorm8", Loss(0.0, 2 / 255 + ROUNDING * 2.5)),
    "normals from 0 to 1": ({"normals": "n*.5+.5"}, "unorm8", Loss(0.0, 2 / 255 + ROUNDING * 3, -1.0, 1.0)),
    "an octahedral map": ({"normals": "octahedral"}, "snorm8", Loss(0.0, 3 * (DIAGONAL / 127 + ROUNDING))),
    "view space": ({"space": "view"}, "snorm8", Loss(0.0, DIAGONAL / 127 + ROUNDING * 1.5)),
    "a scale in view space": (
        {"scale": 2.0, "offset": 0.5, "space": "view"},
        "snorm8",
        Loss(0.0, DIAGONAL * (2 / 127 + ROUNDING * 2) + ROUNDING * 4),
    ),
}


@pytest.mark.parametrize("name", MOVED)
def test_what_is_moved(name):
    said, storage, expected = MOVED[name]
    found = encoding(storage, **said)
    assert found.loss == expected and found.rounded_from is None


def test_floats_that_were_moved_have_more_bits_in_the_texture():
    assert encoding("float16", scale=2.0).rounded_from == "float32"
    assert encoding("float16", scale=2.0, rounded_from="unorm8").rounded_from == "unorm8"


def test_a_format_may_have_a_loss_of_its_own():
    """That of a compression; of bytes and packed formats the texture is no better."""
    own = Loss(0.0, 0.125)
    found = encoding("float16", own)
    assert found.loss == own and found.rounded_from is None
    assert encoding("float16", own, scale=2.0).rounded_from == "float32"
    assert encoding("rgb9e5").loss == Loss(0.0, 0.75 * 2.0**-8, 0.0, 65408.0)


def test_float24_is_what_a_file_left_of_a_texture():
    found = encoding("float24")
    assert found.loss is None and found.rounded_from == "float32"
    assert encoding("float24", scale=2.0).loss == LOSSES["float24"].scaled(2.0, 0.0, 0.75)


def test_the_largest_is_finite_and_0_of_none():
    assert largest(STORED) == 0.75
    assert largest(np.float32([np.nan, np.inf])) == 0
