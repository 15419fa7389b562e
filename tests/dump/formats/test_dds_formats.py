"""The tables of texel formats, held to the names that Microsoft gives them: no file is read."""

import re

import numpy as np

from sss_ref.dump.formats.dds_formats import DXGI, FOURCC, by_masks
from sss_ref.dump.formats.dxgi_names import NAMES, dxgi_name

KINDS = {
    "FLOAT": ("f", "float"),
    "UNORM": ("u", "unorm"),
    "SNORM": ("i", "snorm"),
    "UINT": ("u", "uint"),
    "SINT": ("i", "int"),
}
UNUSUAL = {  # element, channels, storage, bytes of a texel
    20: ("<u8", "R", "float32", 8),
    21: ("<u8", "R", "float32", 8),
    24: ("<u4", "RGBA", "rgb10a2", 4),
    26: ("<u4", "RGB", "r11g11b10f", 4),
    29: ("<u1", "RGBA", "srgb8", 4),
    45: ("<u4", "R", "unorm24", 4),
    46: ("<u4", "R", "unorm24", 4),
    67: ("<u4", "RGB", "rgb9e5", 4),
    88: ("<u1", "BGRX", "unorm8", 4),
    91: ("<u1", "BGRA", "srgb8", 4),
    93: ("<u1", "BGRX", "srgb8", 4),
}
READ = [2, 3, 4, 6, 7, 8, *range(10, 15), 16, 17, 18, 20, 21, 24, 26, *range(28, 33), *range(34, 39), *range(40, 44)]
READ += [45, 46, *range(49, 53), *range(54, 60), *range(61, 66), 67, 87, 88, 91, 93]
OLD = {
    36: "R16G16B16A16_UNORM",
    110: "R16G16B16A16_SNORM",
    111: "R16_FLOAT",
    112: "R16G16_FLOAT",
    113: "R16G16B16A16_FLOAT",
    114: "R32_FLOAT",
    115: "R32G32_FLOAT",
    116: "R32G32B32A32_FLOAT",
}
RED, GREEN, BLUE, ALPHA = 0xFF, 0xFF00, 0xFF0000, 0xFF000000  # of a texel whose first byte is red
OF_COLOURS, OF_LUMINANCE, OF_BUMPS, OF_ALPHA = 0x40, 0x20000, 0x80000, 0x2
MASKED = {  # flags; bits and the masks of red, green, blue and alpha -> the format's name
    (OF_COLOURS, (8, RED, 0, 0, 0)): "R8_UNORM",
    (OF_COLOURS, (16, RED, GREEN, 0, 0)): "R8G8_UNORM",
    (OF_COLOURS, (16, 0xFFFF, 0, 0, 0)): "R16_UNORM",
    (OF_COLOURS, (24, BLUE, GREEN, RED, 0)): "B8G8R8",
    (OF_COLOURS, (24, RED, GREEN, BLUE, 0)): "R8G8B8",
    (OF_COLOURS, (32, 0xFFFF, 0xFFFF0000, 0, 0)): "R16G16_UNORM",
    (OF_COLOURS, (32, RED, GREEN, BLUE, ALPHA)): "R8G8B8A8_UNORM",
    (OF_COLOURS, (32, RED, GREEN, BLUE, 0)): "R8G8B8X8",
    (OF_COLOURS, (32, BLUE, GREEN, RED, ALPHA)): "B8G8R8A8_UNORM",
    (OF_COLOURS, (32, BLUE, GREEN, RED, 0)): "B8G8R8X8_UNORM",
    (OF_LUMINANCE, (8, RED, RED, RED, 0)): "R8_UNORM",
    (OF_LUMINANCE, (16, RED, 0, 0, GREEN)): "L8A8",
    (OF_ALPHA, (8, 0, 0, 0, RED)): "A8_UNORM",
    (OF_ALPHA, (8, RED, 0, 0, RED)): "A8_UNORM",
    (OF_BUMPS, (16, RED, GREEN, 0, 0)): "R8G8_SNORM",
    (OF_BUMPS, (32, 0xFFFF, 0xFFFF0000, 0, 0)): "R16G16_SNORM",
    (OF_BUMPS, (32, RED, GREEN, BLUE, ALPHA)): "R8G8B8A8_SNORM",
}


def test_every_number_has_the_name_that_microsoft_gives_it():
    assert list(DXGI) == READ
    assert {number: each.name for number, each in DXGI.items()} == {number: NAMES[number] for number in READ}
    assert (dxgi_name(28), dxgi_name(999)) == ("DXGI_FORMAT_R8G8B8A8_UNORM", "DXGI format 999")
    assert NAMES[115] == "B4G4R4A4_UNORM"  # the last one before the numbers have a gap


def test_a_format_is_stored_as_its_name_says():
    for number, each in DXGI.items():
        if number in UNUSUAL:
            expected = UNUSUAL[number]
        else:
            named, kind = re.fullmatch(r"(.+)_(\w+?)", each.name).groups()
            channels = dict(re.findall(r"([A-Z])(\d+)", named))
            (bits,) = {int(size) for size in channels.values()}
            letter, storage = KINDS[kind]
            shown = "R" if named.startswith("D") else "".join(channels)
            expected = f"<{letter}{bits // 8}", shown, f"{storage}{bits}", len(channels) * bits // 8
        assert (each.element, each.channels, each.storage, each.texel_bytes) == expected, each.name
        assert np.dtype(each.element).itemsize * each.count == each.texel_bytes


def test_old_numbers_are_those_of_direct3d_9():
    assert {number: each.name for number, each in FOURCC.items()} == OLD


def test_masks_tell_a_format_by_what_they_are_of():
    found = {(flags, masks): by_masks(flags, masks) for flags, masks in MASKED}
    assert {key: each and each.name for key, each in found.items()} == MASKED
    small = {"B8G8R8": "BGR", "R8G8B8": "RGB", "R8G8B8X8": "RGBX", "L8A8": "RA"}
    assert {each.name: each.channels for each in found.values() if each.name in small} == small
    assert {(each.element, each.storage) for each in found.values() if each.name in small} == {("<u1", "unorm8")}
    others = 0xFFFFFFFF - (OF_COLOURS | OF_LUMINANCE | OF_BUMPS)  # such as that the pixels have an alpha
    assert found == {(flags, masks): by_masks(flags | others, masks) for flags, masks in MASKED}
    for flags, masks in (
        (OF_COLOURS, (16, 0xF800, 0x7E0, 0x1F, 0)),
        (OF_BUMPS, (8, RED, 0, 0, 0)),
        (OF_ALPHA, (9, 0, 0, 0, 0)),
    ):
        assert by_masks(flags, masks) is None
