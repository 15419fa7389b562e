import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sss_ref.dump.files import parts_of
from sss_ref.dump.formats.raw import RawLayout
from sss_ref.errors import DumpError

STORAGE = {
    "float32": "float32",
    "float16": "float16",
    "uint8": "uint8",
    "uint16": "unorm16",
    "int32": "int32",
    "uint32": "uint32",
}


@pytest.mark.parametrize("dtype", STORAGE)
@pytest.mark.parametrize("shape", [(3, 5), (3, 5, 1), (3, 5, 4)])
def test_every_type_and_shape(tmp_path, dtype, shape):
    data = np.random.default_rng(1).bytes(int(np.prod(shape)) * np.dtype(dtype).itemsize)
    (tmp_path / "x.raw").write_bytes(data)
    (texels,) = parts_of(tmp_path / "x.raw", RawLayout(shape, dtype))
    assert texels.data.tobytes() == data and texels.data.dtype == dtype
    assert texels.data.shape == (*shape, 1)[:3] and texels.storage == STORAGE[dtype]


@pytest.mark.parametrize(
    ("shape", "found", "message"),
    [
        ((3, 5), 59, "expected 60 bytes for 5 x 3 texels, got 59; "),
        ((3, 5), 61, "expected 60 bytes for 3 x 5 float32, got 61; correct shape or dtype"),
        ((3, 5, 7), 420, "got 3 x 5 x 7"),
        ((16384, 16384), 60, "expected 1073741824 bytes"),
        ((16384, 16384, 16384), 60, "expected at most 4294967296 bytes of texels"),
        ((100000, 100000), 60, "got 100000 x 100000"),
    ],
)
def test_what_is_refused_without_taking_memory(tmp_path, shape, found, message):
    (tmp_path / "x.raw").write_bytes(bytes(found))
    tracemalloc.start()
    with pytest.raises(DumpError) as caught:
        parts_of(tmp_path / "x.raw", RawLayout(shape, "float32"))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert message in str(caught.value) and peak < 2**20


def test_a_missing_file(tmp_path):
    with pytest.raises(DumpError, match=r"x\.raw: expected a file, got No such file or directory; check the path"):
        parts_of(tmp_path / "x.raw", RawLayout((1, 1), "uint8"))


@settings(max_examples=200, derandomize=True)
@given(
    data=st.binary(max_size=64),
    shape=st.lists(st.integers(1, 16384) | st.integers(1, 4), min_size=2, max_size=3),
    dtype=st.sampled_from(sorted(STORAGE)),
)
def test_arbitrary_bytes_and_shapes_raise_nothing_else(tmp_path, data, shape, dtype):
    (tmp_path / "x.raw").write_bytes(data)
    try:
        (texels,) = parts_of(tmp_path / "x.raw", RawLayout(tuple(shape), dtype))
    except DumpError:
        return
    assert texels.data.tobytes() == data
