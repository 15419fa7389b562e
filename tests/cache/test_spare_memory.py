"""Memory comes back when the last array that has a part in it is gone, and never before."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from sss_ref.cache.spare_memory import LARGEST, SMALLEST, Spare

SHAPE = (512, 1024, 3)


def kept(spare):
    return sum(block.nbytes for block in spare.blocks)


@pytest.mark.parametrize(
    "part",
    [
        lambda array: array[::2, :, 1],
        lambda array: np.moveaxis(array, -1, 0),
        lambda array: array.view(np.int32).reshape(-1),
        memoryview,
        np.asarray,
    ],
)
def test_a_part_keeps_the_memory_of_the_whole(part):
    spare = Spare()
    array = spare.empty(SHAPE, np.float32)
    array[...] = 7
    rest = part(array)
    del array
    assert kept(spare) == 0
    again = spare.empty(SHAPE, np.float32)
    again[...] = 8
    assert (np.asarray(rest).view(np.float32) == 7).all()
    del rest
    assert kept(spare) == 512 * 1024 * 3 * 4


def test_the_same_memory_serves_again_whatever_its_type():
    spare = Spare()
    address = spare.empty(SHAPE, np.float32).ctypes.data
    array = spare.empty((1024, 1536), np.dtype("<i4"))
    assert array.ctypes.data == address and array.shape == (1024, 1536) and array.dtype == np.int32
    assert array.flags.writeable and array.flags.c_contiguous and spare.blocks == []
    assert spare.empty((1024, 1537), np.int32).ctypes.data != address


def test_what_is_longest_unused_is_let_go_first():
    spare = Spare(most=5 * 2**20)
    arrays = [spare.empty((mebibytes, 2**20), np.uint8) for mebibytes in (1, 2, 3)]
    while arrays:
        del arrays[0]
    assert [block.nbytes >> 20 for block in spare.blocks] == [2, 3]


def test_small_and_large_buffers_are_plain_arrays():
    spare = Spare()
    for size in (SMALLEST - 1, LARGEST + 1):
        assert spare.empty((size,), np.uint8).flags.owndata
    assert spare.blocks == []


def test_threads_never_share_memory():
    spare = Spare()

    def fill(number):
        arrays = [spare.empty((2**20,), np.uint8) for _ in range(3)]
        for array in arrays:
            array[:] = number
        return all((array == number).all() for array in arrays)

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(fill, range(100)))


@pytest.mark.parametrize(
    ("shape", "is_kept"),
    [((512, 512), True), ((512, 511), False), ((4096, 4096, 3), True), ((4097, 4096, 3), False), ((1024, 1024), True)],
)
def test_buffers_of_one_to_192_mebibytes_are_kept(shape, is_kept):
    """Those of float32, of a size in pixels."""
    spare = Spare()
    assert spare.empty(shape, np.float32).shape == shape
    assert [block.nbytes for block in spare.blocks] == ([4 * int(np.prod(shape))] if is_kept else [])


def test_not_more_than_1280_mebibytes_are_kept():
    """Nothing is written into them, so the system gives none."""
    spare = Spare()
    buffers = [spare.empty((4096, 4096, channels), np.float32) for channels in (2, 3, 3, 3, 3, 3, 3)]
    buffers.clear()
    assert len(spare.blocks) == 7
    buffers = [spare.empty((1024, 512), np.float32)]
    buffers.clear()
    assert [block.nbytes >> 20 for block in spare.blocks] == [192] * 5 + [128, 2]


def test_of_several_the_one_used_last_serves_again():
    spare = Spare()
    addresses = [array.ctypes.data for array in [spare.empty(SHAPE, np.float32) for _ in range(3)]]
    given_back = [block.ctypes.data for block in spare.blocks]
    assert sorted(given_back) == sorted(addresses)
    again = [spare.empty(SHAPE, np.float32) for _ in range(3)]
    assert [array.ctypes.data for array in again] == given_back[::-1] and spare.blocks == []
