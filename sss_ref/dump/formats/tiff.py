"""TIFF of integers or floats, by way of tifffile and imagecodecs (the extra `validate`)."""

import logging
from pathlib import Path
from typing import Any

from sss_ref.dump.texels import StoredTexels, array_texels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

AXES = ("YX", "YXS", "SYX")  # rows and columns; S are the channels of a texel, side by side or in planes
BLACK_IS_ZERO, RGB = 1, 2  # photometric interpretations under which a number is what was written
TOP_LEFT = 1  # orientation
UNORM = {"uint8": "unorm8"}  # a picture's byte is a colour, not a count
COMPRESSIONS = {  # those that lose nothing; TIFF 6.0 and its supplements
    1: "none",
    5: "LZW",
    8: "deflate",
    32773: "PackBits",
    32946: "deflate",
    34925: "LZMA",
    50000: "Zstandard",
}
NONE, NO_PREDICTOR = 1, 1
_nowhere = logging.NullHandler()  # what tifffile logs is not printed, unless the user has handlers of their own
REMEDY = "pip install 'sss_ref[validate]'"


def read(path: Path) -> tuple[StoredTexels, ...]:
    """The pages of a TIFF file; they are called 0, 1 and so on. Smaller copies of a page are none. Raises DumpError."""
    try:
        import tifffile
    except ImportError:
        expected = "the package tifffile, which reads TIFF"
        raise DumpError(told(str(path), expected, "none", REMEDY)) from None
    logging.getLogger("tifffile").addHandler(_nowhere)
    with tifffile.TiffFile(path) as file:
        pages: list[Any] = list(file.pages)
        return tuple(_page(path, page, index) for index, page in enumerate(pages) if not page.is_reduced)


def _page(path: Path, page: Any, index: int) -> StoredTexels:
    _check_compression(path, page)
    orientation = page.tags.get("Orientation")
    form = page.axes, int(page.photometric), TOP_LEFT if orientation is None else int(orientation.value)
    if form[0] not in AXES or form[1] not in (BLACK_IS_ZERO, RGB) or form[2] != TOP_LEFT:
        came = f"axes {form[0]}, photometric {form[1]}, orientation {form[2]}"
        raise DumpError(told(str(path), "grey or RGB rows from the top left", came, "convert the picture"))
    check_size(path, page.imagewidth, page.imagelength, page.dtype.itemsize * page.samplesperpixel)
    pixels = page.asarray()
    texels = array_texels(path, pixels.transpose(1, 2, 0) if form[0] == "SYX" else pixels)
    return StoredTexels(texels.data, texels.channels, UNORM.get(texels.storage, texels.storage), str(index))


def _check_compression(path: Path, page: Any) -> None:
    """Raise DumpError for a compression that loses bits or is not known, or that needs a package which is not there."""
    compression, predictor = int(page.compression), int(page.predictor)
    if compression not in COMPRESSIONS:
        expected = f"a compression that loses nothing ({', '.join(dict.fromkeys(COMPRESSIONS.values()))})"
        name = getattr(page.compression, "name", str(compression))
        raise DumpError(told(str(path), expected, f"{name} ({compression})", "save it with one of these"))
    if (compression, predictor) != (NONE, NO_PREDICTOR):
        try:
            import imagecodecs  # noqa: F401
        except ImportError:
            used = f"the compression {COMPRESSIONS[compression]} with predictor {predictor}"
            expected = f"the package imagecodecs, which reads {used}"
            raise DumpError(told(str(path), expected, "none", f"{REMEDY}, or save it uncompressed")) from None
