"""DDS, as RenderDoc and other tools write it: one 2D surface of uncompressed texels, top row first.

Layout: Microsoft, "Programming Guide for DDS", DDS_HEADER and DDS_HEADER_DXT10; all numbers are 32 bits, little-endian.
"""

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np

from sss_ref.dump.formats.dds_formats import DXGI, FOURCC, TexelFormat, by_masks
from sss_ref.dump.formats.dxgi_names import dxgi_name
from sss_ref.dump.texels import StoredTexels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

MAGIC = int.from_bytes(b"DDS ", "little")
DX10 = int.from_bytes(b"DX10", "little")
HEADER_SIZE, PIXEL_FORMAT_SIZE = 124, 32  # what the header says of itself
HAS_PITCH, HAS_DEPTH = 0x8, 0x800000  # of its flags
HAS_FOURCC = 0x4  # of the pixel format's flags
CUBE_MAP, VOLUME = 0x200, 0x200000  # of its second capabilities
TEXTURE_2D, TEXTURE_CUBE = 3, 0x4  # of the extension's dimension and flags
KNOWN = "a FLOAT, UNORM, SNORM, UINT, SINT or depth format, R11G11B10, R10G10B10A2 or R9G9B9E5"
EXPORT_ONE = "export a single 2D texture"


@dataclass(frozen=True)
class DdsHeader:
    """What the words before the texels say; `size` is the bytes they take."""

    width: int
    height: int
    pitch: int  # bytes from row to row; 0 where the file does not give it
    format: TexelFormat
    size: int


def read(path: Path) -> tuple[StoredTexels]:
    """The first mip of a DDS file's only surface. Raises DumpError."""
    with path.open("rb") as file:
        header = _header(path, file)
        available = path.stat().st_size - header.size
        row_bytes = header.width * header.format.texel_bytes
        check_size(path, header.width, header.height, header.format.texel_bytes, available)
        pitch = header.pitch or row_bytes  # 0 is what writers give that do not fill the field
        gap_bytes = (pitch - row_bytes) * (header.height - 1)
        if not 0 <= gap_bytes <= available - row_bytes * header.height:
            expected = f"rows of {row_bytes} bytes, or further apart and all there"
            raise DumpError(told(str(path), expected, f"a pitch of {pitch}", "export it again"))
        data = file.read(row_bytes * header.height + gap_bytes)
    element = np.dtype(header.format.element)
    shape = header.height, header.width, header.format.count
    strides = pitch, header.format.texel_bytes, element.itemsize
    return (_unpacked(np.ndarray(shape, element, data, strides=strides), header.format),)


def _unpacked(stored: np.ndarray, texel: TexelFormat) -> StoredTexels:
    data = texel.unpack(stored[..., 0]) if texel.unpack else stored.astype(stored.dtype.newbyteorder("="))
    return StoredTexels(data, tuple(texel.channels), texel.storage)


def _header(path: Path, file: BinaryIO) -> DdsHeader:
    words = _words(path, file, 32)
    if (words[0], words[1], words[19]) != (MAGIC, HEADER_SIZE, PIXEL_FORMAT_SIZE):
        raise DumpError(told(str(path), "a DDS file", "other data", "give it the suffix of its format"))
    flags, height, width, pitch, depth = words[2:7]
    pixel_flags, fourcc, *masks = words[20:27]
    if words[28] & (CUBE_MAP | VOLUME) or (flags & HAS_DEPTH and depth > 1):
        raise DumpError(told(str(path), "one 2D surface", "a cube map or volume", EXPORT_ONE))
    is_extended = bool(pixel_flags & HAS_FOURCC) and fourcc == DX10
    if is_extended:
        texel = _extended_format(path, _words(path, file, 5))
    else:
        texel = _old_format(path, pixel_flags, fourcc, tuple(masks))
    return DdsHeader(width, height, pitch if flags & HAS_PITCH else 0, texel, 4 * (37 if is_extended else 32))


def _words(path: Path, file: BinaryIO, count: int) -> tuple[int, ...]:
    data = file.read(4 * count)
    if len(data) < 4 * count:
        raise DumpError(
            told(str(path), "a whole header", f"{file.tell()} bytes", "the file is cut off; export it again")
        )
    return struct.unpack(f"<{count}I", data)


def _extended_format(path: Path, words: tuple[int, ...]) -> TexelFormat:
    number, dimension, flags, array_size, _ = words
    if dimension != TEXTURE_2D or flags & TEXTURE_CUBE or array_size > 1:
        came = f"dimension {dimension}, flags {flags:#x}, {array_size} layers"
        raise DumpError(told(str(path), "one 2D surface", came, EXPORT_ONE))
    if number not in DXGI:
        name = dxgi_name(number)
        remedy = "view it with a type and export that" if "TYPELESS" in name else "convert the texture to one of these"
        raise DumpError(told(str(path), KNOWN, name, remedy))
    return DXGI[number]


def _old_format(path: Path, flags: int, fourcc: int, masks: tuple[int, ...]) -> TexelFormat:
    """The format of a file without extension: by FourCC, or by bit count and channel masks."""
    texel = FOURCC.get(fourcc) if flags & HAS_FOURCC else by_masks(flags, masks)
    if texel is None:
        bits, *channels = masks
        came = f"{bits} bits with masks {', '.join(map(hex, channels))}, flags {flags:#x}"
        if flags & HAS_FOURCC:
            letters = fourcc.to_bytes(4, "little")
            came = f"FourCC {letters.decode('ascii') if letters.isalnum() else fourcc}"
        raise DumpError(told(str(path), KNOWN, came, "export it with a DX10 header"))
    return texel
