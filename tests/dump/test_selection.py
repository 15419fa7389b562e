import numpy as np
import pytest
from PIL import Image

from sss_ref.dump.selection import Region, parsed_region, read_exclusion
from sss_ref.errors import DumpError


def test_region():
    assert parsed_region("1,2,3,4", 4, 6) == Region(1, 2, 3, 4)
    assert parsed_region(" 0, 0, 1, 1 ", 1, 1) == Region(0, 0, 1, 1)
    assert parsed_region("00000001,0,1,1", 4, 6) == Region(1, 0, 1, 1)
    buffer = np.arange(24).reshape(6, 4)
    assert buffer[Region(1, 2, 3, 4).slices].tolist() == [[4 * row + c for c in (1, 2, 3)] for row in (2, 3, 4, 5)]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "1,2,3",
        "1,2,3,4,5",
        "0,0,5,1",
        "0,0,1,7",
        "4,0,1,1",
        "0,0,0,1",
        "0,0,1,0",
        "-1,0,1,1",
        "a,0,1,1",
        "0,0,1.5,1",
        "999999999999999999999,0,1,1",
        "²,0,1,1",
        "000000001,0,1,1",
    ],
)
def test_no_region(text):
    with pytest.raises(DumpError) as caught:
        parsed_region(text, 4, 6)
    assert str(caught.value).startswith("region: expected X,Y,W,H within 4 x 6 pixels")
    assert f"got {text}; " in str(caught.value)


@pytest.mark.parametrize("mode", ["L", "RGB", "RGBA"])
def test_mask_as_picture(tmp_path, mode):
    marked = np.random.default_rng(1).random((5, 7)) < 0.5
    picture = Image.fromarray((marked * 255).astype(np.uint8)).convert(mode)
    picture.save(tmp_path / "mask.png")
    assert np.array_equal(read_exclusion(tmp_path / "mask.png", 7, 5), marked[::-1])


def test_any_colour_marks(tmp_path):
    colours = np.uint8([[[0, 0, 1], [1, 0, 0], [0, 0, 0]]])
    Image.fromarray(colours).save(tmp_path / "mask.png")
    assert read_exclusion(tmp_path / "mask.png", 3, 1).tolist() == [[True, True, False]]


@pytest.mark.parametrize("kind", ["?", "u1", "f4"])
def test_mask_as_array(tmp_path, kind):
    marked = np.random.default_rng(1).random((5, 7)) < 0.5
    np.save(tmp_path / "mask.npy", marked.astype(kind))
    found = read_exclusion(tmp_path / "mask.npy", 7, 5)
    assert np.array_equal(found, marked) and found.dtype == bool


def test_no_mask(tmp_path):
    np.save(tmp_path / "mask.npy", np.zeros((5, 7), bool))
    with pytest.raises(DumpError, match=r"mask\.npy: expected a mask of 5 x 7 pixels, got 7 x 5; "):
        read_exclusion(tmp_path / "mask.npy", 5, 7)
    with pytest.raises(DumpError, match=r"mask\.jpg: expected a mask as PNG or NPY file, got \.jpg; "):
        read_exclusion(tmp_path / "mask.jpg", 5, 7)
