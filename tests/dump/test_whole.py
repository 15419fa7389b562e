"""Triangle numbers at the borders of what each storage tells apart."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.dump.whole import whole_numbers
from sss_ref.errors import DumpError


def read(numbers, storage, last, scale=1.0, offset=0.0, background=None):
    """Numbers of a mesh whose last triangle has that number."""
    table = SimpleNamespace(scale=scale, offset=offset, background=background)
    source = SimpleNamespace(path=Path("triangle.x"), table=table)
    slot = SimpleNamespace(name="triangle", largest=last, dtype=np.dtype(np.int32))
    return whole_numbers(np.array(numbers, np.float64).reshape(-1, 1, 1), slot, source, storage).ravel().tolist()


@pytest.mark.parametrize(("storage", "limit"), [("float16", 2048), ("float24", 65536), ("float32", 16777216)])
def test_floats_hold_whole_numbers_up_to_a_power_of_2(storage, limit):
    """One number more and two triangles have one number; that of a mesh that has no more is unmistakable."""
    assert read([limit, -1, 0], storage, limit) == [limit, -1, 0]
    assert read([limit - 1, 1 - limit], storage, limit + 1) == [limit - 1, 1 - limit]
    for number in (limit, -limit):
        with pytest.raises(DumpError) as error:
            read([0, number], storage, limit + 1)
        assert str(error.value) == (
            f"triangle.x: expected numbers up to {limit} in triangle, as {storage} holds no more of them whole, "
            f"got {limit} of a mesh of {limit + 2} triangles; dump them as 32-bit integers or floats"
        )


@pytest.mark.parametrize(("storage", "nothing"), [("uint8", 255), ("uint16", 65535)])
def test_the_largest_code_is_nothing_and_no_triangle(storage, nothing):
    assert read([nothing, nothing - 1, 0], storage, nothing - 1) == [-1, nothing - 1, 0]
    with pytest.raises(DumpError) as error:
        read([0], storage, nothing)
    assert str(error.value) == (
        f"triangle.x: expected a number for each of {nothing + 1} triangles in triangle, got {storage}, "
        "which has fewer; dump them as 32-bit integers"
    )


@pytest.mark.parametrize("said", [{"scale": 2.0}, {"offset": -1.0}, {"background": 0}])
def test_a_code_that_the_mapping_file_explains_is_a_number(said):
    assert read([255, 0], "uint8", 254, **said) == [255, 0]


def test_int32_ends_below_two_to_the_31():
    assert read([2**31 - 1, 1 - 2**31], "uint32", 9) == [2**31 - 1, 1 - 2**31]
    for number in (2.0**31, 0.5, np.inf):
        with pytest.raises(DumpError, match=r"^triangle.x: expected whole numbers in triangle, got .* at pixel 0,1 "):
            read([0, number], "uint32", 9)
