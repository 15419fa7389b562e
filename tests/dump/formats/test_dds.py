"""DDS files are written here byte by byte, with the numbers of Microsoft's documentation, not with the reader's."""

import contextlib
import struct
import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sss_ref.dump.files import parts_of
from sss_ref.errors import DumpError

WIDTH, HEIGHT = 5, 3

# DXGI number -> struct code of a texel, channels, storage.
PLAIN = {
    2: ("4f", "RGBA", "float32"),
    3: ("4I", "RGBA", "uint32"),
    4: ("4i", "RGBA", "int32"),
    7: ("3I", "RGB", "uint32"),
    8: ("3i", "RGB", "int32"),
    12: ("4H", "RGBA", "uint16"),
    13: ("4h", "RGBA", "snorm16"),
    14: ("4h", "RGBA", "int16"),
    17: ("2I", "RG", "uint32"),
    18: ("2i", "RG", "int32"),
    30: ("4B", "RGBA", "uint8"),
    31: ("4b", "RGBA", "snorm8"),
    32: ("4b", "RGBA", "int8"),
    36: ("2H", "RG", "uint16"),
    37: ("2h", "RG", "snorm16"),
    38: ("2h", "RG", "int16"),
    50: ("2B", "RG", "uint8"),
    51: ("2b", "RG", "snorm8"),
    52: ("2b", "RG", "int8"),
    57: ("H", "R", "uint16"),
    58: ("h", "R", "snorm16"),
    59: ("h", "R", "int16"),
    63: ("b", "R", "snorm8"),
    64: ("b", "R", "int8"),
    65: ("B", "A", "unorm8"),
    88: ("4B", "BGRX", "unorm8"),
    93: ("4B", "BGRX", "srgb8"),
    6: ("3f", "RGB", "float32"),
    10: ("4e", "RGBA", "float16"),
    11: ("4H", "RGBA", "unorm16"),
    16: ("2f", "RG", "float32"),
    28: ("4B", "RGBA", "unorm8"),
    29: ("4B", "RGBA", "srgb8"),
    34: ("2e", "RG", "float16"),
    35: ("2H", "RG", "unorm16"),
    40: ("f", "R", "float32"),
    41: ("f", "R", "float32"),
    42: ("I", "R", "uint32"),
    43: ("i", "R", "int32"),
    49: ("2B", "RG", "unorm8"),
    54: ("e", "R", "float16"),
    55: ("H", "R", "unorm16"),
    56: ("H", "R", "unorm16"),
    61: ("B", "R", "unorm8"),
    62: ("B", "R", "uint8"),
    87: ("4B", "BGRA", "unorm8"),
    91: ("4B", "BGRA", "srgb8"),
}
OLD = {
    36: 11,
    110: 13,
    111: 54,
    112: 34,
    113: 10,
    114: 41,
    115: 16,
    116: 2,
}  # FourCC -> the DXGI number that means the same
MASKS = {  # bits, red, green, blue, alpha -> the DXGI number that means the same
    (8, 0xFF, 0, 0, 0): 61,
    (16, 0xFF, 0xFF00, 0, 0): 49,
    (16, 0xFFFF, 0, 0, 0): 56,
    (32, 0xFFFF, 0xFFFF0000, 0, 0): 35,
    (32, 0xFF, 0xFF00, 0xFF0000, 0xFF000000): 28,
    (32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000): 87,
}


def header(width, height, *, pitch=None, depth=None, fourcc=b"DX10", masks=(0,) * 5, caps2=0):
    """The 128 bytes that every DDS file begins with."""
    flags = 0x1007 | (0 if pitch is None else 0x8) | (0 if depth is None else 0x800000)
    pixel_format = struct.pack("<II4s5I", 32, 4 if fourcc else 0x41, fourcc or bytes(4), *masks)
    start = struct.pack("<4s7I44x", b"DDS ", 124, flags, height, width, pitch or 0, depth or 0, 1)
    return start + pixel_format + struct.pack("<5I", 0x1000, caps2, 0, 0, 0)


def extension(dxgi, dimension=3, misc=0, layers=1):
    return struct.pack("<5I", dxgi, dimension, misc, layers, 0)


def dds(dxgi, texels, width=WIDTH, height=HEIGHT, **words):
    return header(width, height, **words) + extension(dxgi) + texels


def read(tmp_path, data):
    (tmp_path / "x.dds").write_bytes(data)
    return parts_of(tmp_path / "x.dds")[0]


def refusal(tmp_path, data):
    with pytest.raises(DumpError) as caught:
        read(tmp_path, data)
    message = str(caught.value)
    assert message.startswith(f"{tmp_path / 'x.dds'}: expected ") and "\n" not in message
    return message


def random_texels(code, seed=1):
    """Arbitrary bits for all texels, and the values that they are, NaN patterns aside."""
    data = np.random.default_rng(seed).bytes(struct.calcsize("<" + code) * WIDTH * HEIGHT)
    return data, list(struct.iter_unpack("<" + code, data))


def assert_holds(texels, values):
    flat = texels.data.reshape(WIDTH * HEIGHT, -1)
    assert texels.data.shape[:2] == (HEIGHT, WIDTH)
    for got, expected in zip(flat.tolist(), values, strict=True):
        assert repr(got) == repr(list(expected))  # -0.0 and nan are told apart and found equal


@pytest.mark.parametrize("dxgi", PLAIN)
def test_every_plain_format(tmp_path, dxgi):
    code, channels, storage = PLAIN[dxgi]
    data, values = random_texels(code)
    texels = read(tmp_path, dds(dxgi, data))
    assert_holds(texels, values)
    assert ("".join(texels.channels), texels.storage) == (channels, storage)


@pytest.mark.parametrize("fourcc", OLD)
def test_float_formats_of_old_files(tmp_path, fourcc):
    code, channels, storage = PLAIN[OLD[fourcc]]
    data, values = random_texels(code)
    texels = read(tmp_path, header(WIDTH, HEIGHT, fourcc=struct.pack("<I", fourcc)) + data)
    assert_holds(texels, values)
    assert ("".join(texels.channels), texels.storage) == (channels, storage)


@pytest.mark.parametrize(
    ("flags", "masks", "code", "channels", "storage"),
    [
        (0x20000, (8, 0xFF, 0, 0, 0), "B", "R", "unorm8"),  # luminance
        (0x20000, (8, 0xFF, 0xFF, 0xFF, 0), "B", "R", "unorm8"),  # as some writers have it
        (0x20000, (16, 0xFFFF, 0, 0, 0), "H", "R", "unorm16"),
        (0x20001, (16, 0xFF, 0, 0, 0xFF00), "2B", "RA", "unorm8"),
        (0x2, (8, 0, 0, 0, 0xFF), "B", "A", "unorm8"),  # alpha alone
        (0x40, (24, 0xFF0000, 0xFF00, 0xFF, 0), "3B", "BGR", "unorm8"),
        (0x40, (24, 0xFF, 0xFF00, 0xFF0000, 0), "3B", "RGB", "unorm8"),
        (0x40, (32, 0xFF0000, 0xFF00, 0xFF, 0), "4B", "BGRX", "unorm8"),
        (0x40, (32, 0xFF, 0xFF00, 0xFF0000, 0), "4B", "RGBX", "unorm8"),
        (0x80000, (16, 0xFF, 0xFF00, 0, 0), "2b", "RG", "snorm8"),  # bump maps: V8U8, V16U16, Q8W8V8U8
        (0x80000, (32, 0xFFFF, 0xFFFF0000, 0, 0), "2h", "RG", "snorm16"),
        (0x80000, (32, 0xFF, 0xFF00, 0xFF0000, 0xFF000000), "4b", "RGBA", "snorm8"),
    ],
)
def test_old_headers_by_what_their_masks_are_of(tmp_path, flags, masks, code, channels, storage):
    data, values = random_texels(code)
    old = bytearray(header(WIDTH, HEIGHT, fourcc=None, masks=masks))
    old[80:84] = struct.pack("<I", flags)
    texels = read(tmp_path, bytes(old) + data)
    assert_holds(texels, values)
    assert ("".join(texels.channels), texels.storage) == (channels, storage)


@pytest.mark.parametrize("masks", MASKS)
def test_unorm_formats_by_masks(tmp_path, masks):
    code, channels, storage = PLAIN[MASKS[masks]]
    data, values = random_texels(code)
    texels = read(tmp_path, header(WIDTH, HEIGHT, fourcc=None, masks=masks) + data)
    assert_holds(texels, values)
    assert ("".join(texels.channels), texels.storage) == (channels, storage)


def test_ten_bits_and_two(tmp_path):
    codes = [(0, 1023, 512, 3), (1, 2, 3, 1), (1022, 341, 682, 2)] * 5
    data = b"".join(struct.pack("<I", r | g << 10 | b << 20 | a << 30) for r, g, b, a in codes)
    texels = read(tmp_path, dds(24, data))
    third = np.float32(1) / np.float32(3)
    assert texels.data[0, 0].tolist() == [0, 1, np.float32(512) / np.float32(1023), 1]
    assert texels.data[0, 1].tolist() == [*(np.float32(n) / np.float32(1023) for n in (1, 2, 3)), third]
    assert texels.data[0, 2].tolist() == [
        np.float32(1022) / np.float32(1023),
        third,
        np.float32(2 / 3),
        np.float32(2 / 3),
    ]
    assert texels.data.dtype == np.float32 and texels.storage == "rgb10a2"


def test_eleven_eleven_ten(tmp_path):
    # 1.5 is exponent 15 and half of the fraction: 0b01111_100000 in 11 bits, 0b01111_10000 in 10.
    word = 0b01111_100000 | 0b11111_000000 << 11 | 0b00000_00001 << 22
    texels = read(tmp_path, dds(26, struct.pack("<I", word) * (WIDTH * HEIGHT)))
    assert texels.data[2, 4].tolist() == [1.5, np.inf, 2.0**-19]
    assert texels.storage == "r11g11b10f" and "".join(texels.channels) == "RGB"


def test_nine_bits_each_and_one_exponent(tmp_path):
    # The value is n * 2^(e - 24): 256 at e = 16 is 1, 511 at e = 31 the largest, 1 at e = 0 the least.
    words = [256 | 128 << 9 | 1 << 18 | 16 << 27, 511 | 31 << 27, 1]
    texels = read(tmp_path, dds(67, b"".join(struct.pack("<I", word) for word in words) * 5))
    flat = texels.data.reshape(15, 3)
    assert flat[:3].tolist() == [[1, 0.5, 2.0**-8], [511 * 2.0**7, 0, 0], [2.0**-24, 0, 0]]
    assert texels.storage == "rgb9e5" and texels.data.dtype == np.float32


@pytest.mark.parametrize("dxgi", [21, 46])
def test_depth_beside_bits_without_type(tmp_path, dxgi):
    data = struct.pack("<fI", 0.25, 7) if dxgi == 21 else struct.pack("<I", 0xFF800000)
    texels = read(tmp_path, dds(dxgi, data * (WIDTH * HEIGHT)))
    expected = np.float32(0.25) if dxgi == 21 else np.float32(0x800000) / np.float32(0xFFFFFF)
    assert (texels.data == expected).all() and texels.channels == ("R",)


def test_depth_beside_stencil(tmp_path):
    codes = [0, 0xFFFFFF, 0x800000, 1, 0xABCDEF] * 3
    data = b"".join(struct.pack("<I", code | 0xA5000000) for code in codes)
    texels = read(tmp_path, dds(45, data))
    assert texels.data[..., 0].reshape(-1).tolist() == [np.float32(c / 0xFFFFFF).item() for c in codes]
    data = b"".join(struct.pack("<fI", code / 7, 0xDEADBEEF) for code in range(15))
    texels = read(tmp_path, dds(20, data))
    assert texels.data[..., 0].reshape(-1).tolist() == [np.float32(code / 7).item() for code in range(15)]


def test_rows_may_be_further_apart(tmp_path):
    data, values = random_texels("f")
    rows = [data[at : at + 4 * WIDTH] for at in range(0, len(data), 4 * WIDTH)]
    padded = b"padding.".join(rows)
    assert_holds(read(tmp_path, dds(41, padded, pitch=4 * WIDTH + 8)), values)
    assert_holds(read(tmp_path, dds(41, data, pitch=4 * WIDTH)), values)
    assert_holds(read(tmp_path, dds(41, data, pitch=0)), values)  # said to be there, and not filled in
    assert "a pitch of 28" in refusal(tmp_path, dds(41, padded[:-1], pitch=4 * WIDTH + 8))
    assert "a pitch of 19" in refusal(tmp_path, dds(41, padded, pitch=4 * WIDTH - 1))
    assert f"a pitch of {2**32 - 1}" in refusal(tmp_path, dds(41, padded, pitch=2**32 - 1))


def test_what_no_flag_says_is_there_is_passed_over(tmp_path):
    """A linear size where a pitch would stand, a depth of 7, all other second capabilities and flags of a texture."""
    data, values = random_texels("f")
    for masks, following in ((None, extension(41, misc=0xFFFFFFFB) + data), ((0,) * 5, data)):
        first = bytearray(header(WIDTH, HEIGHT, fourcc=b"DX10" if masks is None else struct.pack("<I", 114)))
        struct.pack_into("<I", first, 8, 0x7F7FFFF7)  # of the header: all but pitch and depth
        struct.pack_into("<2I", first, 20, 4 * WIDTH * HEIGHT, 7)
        struct.pack_into("<I", first, 112, 0xFFDFFDFF)  # all but a cube map and a volume
        assert_holds(read(tmp_path, bytes(first) + following), values)


def test_a_depth_of_1_is_none(tmp_path):
    data, values = random_texels("f")
    assert_holds(read(tmp_path, dds(41, data, depth=1)), values)


def test_smaller_mips_after_the_first_are_passed_over(tmp_path):
    data, values = random_texels("f")
    assert_holds(read(tmp_path, dds(41, data + bytes(4 * 3))), values)


@pytest.mark.parametrize(
    ("data", "came"),
    [
        (header(WIDTH, HEIGHT, caps2=0x200) + extension(41), "a cube map or volume"),
        (header(WIDTH, HEIGHT, caps2=0x200000) + extension(41), "a cube map or volume"),
        (header(WIDTH, HEIGHT, depth=2) + extension(41), "a cube map or volume"),
        (header(WIDTH, HEIGHT) + extension(41, dimension=4), "dimension 4"),
        (header(WIDTH, HEIGHT) + extension(41, misc=4), "flags 0x4"),
        (header(WIDTH, HEIGHT) + extension(41, layers=6), "6 layers"),
        (header(WIDTH, HEIGHT) + extension(98), "got DXGI_FORMAT_BC7_UNORM; convert the texture"),
        (header(WIDTH, HEIGHT) + extension(71), "got DXGI_FORMAT_BC1_UNORM; convert"),
        (header(WIDTH, HEIGHT) + extension(39), "got DXGI_FORMAT_R32_TYPELESS; view it with a type"),
        (header(WIDTH, HEIGHT) + extension(25), "got DXGI_FORMAT_R10G10B10A2_UINT; convert"),
        (header(WIDTH, HEIGHT) + extension(130), "got DXGI format 130; convert"),
        (header(WIDTH, HEIGHT, fourcc=None, masks=(32, 0x3FF, 0xFFC00, 0x3FF00000, 3 << 30)), "got 32 bits with masks"),
        (header(WIDTH, HEIGHT, fourcc=b"DXT5"), "got FourCC DXT5; export it with a DX10 header"),
        (header(WIDTH, HEIGHT, fourcc=None, masks=(16, 0xF800, 0x7E0, 0x1F, 0)), "16 bits with masks 0xf800, 0x7e0"),
        (header(WIDTH, HEIGHT) + extension(41) + bytes(59), "got 59"),
        (header(0, HEIGHT) + extension(41) + bytes(60), "0 x 3"),
        (header(100000, 100000) + extension(2), "100000 x 100000"),
        (header(16384, 16384) + extension(2), "got 0"),
        (header(16384, 16384)[:100], "100 bytes"),
        (header(WIDTH, HEIGHT) + extension(41)[:10], "138 bytes"),
        (b"", "0 bytes"),
        (bytes(200), "other data"),
    ],
)
def test_what_is_refused(tmp_path, data, came):
    tracemalloc.start()
    message = refusal(tmp_path, data)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert came in message
    assert peak < 2**20


@settings(max_examples=300, derandomize=True)
@given(
    changes=st.lists(
        st.tuples(st.integers(0, 36), st.sampled_from([0, 1, 2, 3, 24, 26, 2**31, 2**32 - 1])), max_size=3
    ),
    cut=st.integers(0, 300),
)
def test_damaged_headers_raise_nothing_else(tmp_path, changes, cut):
    words = list(struct.unpack("<37I", header(WIDTH, HEIGHT, pitch=20) + extension(41)))
    for at, word in changes:
        words[at] = word
    data = (struct.pack("<37I", *words) + random_texels("f")[0])[:cut]
    try:
        texels = read(tmp_path, data)
    except DumpError:
        return
    assert texels.data.shape[0] * texels.data.shape[1] <= len(data)


@settings(max_examples=200, derandomize=True)
@given(tail=st.binary(max_size=300))
def test_arbitrary_bytes_raise_nothing_else(tmp_path, tail):
    for data in (tail, b"DDS " + tail, header(2, 2) + tail):
        with contextlib.suppress(DumpError):
            read(tmp_path, data)
