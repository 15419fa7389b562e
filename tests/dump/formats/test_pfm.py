"""PFM files written here byte by byte: three lines, then float32 from the bottom row up (Netpbm's description)."""

import numpy as np
import pytest

from sss_ref.dump.files import BOTTOM_FIRST, parts_of
from sss_ref.dump.loss import Loss
from sss_ref.errors import DumpError

VALUES = np.random.default_rng(1).random((2, 3, 3), np.float32)


def read(tmp_path, data):
    (tmp_path / "x.pfm").write_bytes(data)
    (texels,) = parts_of(tmp_path / "x.pfm")
    return texels


@pytest.mark.parametrize(
    ("header", "order"),
    [
        (b"PF\n3 2\n-1.0\n", "<f4"),
        (b"PF\n3 2\n1.0\n", ">f4"),
        (b"PF 3 2 -1e0 ", "<f4"),
        (b"PF\r\n3 2\r\n-1\r\n", "<f4"),
    ],
)
def test_colour_in_both_byte_orders(tmp_path, header, order):
    texels = read(tmp_path, header + VALUES.astype(order).tobytes())
    assert np.array_equal(texels.data, VALUES) and texels.data.dtype == np.float32
    assert (texels.channels, texels.storage, texels.notes) == (("R", "G", "B"), "float32", ())
    assert ".pfm" in BOTTOM_FIRST


@pytest.mark.parametrize("scale", [1e-3, 0.5, 2.0, 1e3])
def test_any_scale_above_0_is_big_endian_and_any_below_little(tmp_path, scale):
    for sign, order in ((1, ">f4"), (-1, "<f4")):
        texels = read(tmp_path, b"PF\n3 2\n%g\n" % (sign * scale) + VALUES.astype(order).tobytes())
        assert np.array_equal(texels.data, (VALUES.astype(np.float64) * np.float32(scale)).astype(np.float32))


def test_a_header_has_256_bytes_at_most(tmp_path):
    def long_header(size):
        return b"PF\n" + b" " * (size - 14) + b"3 2\n-1.000\n" + VALUES.astype("<f4").tobytes()

    assert np.array_equal(read(tmp_path, long_header(256)).data, VALUES)
    with pytest.raises(DumpError, match="a height and a scale, got another header"):
        read(tmp_path, long_header(257))


def test_grey(tmp_path):
    texels = read(tmp_path, b"Pf\n3 2\n-1\n" + VALUES[..., 0].astype("<f4").tobytes())
    assert np.array_equal(texels.data[..., 0], VALUES[..., 0]) and texels.channels == ("R",)


def test_the_scale_multiplies_and_it_is_said(tmp_path):
    texels = read(tmp_path, b"PF\n3 2\n-0.5\n" + VALUES.astype("<f4").tobytes())
    assert np.array_equal(texels.data, VALUES / 2)
    assert texels.notes == ("multiplied by the scale of its header, 0.5",) and texels.loss == Loss(2.0**-23)


def test_a_first_sample_that_looks_like_white_space(tmp_path):
    values = np.frombuffer(b"\n\n\n\n" * 18, "<f4").reshape(2, 3, 3)
    assert np.array_equal(read(tmp_path, b"PF\n3 2\n-1.0\n" + values.tobytes()).data, values)


@pytest.mark.parametrize(
    ("data", "came"),
    [
        (b"", "got another header"),
        (b"P6\n3 2\n255\n" + bytes(18), "got another header"),
        (b"PF\n3 2\n0\n" + bytes(72), "got another header"),
        (b"PF\n3 2\n1.1.1\n" + bytes(72), "got another header"),
        (b"PF\n3 2\n-1\n" + bytes(71), "expected 72 bytes for 3 x 2 texels, got 71"),
        (b"PF\n3 2\n-1\n" + bytes(76), "expected 72 bytes for 3 x 2 texels, got 4 more"),
        (b"PF\n99999 2\n-1\n" + bytes(72), "got 99999 x 2"),
    ],
)
def test_what_is_refused(tmp_path, data, came):
    with pytest.raises(DumpError) as caught:
        read(tmp_path, data)
    assert came in str(caught.value) and str(caught.value).startswith(f"{tmp_path / 'x.pfm'}: expected ")
