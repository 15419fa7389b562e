"""The texel formats of DDS files, by DXGI's numbers, by old FourCC numbers, and by old channel masks."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sss_ref.dump import packed


@dataclass(frozen=True)
class TexelFormat:
    """How a texel is stored.

    element: NumPy's type, little-endian. channels: one letter each, in the order of the file. storage: see `encoding`.
    unpack: for formats with all channels in one element, what takes them apart.
    """

    name: str
    element: str
    channels: str
    storage: str
    unpack: Callable[[np.ndarray], np.ndarray] | None = None

    @property
    def count(self) -> int:
        """Elements of a texel."""
        return 1 if self.unpack else len(self.channels)

    @property
    def texel_bytes(self) -> int:
        """Bytes of a texel."""
        return self.count * np.dtype(self.element).itemsize


def _plain(bits: int, channels: str, kind: str) -> TexelFormat:
    """A format whose channels all have the same bits, by DXGI's word for their kind."""
    element = f"<{ELEMENT_KINDS[kind]}{bits // 8}"
    storage = f"{STORAGE_KINDS[kind]}{bits}"
    return TexelFormat("".join(f"{letter}{bits}" for letter in channels) + f"_{kind}", element, channels, storage)


ELEMENT_KINDS = {"FLOAT": "f", "UNORM": "u", "SNORM": "i", "UINT": "u", "SINT": "i"}
STORAGE_KINDS = {"FLOAT": "float", "UNORM": "unorm", "SNORM": "snorm", "UINT": "uint", "SINT": "int"}

DXGI = {
    **{number: _plain(32, "RGBA", kind) for number, kind in ((2, "FLOAT"), (3, "UINT"), (4, "SINT"))},
    **{number: _plain(32, "RGB", kind) for number, kind in ((6, "FLOAT"), (7, "UINT"), (8, "SINT"))},
    **dict(enumerate((_plain(16, "RGBA", kind) for kind in ("FLOAT", "UNORM", "UINT", "SNORM", "SINT")), 10)),
    **{number: _plain(32, "RG", kind) for number, kind in ((16, "FLOAT"), (17, "UINT"), (18, "SINT"))},
    20: TexelFormat("D32_FLOAT_S8X24_UINT", "<u8", "R", "float32", packed.d32s8),
    21: TexelFormat("R32_FLOAT_X8X24_TYPELESS", "<u8", "R", "float32", packed.d32s8),
    24: TexelFormat("R10G10B10A2_UNORM", "<u4", "RGBA", "rgb10a2", packed.r10g10b10a2),
    26: TexelFormat("R11G11B10_FLOAT", "<u4", "RGB", "r11g11b10f", packed.r11g11b10),
    28: _plain(8, "RGBA", "UNORM"),
    29: TexelFormat("R8G8B8A8_UNORM_SRGB", "<u1", "RGBA", "srgb8"),
    30: _plain(8, "RGBA", "UINT"),
    31: _plain(8, "RGBA", "SNORM"),
    32: _plain(8, "RGBA", "SINT"),
    **dict(enumerate((_plain(16, "RG", kind) for kind in ("FLOAT", "UNORM", "UINT", "SNORM", "SINT")), 34)),
    40: TexelFormat("D32_FLOAT", "<f4", "R", "float32"),
    **{number: _plain(32, "R", kind) for number, kind in ((41, "FLOAT"), (42, "UINT"), (43, "SINT"))},
    45: TexelFormat("D24_UNORM_S8_UINT", "<u4", "R", "unorm24", packed.d24s8),
    46: TexelFormat("R24_UNORM_X8_TYPELESS", "<u4", "R", "unorm24", packed.d24s8),
    **dict(enumerate((_plain(8, "RG", kind) for kind in ("UNORM", "UINT", "SNORM", "SINT")), 49)),
    54: _plain(16, "R", "FLOAT"),
    55: TexelFormat("D16_UNORM", "<u2", "R", "unorm16"),
    **dict(enumerate((_plain(16, "R", kind) for kind in ("UNORM", "UINT", "SNORM", "SINT")), 56)),
    **dict(enumerate((_plain(8, "R", kind) for kind in ("UNORM", "UINT", "SNORM", "SINT")), 61)),
    65: TexelFormat("A8_UNORM", "<u1", "A", "unorm8"),
    67: TexelFormat("R9G9B9E5_SHAREDEXP", "<u4", "RGB", "rgb9e5", packed.r9g9b9e5),
    87: TexelFormat("B8G8R8A8_UNORM", "<u1", "BGRA", "unorm8"),
    88: TexelFormat("B8G8R8X8_UNORM", "<u1", "BGRX", "unorm8"),
    91: TexelFormat("B8G8R8A8_UNORM_SRGB", "<u1", "BGRA", "srgb8"),
    93: TexelFormat("B8G8R8X8_UNORM_SRGB", "<u1", "BGRX", "srgb8"),
}
B8G8R8 = TexelFormat("B8G8R8", "<u1", "BGR", "unorm8")
R8G8B8 = TexelFormat("R8G8B8", "<u1", "RGB", "unorm8")
R8G8B8X8 = TexelFormat("R8G8B8X8", "<u1", "RGBX", "unorm8")
GREY_ALPHA = TexelFormat("L8A8", "<u1", "RA", "unorm8")

# The numbers of Direct3D 9's formats: A16B16G16R16, Q16W16V16U16, and floats.
FOURCC = {
    36: DXGI[11],
    110: DXGI[13],
    111: DXGI[54],
    112: DXGI[34],
    113: DXGI[10],
    114: DXGI[41],
    115: DXGI[16],
    116: DXGI[2],
}
RGB, LUMINANCE, BUMP = 0x40, 0x20000, 0x80000  # of the pixel format's flags: what the masks are of; none: of alpha

# Bits of a texel, then the masks of red, green, blue and alpha: what small unorm formats are written as to this day.
# 10 + 10 + 10 + 2 bits are not among them: writers are known to swap its red and blue.
UNSIGNED: dict[tuple[int, ...], TexelFormat] = {
    (8, 0xFF, 0, 0, 0): DXGI[61],
    (8, 0, 0, 0, 0xFF): DXGI[65],
    (16, 0xFF, 0xFF00, 0, 0): DXGI[49],
    (16, 0xFF, 0, 0, 0xFF00): GREY_ALPHA,
    (16, 0xFFFF, 0, 0, 0): DXGI[56],
    (24, 0xFF0000, 0xFF00, 0xFF, 0): B8G8R8,
    (24, 0xFF, 0xFF00, 0xFF0000, 0): R8G8B8,
    (32, 0xFFFF, 0xFFFF0000, 0, 0): DXGI[35],
    (32, 0xFF, 0xFF00, 0xFF0000, 0xFF000000): DXGI[28],
    (32, 0xFF, 0xFF00, 0xFF0000, 0): R8G8B8X8,
    (32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000): DXGI[87],
    (32, 0xFF0000, 0xFF00, 0xFF, 0): DXGI[88],
}
SIGNED: dict[tuple[int, ...], TexelFormat] = {
    (16, 0xFF, 0xFF00, 0, 0): DXGI[51],
    (32, 0xFFFF, 0xFFFF0000, 0, 0): DXGI[37],
    (32, 0xFF, 0xFF00, 0xFF0000, 0xFF000000): DXGI[31],
}


def by_masks(flags: int, masks: tuple[int, ...]) -> TexelFormat | None:
    """The format of an old header: signed where its flags say that the masks are of a bump map; None if not known."""
    bits, *channels = masks
    if flags & BUMP:
        return SIGNED.get(masks)
    if flags & RGB:
        return UNSIGNED.get(masks)
    return UNSIGNED.get((bits, channels[0] if flags & LUMINANCE else 0, 0, 0, channels[3]))
