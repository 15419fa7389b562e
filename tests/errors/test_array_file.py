"""Arrays in files of users: mapped, archives told apart, nothing left open."""

import gc

import numpy as np
import pytest

from sss_ref.errors.array_file import mapped_array

ARRAY = np.arange(6, dtype=">f4").reshape(2, 3)


def test_an_array_is_mapped_as_it_lies_there(tmp_path):
    np.save(tmp_path / "a.npy", ARRAY)
    found = mapped_array(tmp_path / "a.npy")
    assert isinstance(found, np.memmap) and (found.dtype, found.tobytes()) == (ARRAY.dtype, ARRAY.tobytes())


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("length", [None, 30], ids=["whole", "cut off"])
def test_an_archive_is_none_and_is_not_left_open(tmp_path, length):
    np.savez(tmp_path / "a.npz", a=ARRAY)
    path = tmp_path / "a.npy"
    path.write_bytes((tmp_path / "a.npz").read_bytes()[:length])
    assert mapped_array(path) is None
    gc.collect()


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("shape", ["(2, 2)", "(2147483647, 2147483647, 2147483647)"])
def test_a_shape_that_the_file_does_not_hold(tmp_path, shape):
    header = f"{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    (tmp_path / "a.npy").write_bytes(b"\x93NUMPY\1\0" + len(header).to_bytes(2, "little") + header.encode())
    with pytest.raises((ValueError, OverflowError)):
        mapped_array(tmp_path / "a.npy")
