"""Which reader a file has, by its suffix."""

from pathlib import Path
from stat import S_ISREG

from sss_ref.dump.formats import dds, exr, npy, pfm, png, raw, tiff
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
    ".pfm": pfm.read,
}
RAW = (".raw", ".bin")
SUFFIXES = (*READERS, *RAW)
BOTTOM_FIRST = (".npy", ".pfm")  # NPY is a copy of memory, as our own is, PFM says so; other pictures begin at the top


def parts_of(path: Path, layout: raw.RawLayout | None = None) -> tuple[StoredTexels, ...]:
    """The surfaces of a file of any known format. Raises DumpError, whatever is wrong with it.

    layout: of a raw file.
    """
    try:
        if not S_ISREG(path.stat().st_mode):
            raise DumpError(told(str(path), "a regular file", "another kind", "copy its content to one"))
        if layout is not None:
            return raw.read(path, layout)
        return READERS[path.suffix.lower()](path)
    except DumpError:
        raise
    except OSError as error:
        raise DumpError(told(str(path), "a file", error.strerror or "a broken one", "check the path")) from None
    except MemoryError:
        raise DumpError(told(str(path), "a file that fits into memory", "a larger one", "dump less of it")) from None
    except Exception as error:  # whatever broken data makes a library raise; its words are not for our readers
        kind = path.suffix.removeprefix(".").upper()
        expected, came = f"a whole {kind} file", "one that is damaged or cut off, or of another format"
        raise DumpError(told(str(path), expected, came, "dump the buffer again")) from error
