import pytest

from sss_ref.errors import SceneError
from sss_ref.raster.viewport import Viewport


def test_eight_subpixel_bits_unless_told_otherwise():
    assert Viewport(640, 480).step == 256
    assert Viewport(640, 480, subpixel_bits=4).step == 16


@pytest.mark.parametrize("size", [(0, 1), (1, 0), (16385, 1), (1, 16385)])
def test_refuses_a_size_outside_the_limits(size):
    with pytest.raises(SceneError, match=f"{size[0]} x {size[1]}"):
        Viewport(*size)


@pytest.mark.parametrize("bits", [-1, 9])
def test_refuses_a_precision_outside_the_limits(bits):
    with pytest.raises(SceneError, match=f"got {bits}"):
        Viewport(1, 1, subpixel_bits=bits)
