"""NumPy's own format."""

from pathlib import Path

from sss_ref.dump.texels import StoredTexels, array_texels
from sss_ref.errors import DumpError
from sss_ref.errors.array_file import mapped_array
from sss_ref.errors.wording import told

OBJECTS = b"'descr': '|O'"  # in the header, which is text
LONGEST_HEADER = 10000  # bytes; NumPy reads none that are longer


def read(path: Path) -> tuple[StoredTexels]:
    """The array of an NPY file. It is mapped first, which fails without taking memory if the file is too short."""
    with path.open("rb") as file:
        if OBJECTS in file.read(LONGEST_HEADER).partition(b"\n")[0]:
            remedy = "convert the array to float32 before saving it"
            raise DumpError(told(str(path), "numbers", "Python objects", remedy))
    array = mapped_array(path)
    if array is None:
        raise DumpError(told(str(path), "one array in NPY format", "an archive", "save each buffer with numpy.save"))
    return (array_texels(path, array),)
