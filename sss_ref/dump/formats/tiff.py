"""TIFF of integers or floats, by way of tifffile (the extra `validate`)."""

from pathlib import Path
from typing import Any

from sss_ref.dump.texels import StoredTexels, array_texels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

AXES = ("YX", "YXS", "SYX")  # rows and columns; S are the channels of a texel, side by side or in planes
BLACK_IS_ZERO, RGB = 1, 2  # photometric interpretations under which a number is what was written
TOP_LEFT = 1  # orientation
UNORM = {"uint8": "unorm8"}  # a picture's byte is a colour, not a count


def read(path: Path) -> tuple[StoredTexels, ...]:
    """The pages of a TIFF file; they are called 0, 1 and so on. Raises DumpError."""
    try:
        import tifffile
    except ImportError:
        expected, remedy = "the package tifffile, which reads TIFF", "pip install 'sss_ref[validate]'"
        raise DumpError(told(str(path), expected, "none", remedy)) from None
    with tifffile.TiffFile(path) as file:
        return tuple(_page(path, page, index) for index, page in enumerate(file.pages))


def _page(path: Path, page: Any, index: int) -> StoredTexels:
    orientation = page.tags.get("Orientation")
    form = page.axes, int(page.photometric), TOP_LEFT if orientation is None else int(orientation.value)
    if form[0] not in AXES or form[1] not in (BLACK_IS_ZERO, RGB) or form[2] != TOP_LEFT:
        came = f"axes {form[0]}, photometric {form[1]}, orientation {form[2]}"
        raise DumpError(told(str(path), "grey or RGB rows from the top left", came, "convert the picture"))
    check_size(path, page.imagewidth, page.imagelength, page.dtype.itemsize * page.samplesperpixel)
    pixels = page.asarray()
    texels = array_texels(path, pixels.transpose(1, 2, 0) if form[0] == "SYX" else pixels)
    return StoredTexels(texels.data, texels.channels, UNORM.get(texels.storage, texels.storage), str(index))
