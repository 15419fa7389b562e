import struct
import zlib

import imageio.v3 as imageio
import numpy as np
import pytest
from PIL import Image

from sss_ref.dump.files import parts_of
from sss_ref.errors import DumpError

CHANNELS = {0: 1, 4: 2, 2: 3, 6: 4}  # colour type -> count


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def png(width, height, depth, colour_type, lines, interlace=0):
    """A PNG file from filtered rows."""
    head = struct.pack(">IIBBBBB", width, height, depth, colour_type, 0, 0, interlace)
    packed = zlib.compress(lines)
    half = len(packed) // 2
    body = chunk(b"IDAT", packed[:half]) + chunk(b"IDAT", packed[half:])
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"tEXt", b"a\0b") + body + chunk(b"IEND", b"")


def filtered(rows, step):
    """The rows of bytes with filters 0 to 4 in turn, by the definition in the PNG specification."""
    height, width = rows.shape
    padded = np.zeros((height + 1, width + step), int)
    padded[1:, step:] = rows
    lines = []
    for row in range(height):
        a, b, c = padded[row + 1, :width], padded[row, step:], padded[row, :width]
        p = a + b - c
        nearest = np.where(abs(p - b) <= abs(p - c), b, c)
        paeth = np.where((abs(p - a) <= abs(p - b)) & (abs(p - a) <= abs(p - c)), a, nearest)
        expected = [0 * a, a, b, (a + b) // 2, paeth][row % 5]
        lines.append(bytes([row % 5]) + ((rows[row] - expected) % 256).astype(np.uint8).tobytes())
    return b"".join(lines)


def read(tmp_path, data):
    (tmp_path / "x.png").write_bytes(data)
    return parts_of(tmp_path / "x.png")[0]


@pytest.mark.parametrize("depth", [8, 16])
@pytest.mark.parametrize("colour_type", CHANNELS)
def test_every_kind_with_every_filter(tmp_path, depth, colour_type):
    count = CHANNELS[colour_type]
    texels = np.random.default_rng(depth + count).integers(0, 2**depth, (11, 6, count), f"u{depth // 8}")
    texels[3:5] //= 200  # nearly equal neighbours, so that ties are met
    rows = np.frombuffer(texels.astype(texels.dtype.newbyteorder(">")).tobytes(), np.uint8).reshape(11, -1)
    found = read(tmp_path, png(6, 11, depth, colour_type, filtered(rows, count * depth // 8)))
    assert np.array_equal(found.data, texels) and found.data.dtype == texels.dtype
    assert found.storage == f"unorm{depth}"
    assert found.channels == {1: ("R",), 2: ("R", "A"), 3: ("R", "G", "B"), 4: ("R", "G", "B", "A")}[count]


@pytest.mark.parametrize("mode", ["L", "LA", "RGB", "RGBA", "I;16"])
def test_files_of_another_writer(tmp_path, mode):
    generator = np.random.default_rng(1)
    kind = np.uint16 if mode == "I;16" else np.uint8
    smooth = np.cumsum(generator.integers(0, 3, (40, 30, max(1, len(mode) % 4 or 4))), axis=1).astype(kind)
    count = {"L": 1, "LA": 2, "RGB": 3, "RGBA": 4, "I;16": 1}[mode]
    texels = smooth[..., :1].repeat(count, axis=2) + np.arange(count, dtype=kind)
    Image.fromarray(texels[..., 0] if count == 1 else texels).save(tmp_path / "x.png")
    found = parts_of(tmp_path / "x.png")[0]
    assert np.array_equal(found.data, texels) and found.data.dtype == kind


def test_the_reason_for_a_reader_of_our_own(tmp_path):
    """imageio, by way of Pillow, gives 8 bits of 16; if that ends, this reader may end too."""
    texels = np.full((2, 2, 3), 0x1234, ">u2")
    assert (read(tmp_path, png(2, 2, 16, 2, filtered(texels.view(np.uint8).reshape(2, -1), 6))).data == 0x1234).all()
    assert imageio.imread(tmp_path / "x.png").dtype == np.uint8


GOOD = png(2, 2, 8, 0, b"\0ab\0cd")


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "expected a PNG file"),
        (GOOD[:40], "expected whole chunks"),
        (GOOD[:-12], "expected whole chunks"),
        (GOOD.replace(b"a\0b", b"a\0c"), "expected whole chunks"),
        (GOOD[:8] + chunk(b"IDAT", b"") + GOOD[8:], "expected a header first"),
        (png(2, 2, 8, 3, b"\0ab\0cd"), "colour type 3"),
        (png(2, 2, 4, 0, b"\0a\0b"), "4 bits"),
        (png(2, 2, 8, 0, b"\0ab\0cd", interlace=1), "interlace 1"),
        (png(2, 3, 8, 0, b"\0ab\0cd"), "expected 9 bytes, got 6"),
        (png(2, 2, 8, 0, b"\0ab\5cd"), "got 5"),
        (png(20000, 2, 8, 0, b""), "got 20000 x 2"),
        (png(16384, 16384, 16, 6, b""), "expected 2147500032 bytes, got 0"),
        (
            GOOD[:8] + chunk(b"IHDR", GOOD[16:29]) + chunk(b"IDAT", b"???") + chunk(b"IEND", b""),
            "expected a whole PNG file, got one that is damaged",
        ),
    ],
)
def test_what_is_refused(tmp_path, data, message):
    with pytest.raises(DumpError) as caught:
        read(tmp_path, data)
    assert message in str(caught.value) and str(caught.value).startswith(f"{tmp_path / 'x.png'}: expected ")
    assert "\n" not in str(caught.value)
