"""PNG of 8 and 16 bits a channel, decoded here: Pillow, and imageio with it, cut 16-bit RGB down to 8 bits."""

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SssRefError

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: ("R",), 2: ("R", "G", "B"), 4: ("R", "A"), 6: ("R", "G", "B", "A")}  # by colour type; grey is red
DEPTHS = (8, 16)
AGAIN = "write the file again"

Codes = NDArray[np.uint8] | NDArray[np.uint16]


class PngFault(SssRefError):
    """What is wrong with the content of a PNG file: expected, got, remedy; the caller knows where it is."""

    def __init__(self, expected: str, came: str, remedy: str) -> None:
        super().__init__(f"expected {expected}, got {came}; {remedy}")


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
    def channels(self) -> tuple[str, ...]:
        """The channels of a texel."""
        return CHANNELS[self.colour_type]

    @property
    def texel_bytes(self) -> int:
        """Bytes of a texel, all channels together."""
        return len(self.channels) * self.depth // 8


@dataclass(frozen=True)
class PngContent:
    """A PNG file whose chunks are whole, its texels still compressed."""

    header: PngHeader
    compressed: bytes

    @classmethod
    def of(cls, data: bytes) -> "PngContent":
        """The content of a file. Raises PngFault, also for palettes, interlacing and fewer than 8 bits."""
        chunks = list(_chunks(data))
        return cls(_header(chunks), b"".join(content for kind, content in chunks if kind == b"IDAT"))

    def codes(self) -> Codes:
        """The codes as stored, uint8 or uint16 (H, W, C), top row first; what is said of colour spaces is not applied.

        Raises PngFault for fewer texels than the header declares; of more the rest is not looked at.
        """
        header = self.header
        data = np.ascontiguousarray(self._lines()[:, 1:]).view(f">u{header.depth // 8}")
        shape = header.height, header.width, len(header.channels)
        return data.reshape(shape).astype(data.dtype.newbyteorder("="))

    def _lines(self) -> NDArray[np.uint8]:
        """The rows, uint8 (H, 1 + row bytes), with the filters undone; never more bytes than the header declares."""
        from sss_ref.scene_file.png_filters import PAETH, unfilter

        shape = self.header.height, 1 + self.header.width * self.header.texel_bytes
        data = zlib.decompressobj().decompress(self.compressed, shape[0] * shape[1])
        if len(data) != shape[0] * shape[1]:
            raise PngFault(f"{shape[0] * shape[1]} bytes", str(len(data)), AGAIN)
        lines = np.frombuffer(data, np.uint8).reshape(shape).copy()
        if lines[:, 0].max() > PAETH:
            raise PngFault(f"filters from 0 to {PAETH}", str(lines[:, 0].max()), AGAIN)
        unfilter(lines, self.header.texel_bytes)
        return lines


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Type and content of every chunk up to IEND, each held against its checksum."""
    if not data.startswith(SIGNATURE):
        raise PngFault("a PNG file", "other data", "give it the suffix of its format")
    at, kind = len(SIGNATURE), b""
    while kind != b"IEND":
        size = int.from_bytes(data[at : at + 4], "big")
        kind, content, checksum = data[at + 4 : at + 8], data[at + 8 : at + 8 + size], data[at + 8 + size :][:4]
        if zlib.crc32(kind + content).to_bytes(4, "big") != checksum:
            raise PngFault("whole chunks", f"a damaged one at byte {at}", AGAIN)
        yield kind, content
        at += 12 + size


def _header(chunks: list[tuple[bytes, bytes]]) -> PngHeader:
    kind, content = chunks[0]
    if kind != b"IHDR" or len(content) != 13:
        raise PngFault("a header first", f"a chunk {kind!r}", AGAIN)
    header = PngHeader(*struct.unpack(">IIBBBBB", content))
    supported = header.depth in DEPTHS and header.colour_type in CHANNELS
    if not supported or header.compression or header.filtering or header.interlace:
        came = f"{header.depth} bits, colour type {header.colour_type}, interlace {header.interlace}"
        raise PngFault("grey or RGB of 8 or 16 bits, not interlaced", came, "convert the picture")
    return header
