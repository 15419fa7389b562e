"""Pictures of numbers: how a code becomes one, and the arrays that bundles have in their place."""

import imagecodecs
import numpy as np
import pytest
from PIL import Image

from sss_ref.errors import SceneError
from sss_ref.scene_file.color_texture import texture_size
from sss_ref.scene_file.linear_texture import load_linear

CODES = np.arange(2 * 3 * 3, dtype=np.uint8).reshape(2, 3, 3) * 15


def test_a_code_is_its_share_of_255_and_the_lowest_row_comes_first(tmp_path):
    Image.fromarray(CODES).save(tmp_path / "a.png")
    texels = load_linear(tmp_path / "a.png")
    assert texels.dtype == np.float32 and texels.flags.c_contiguous
    assert np.array_equal(texels, (CODES[::-1] / 255).astype(np.float32))
    assert (texels[1, 0, 0], texels[0, 2, 2]) == (0, 1)


def test_grey_becomes_rgb(tmp_path):
    Image.fromarray(CODES[..., 0]).save(tmp_path / "a.png")
    assert np.array_equal(load_linear(tmp_path / "a.png"), (CODES[::-1, :, :1].repeat(3, 2) / 255).astype(np.float32))


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_all_16_bits_of_a_png_that_libpng_wrote(tmp_path, count):
    codes = np.random.default_rng(count).integers(0, 2**16, (5, 4, count), np.uint16)
    codes[0, 0], codes[0, 1] = 0xFFFF, 0x0001
    data = imagecodecs.png_encode(codes[..., 0] if count == 1 else codes)
    (tmp_path / "a.png").write_bytes(data)
    assert np.array_equal(imagecodecs.png_decode(data).reshape(codes.shape), codes)
    texels = load_linear(tmp_path / "a.png")
    shown = codes[::-1, :, :3] if count > 2 else codes[::-1, :, :1].repeat(3, axis=2)
    assert texels.dtype == np.float32 and texels.flags.c_contiguous
    assert np.array_equal(texels, shown.astype(np.float32) / np.float32(65535))


def test_the_quotient_of_every_code_is_rounded_once(tmp_path):
    codes = np.arange(2**16, dtype=np.uint16).reshape(256, 256)
    (tmp_path / "a.png").write_bytes(imagecodecs.png_encode(codes))
    quotients = codes[::-1].astype(np.float32) / np.float32(65535)  # IEEE 754: one rounding
    assert np.array_equal(load_linear(tmp_path / "a.png")[..., 0], quotients)


def test_a_png_of_16_bits_that_cannot_be_read(tmp_path):
    data = imagecodecs.png_encode(np.zeros((2, 2, 3), np.uint16))
    (tmp_path / "a.png").write_bytes(data.replace(b"IEND", b"IENE"))
    with pytest.raises(
        SceneError, match=r"^expected whole chunks, got a damaged one at byte [0-9]+; write the file again"
    ):
        load_linear(tmp_path / "a.png")


def test_an_array_is_taken_as_it_is(tmp_path):
    texels = np.random.default_rng(1).random((4, 5, 3)).astype(np.float32)
    np.save(tmp_path / "a.npy", texels)
    assert np.array_equal(load_linear(tmp_path / "a.npy"), texels)
    assert texture_size(tmp_path / "a.npy") == (5, 4)


@pytest.mark.parametrize(
    ("array", "came"),
    [
        (np.zeros((4, 5, 3)), "float64 (4, 5, 3)"),
        (np.zeros((4, 5), np.float32), "float32 (4, 5)"),
        (np.zeros((0, 5, 3), np.float32), "float32 (0, 5, 3)"),
        (np.full((4, 5, 3), 1.5, np.float32), "other numbers"),
        (np.full((4, 5, 3), np.nan, np.float32), "other numbers"),
    ],
)
def test_other_arrays(tmp_path, array, came):
    np.save(tmp_path / "a.npy", array)
    with pytest.raises(SceneError) as error:
        load_linear(tmp_path / "a.npy")
    expected = "expected an NPY file of float32 (H, W, 3) from 0 to 1"
    assert str(error.value) == f"{expected}, got {came}; write the array again"


def test_a_broken_array(tmp_path):
    (tmp_path / "a.npy").write_bytes(b"text")
    with pytest.raises(SceneError, match="got one that cannot be read"):
        load_linear(tmp_path / "a.npy")
    assert texture_size(tmp_path / "a.npy") == (0, 0)
