"""Colour textures: the decoding table, the order of rows, and what is refused."""

import gmpy2
import numpy as np
import pytest
from PIL import Image

from sss_ref.errors import SceneError
from sss_ref.scene_file import color_texture as textures
from sss_ref.scene_file.color_texture import load_texture, srgb_decoded


def test_every_code_is_correctly_rounded():
    with gmpy2.context(precision=300):
        encoded = [gmpy2.mpfr(code) / 255 for code in range(256)]
        low = gmpy2.mpfr("0.04045")
        offset, scale = gmpy2.mpfr("0.055"), gmpy2.mpfr("1.055")
        linear = [c / gmpy2.mpfr("12.92") if c <= low else ((c + offset) / scale) ** gmpy2.mpfr("2.4") for c in encoded]
    expected = [float(gmpy2.mpfr(value, 24)) for value in linear]
    assert srgb_decoded().dtype == np.float32 and srgb_decoded().tolist() == expected
    assert (srgb_decoded()[0], srgb_decoded()[255]) == (0, 1)


OTHER = "expected a PNG or JPEG picture, got another kind of file; export it again"
BROKEN = "expected a PNG or JPEG picture, got one that is broken or breaks off; export it again"
PIXELS = np.arange(2 * 3 * 3, dtype=np.uint8).reshape(2, 3, 3) * 14


def test_the_lowest_row_comes_first(tmp_path):
    Image.fromarray(PIXELS).save(tmp_path / "a.png")
    texels = load_texture(tmp_path / "a.png")
    assert texels.dtype == np.float32 and texels.flags.c_contiguous
    assert np.array_equal(texels, srgb_decoded()[PIXELS[::-1]])


@pytest.mark.parametrize("mode", ["L", "LA", "P", "RGBA", "1"])
def test_other_modes_become_rgb(tmp_path, mode):
    picture = Image.fromarray(PIXELS).convert(mode)
    picture.save(tmp_path / "a.png")
    texels = load_texture(tmp_path / "a.png")
    assert np.array_equal(texels, srgb_decoded()[np.asarray(picture.convert("RGB"))[::-1]])


def test_jpeg(tmp_path):
    Image.new("RGB", (5, 4), (255, 255, 255)).save(tmp_path / "a.jpg")
    assert np.array_equal(load_texture(tmp_path / "a.jpg"), np.ones((4, 5, 3)))


def refusal(path):
    with pytest.raises(SceneError) as error:
        load_texture(path)
    return str(error.value)


def test_too_large(tmp_path, monkeypatch):
    Image.fromarray(255 - PIXELS).save(tmp_path / "a.png")  # one that was not read before
    monkeypatch.setattr(textures, "LARGEST_SIZE", 2)
    assert refusal(tmp_path / "a.png") == "expected at most 2 texels a side, got 3 x 2; scale it down"


def test_deep_or_printed_colours(tmp_path):
    eight = "expected grey or RGB of 8 bits a channel, got {}; convert the picture"
    Image.fromarray(np.zeros((2, 2), np.uint16)).save(tmp_path / "a.png")
    assert refusal(tmp_path / "a.png") == eight.format("16 bits")
    Image.new("CMYK", (2, 2)).save(tmp_path / "b.jpg")
    assert refusal(tmp_path / "b.jpg") == eight.format("CMYK")


def test_rgb_of_16_bits_is_not_cut_to_8(tmp_path):
    import struct
    import zlib

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", 1, 1, 16, 2, 0, 0, 0)
    parts = (b"IHDR", head), (b"IDAT", zlib.compress(b"\0" + bytes(6))), (b"IEND", b"")
    (tmp_path / "a.png").write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts))
    assert refusal(tmp_path / "a.png").startswith("expected grey or RGB of 8 bits a channel, got 16 bits")


@pytest.mark.parametrize("content", [b"", b"no picture", b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff\xe0"])
def test_no_picture(tmp_path, content):
    """What Pillow says of it, which names Python objects, is not passed on."""
    (tmp_path / "a.png").write_bytes(content)
    assert refusal(tmp_path / "a.png") in (OTHER, BROKEN)


def test_other_formats_are_not_tried(tmp_path):
    Image.fromarray(PIXELS).save(tmp_path / "a.bmp")
    (tmp_path / "a.bmp").rename(tmp_path / "a.png")
    assert refusal(tmp_path / "a.png") == OTHER


def test_a_cut_off_file(tmp_path):
    Image.effect_noise((64, 64), 90).save(tmp_path / "a.png")
    data = (tmp_path / "a.png").read_bytes()
    (tmp_path / "a.png").write_bytes(data[: len(data) // 2])
    assert refusal(tmp_path / "a.png") == BROKEN


def test_a_picture_that_unpacks_to_very_much(tmp_path, monkeypatch):
    Image.fromarray(PIXELS[:, ::-1]).save(tmp_path / "a.png")  # of its own: what is read once is kept
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 2)
    expected = "expected a PNG or JPEG picture, got one of more than 4 texels; export it again"
    assert refusal(tmp_path / "a.png") == expected
