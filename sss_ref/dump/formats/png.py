"""PNG of 8 and 16 bits a channel."""

from pathlib import Path

from sss_ref.dump.texels import StoredTexels, check_size
from sss_ref.errors import DumpError
from sss_ref.scene_file.png_codes import PngContent, PngFault

STORAGE = {8: "unorm8", 16: "unorm16"}  # by bit depth


def read(path: Path) -> tuple[StoredTexels]:
    """The texels of a PNG file as stored; what it says of colour spaces is not applied. Raises DumpError.

    Palettes, interlacing and fewer than 8 bits, which no dump has, are refused.
    """
    try:
        content = PngContent.of(path.read_bytes())
        header = content.header
        check_size(path, header.width, header.height, header.texel_bytes)
        return (StoredTexels(content.codes(), header.channels, STORAGE[header.depth]),)
    except PngFault as fault:
        raise DumpError(f"{path}: {fault}") from None
