"""PNG of 8 and 16 bits a channel, decoded here: Pillow, and imageio with it, cut 16-bit RGB down to 8 bits."""

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sss_ref.dump.texels import StoredTexels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: ("R",), 2: ("R", "G", "B"), 4: ("R", "A"), 6: ("R", "G", "B", "A")}  # by colour type; grey is red
STORAGE = {8: "unorm8", 16: "unorm16"}  # by bit depth


@dataclass(frozen=True)
class PngHeader:
    """IHDR, as it stands in the file."""

    width: int
    height: int
    depth: int
    colour_type: int
    compression: int
    filtering: int
    interlace: int

    @property
    def texel_bytes(self) -> int:
        """Bytes of a texel, all channels together."""
        return len(CHANNELS[self.colour_type]) * self.depth // 8


def read(path: Path) -> tuple[StoredTexels]:
    """The texels of a PNG file as stored; what it says of colour spaces is not applied. Raises DumpError.

    Palettes, interlacing and fewer than 8 bits, which no dump has, are refused.
    """
    chunks = list(_chunks(path, path.read_bytes()))
    header = _header(path, chunks)
    lines = _lines(path, header, b"".join(data for kind, data in chunks if kind == b"IDAT"))
    shape = header.height, header.width, len(CHANNELS[header.colour_type])
    data = np.ascontiguousarray(lines[:, 1:]).view(f">u{header.depth // 8}").reshape(shape)
    return (
        StoredTexels(data.astype(data.dtype.newbyteorder("=")), CHANNELS[header.colour_type], STORAGE[header.depth]),
    )


def _chunks(path: Path, data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Type and content of every chunk up to IEND, each held against its checksum."""
    if not data.startswith(SIGNATURE):
        raise DumpError(told(str(path), "a PNG file", "other data", "give it the suffix of its format"))
    at, kind = len(SIGNATURE), b""
    while kind != b"IEND":
        size = int.from_bytes(data[at : at + 4], "big")
        kind, content, checksum = data[at + 4 : at + 8], data[at + 8 : at + 8 + size], data[at + 8 + size :][:4]
        if zlib.crc32(kind + content).to_bytes(4, "big") != checksum:
            raise DumpError(told(str(path), "whole chunks", f"a damaged one at byte {at}", "dump the buffer again"))
        yield kind, content
        at += 12 + size


def _header(path: Path, chunks: list[tuple[bytes, bytes]]) -> PngHeader:
    kind, content = chunks[0]
    if kind != b"IHDR" or len(content) != 13:
        raise DumpError(told(str(path), "a header first", f"a chunk {kind!r}", "dump the buffer again"))
    header = PngHeader(*struct.unpack(">IIBBBBB", content))
    supported = header.depth in STORAGE and header.colour_type in CHANNELS
    if not supported or header.compression or header.filtering or header.interlace:
        came = f"{header.depth} bits, colour type {header.colour_type}, interlace {header.interlace}"
        raise DumpError(told(str(path), "grey or RGB of 8 or 16 bits, not interlaced", came, "convert the picture"))
    check_size(path, header.width, header.height, header.texel_bytes)
    return header


def _lines(path: Path, header: PngHeader, compressed: bytes) -> np.ndarray:
    """The rows, uint8 (H, 1 + row bytes), with the filters undone; never more bytes than the header declares."""
    from sss_ref.dump.formats.png_filters import PAETH, unfilter

    shape = header.height, 1 + header.width * header.texel_bytes
    data = zlib.decompressobj().decompress(compressed, shape[0] * shape[1])
    if len(data) != shape[0] * shape[1]:
        raise DumpError(told(str(path), f"{shape[0] * shape[1]} bytes", str(len(data)), "dump the buffer again"))
    lines = np.frombuffer(data, np.uint8).reshape(shape).copy()
    if lines[:, 0].max() > PAETH:
        raise DumpError(told(str(path), f"filters from 0 to {PAETH}", str(lines[:, 0].max()), "dump the buffer again"))
    unfilter(lines, header.texel_bytes)
    return lines
