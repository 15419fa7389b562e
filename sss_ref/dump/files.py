"""Which reader a file has, by its suffix."""

from pathlib import Path

from sss_ref.dump.formats import dds, exr, npy, png, raw, tiff
from sss_ref.dump.texels import StoredTexels
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

READERS = {
    ".npy": npy.read,
    ".exr": exr.read,
    ".png": png.read,
    ".tif": tiff.read,
    ".tiff": tiff.read,
    ".dds": dds.read,
}
RAW = (".raw", ".bin")
SUFFIXES = (*READERS, *RAW)
BOTTOM_FIRST = (".npy",)  # NPY is a copy of memory, as our own is; pictures begin at the top


def parts_of(path: Path, layout: raw.RawLayout | None = None) -> tuple[StoredTexels, ...]:
    """The surfaces of a file of any known format. Raises DumpError, whatever is wrong with it.

    layout: of a raw file.
    """
    try:
        if layout is not None:
            return raw.read(path, layout)
        return READERS[path.suffix.lower()](path)
    except DumpError:
        raise
    except OSError as error:
        raise DumpError(told(str(path), "a file", error.strerror or str(error), "check the path")) from None
    except Exception as error:  # whatever broken data makes a library raise
        reason = f"{type(error).__name__}: {error}".splitlines()[0]
        raise DumpError(told(str(path), "a whole file of its format", reason, "dump the buffer again")) from None
