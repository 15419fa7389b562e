import tracemalloc

import numpy as np
import pytest

from sss_ref.dump.files import parts_of
from sss_ref.errors import DumpError


@pytest.mark.parametrize("kind", ["<f4", ">f4", "<f2", "<i4", "<u4", "u1", "?"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_every_type(tmp_path, kind, order):
    array = np.asarray(np.random.default_rng(1).integers(0, 2, (3, 5, 2)), kind, order=order)
    np.save(tmp_path / "x.npy", array)
    (texels,) = parts_of(tmp_path / "x.npy")
    assert np.array_equal(texels.data, array) and texels.data.dtype.isnative and texels.data.dtype.kind != "b"


def header(shape, kind="<f4"):
    text = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\1\0" + len(text).to_bytes(2, "little") + text.encode()


DAMAGED = "expected a whole NPY file, got one that is damaged or cut off, or of another format; dump the buffer again"


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", DAMAGED),
        (b"x" * 200, DAMAGED),
        (header((100000, 100000)), DAMAGED),
        (header((2, 2)) + bytes(15), DAMAGED),
        (header((2, 2))[:60], DAMAGED),
        (header((2, 2)).replace(b"}", b" ") + bytes(16), DAMAGED),
        (header((2, 2), "|O") + bytes(16), "expected numbers, got Python objects"),
        (header((2, 2), "<f8") + bytes(32), "got float64"),
        (header((2, 2), "<i8") + bytes(32), "got int64"),
        (header((4,)) + bytes(16), "expected an array of height x width, perhaps x 1 to 4 channels, got 4; "),
        (header((2, 2, 5)) + bytes(80), "got 2 x 2 x 5"),
        (header((20000, 1)) + bytes(80000), "got 1 x 20000"),
        (b"PK\3\4" + bytes(30), "expected one array in NPY format, got an archive"),
    ],
)
def test_what_is_refused_without_taking_memory(tmp_path, data, message):
    (tmp_path / "x.npy").write_bytes(data)
    tracemalloc.start()
    with pytest.raises(DumpError) as caught:
        parts_of(tmp_path / "x.npy")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert message in str(caught.value) and str(caught.value).startswith(f"{tmp_path / 'x.npy'}: expected ")
    assert peak < 2**22


def test_an_archive_is_refused(tmp_path):
    np.savez(tmp_path / "x.npz", a=np.zeros((2, 2), np.float32))
    (tmp_path / "x.npz").rename(tmp_path / "x.npy")
    with pytest.raises(DumpError, match="expected one array in NPY format, got an archive"):
        parts_of(tmp_path / "x.npy")
