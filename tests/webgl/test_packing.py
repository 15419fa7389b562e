"""Arrays in a page: what a script unpacks are the bytes of the array."""

import base64
import zlib

import numpy as np
import pytest

from sss_ref.webgl.packing import deflated, plain

ARRAYS = [
    np.array([[1.5, -0.0], [np.inf, 3e-40]], np.float32),
    np.arange(-3, 5, dtype=np.int32)[::2],
    np.array([0, 1, 255], np.uint8),
    np.array([7], ">u4"),
]


@pytest.mark.parametrize("array", ARRAYS, ids=lambda array: array.dtype.str)
def test_arrays_come_back(array):
    little = array.astype(array.dtype.newbyteorder("<"))
    assert base64.b64decode(plain(array)) == little.tobytes()
    packed = deflated(array)
    planes = np.frombuffer(zlib.decompress(base64.b64decode(packed["deflated"])), np.uint8)
    assert planes.reshape(packed["size"], -1).T.tobytes() == little.tobytes()


def test_many_like_numbers_need_few_letters():
    array = (np.arange(5000, dtype=np.uint32) % 7).reshape(50, 100)
    assert len(deflated(array)["deflated"]) < len(plain(array)) / 50
