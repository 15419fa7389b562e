import pickle

import numpy as np
import pytest
from numba import types
from numba.core.ccallback import CFunc

from sss_ref.cache.address_files import AddressFiles
from sss_ref.cache.whole_files import keep, kept

SIGNATURE = (types.CPointer(types.float32), types.int64), types.void


def doubled(values, count):
    """A function of an address."""
    for k in range(count):
        values[k] *= np.float32(2)


def of_files(folder):
    """It is compiled, or taken from a folder."""
    callback = CFunc(doubled, SIGNATURE, {}, {"error_model": "numpy"})
    callback._cache = AddressFiles(folder, doubled)
    callback.compile()
    return callback


def of_values(callback):
    """What it makes of some."""
    values = np.array([1.5, -2.0, 3.0], np.float32)
    pointer = callback.ctypes.argtypes[0]
    callback.ctypes(values.ctypes.data_as(pointer), 2)
    return values.tolist()


def test_the_second_process_finds_its_address(tmp_path):
    compiled, kept = of_files(tmp_path), of_files(tmp_path)
    assert (compiled.cache_hits, kept.cache_hits) == (0, 1)
    assert compiled.address != kept.address
    assert of_values(compiled) == of_values(kept) == [3.0, -4.0, 3.0]
    assert [path.suffix for path in tmp_path.iterdir()] == [".code"]


@pytest.mark.parametrize("place", [0, 40, -1])
def test_a_damaged_file_is_told_and_replaced(place, tmp_path, caplog):
    of_files(tmp_path)
    (path,) = tmp_path.iterdir()
    content = bytearray(path.read_bytes())
    content[place] ^= 4
    path.write_bytes(content)
    again = of_files(tmp_path)
    assert again.cache_hits == 0 and of_values(again) == [3.0, -4.0, 3.0]
    assert [record.getMessage() for record in caplog.records] == [
        f"{path}: expected a whole file, got a damaged one; it is compiled and written again"
    ]
    assert of_files(tmp_path).cache_hits == 1


def test_a_file_with_the_code_of_another_is_told_and_replaced(tmp_path, caplog):
    """LLVM says of a name that it does not find that it begins at 0; nobody may call that."""
    of_files(tmp_path)
    (path,) = tmp_path.iterdir()
    _, object_code = pickle.loads(kept(path))
    keep(path, pickle.dumps(("no_such_function", object_code)))
    again = of_files(tmp_path)
    assert again.cache_hits == 0 and of_values(again) == [3.0, -4.0, 3.0]
    assert [record.getMessage() for record in caplog.records] == [
        f"{path}: expected the code of no_such_function, got none of that name; it is compiled and written again"
    ]
    assert of_files(tmp_path).cache_hits == 1
