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


DXGI = {
    2: TexelFormat("R32G32B32A32_FLOAT", "<f4", "RGBA", "float32"),
    6: TexelFormat("R32G32B32_FLOAT", "<f4", "RGB", "float32"),
    10: TexelFormat("R16G16B16A16_FLOAT", "<f2", "RGBA", "float16"),
    11: TexelFormat("R16G16B16A16_UNORM", "<u2", "RGBA", "unorm16"),
    16: TexelFormat("R32G32_FLOAT", "<f4", "RG", "float32"),
    20: TexelFormat("D32_FLOAT_S8X24_UINT", "<u8", "R", "float32", packed.d32s8),
    24: TexelFormat("R10G10B10A2_UNORM", "<u4", "RGBA", "unorm10", packed.r10g10b10a2),
    26: TexelFormat("R11G11B10_FLOAT", "<u4", "RGB", "float11", packed.r11g11b10),
    28: TexelFormat("R8G8B8A8_UNORM", "<u1", "RGBA", "unorm8"),
    29: TexelFormat("R8G8B8A8_UNORM_SRGB", "<u1", "RGBA", "srgb8"),
    34: TexelFormat("R16G16_FLOAT", "<f2", "RG", "float16"),
    35: TexelFormat("R16G16_UNORM", "<u2", "RG", "unorm16"),
    40: TexelFormat("D32_FLOAT", "<f4", "R", "float32"),
    41: TexelFormat("R32_FLOAT", "<f4", "R", "float32"),
    42: TexelFormat("R32_UINT", "<u4", "R", "uint32"),
    43: TexelFormat("R32_SINT", "<i4", "R", "int32"),
    45: TexelFormat("D24_UNORM_S8_UINT", "<u4", "R", "unorm24", packed.d24s8),
    49: TexelFormat("R8G8_UNORM", "<u1", "RG", "unorm8"),
    54: TexelFormat("R16_FLOAT", "<f2", "R", "float16"),
    55: TexelFormat("D16_UNORM", "<u2", "R", "unorm16"),
    56: TexelFormat("R16_UNORM", "<u2", "R", "unorm16"),
    61: TexelFormat("R8_UNORM", "<u1", "R", "unorm8"),
    62: TexelFormat("R8_UINT", "<u1", "R", "uint8"),
    87: TexelFormat("B8G8R8A8_UNORM", "<u1", "BGRA", "unorm8"),
    91: TexelFormat("B8G8R8A8_UNORM_SRGB", "<u1", "BGRA", "srgb8"),
}
FOURCC = {111: DXGI[54], 112: DXGI[34], 113: DXGI[10], 114: DXGI[41], 115: DXGI[16], 116: DXGI[2]}  # Direct3D 9

# Bits of a texel, then the masks of red, green, blue and alpha: what small unorm formats are written as to this day.
MASKS: dict[tuple[int, ...], TexelFormat] = {
    (8, 0xFF, 0, 0, 0): DXGI[61],
    (16, 0xFF, 0xFF00, 0, 0): DXGI[49],
    (16, 0xFFFF, 0, 0, 0): DXGI[56],
    (32, 0xFFFF, 0xFFFF0000, 0, 0): DXGI[35],
    (32, 0xFF, 0xFF00, 0xFF0000, 0xFF000000): DXGI[28],
    (32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000): DXGI[87],
}
