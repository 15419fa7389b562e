"""The borders of every quantity: the last values that are taken, and the first beyond them that are not."""

import math

import pytest
from pydantic import TypeAdapter, ValidationError

from sss_ref.scene_file import quantities as q
from sss_ref.scene_file.diffusion import Samples, Taps
from sss_ref.scene_file.scattering import Profile

LARGEST = math.nextafter(2.0**128 - 2.0**103, 0)  # the largest float64 that is finite in float32
SMALLEST = math.nextafter(2.0**-150, 1)  # the smallest that is not 0 in float32
ROW = (1.0, 1.0, 1.0, 1.0)
BORDERS = {  # name -> type, what is taken, what is not
    "number": (q.Number, [LARGEST, -LARGEST, 0, SMALLEST], [2.0**128 - 2.0**103, -(2.0**128), True, "1"]),
    "not negative": (q.NonNegative, [0, 1e-300, LARGEST], [-1e-300, 2.0**128]),
    "positive": (q.Positive, [SMALLEST, LARGEST], [2.0**-150, 0, -1, 2.0**128]),
    "positive or zero": (q.PositiveOrZero, [0, SMALLEST], [2.0**-150, -1]),
    "inset": (q.Inset, [SMALLEST, 1], [0, math.nextafter(1, 2)]),
    "strength": (q.Strength, [0, 1000], [-1e-9, math.nextafter(1000, 2000)]),
    "texels": (q.Texels, [0, 16384], [-1e-9, math.nextafter(16384, 20000)]),
    "share": (q.Share, [0, 1], [-1e-9, math.nextafter(1, 2)]),
    "field of view": (q.FieldOfView, [1e-9, math.nextafter(180, 0)], [0, 180]),
    "stops": (q.Stops, [-20, 20], [math.nextafter(-20, -21), math.nextafter(20, 21)]),
    "size": (q.Size, [1, 16384], [0, 16385, 1.0, True]),
    "count": (q.Count, [0, 16384], [-1, 16385, 1.0]),
    "vector": (q.Vector, [[0, 0, 0], (1, -2, 3)], [[1, 2], [1, 2, 3, 4], [1, 2, True]]),
    "color": (q.Color, [[0, 0, 0], [9, 9, 9]], [[0, 0, -1e-9], [-1, 0, 0]]),
    "direction": (q.Direction, [[0, 0, 1e-300], [0, 1, 0], [1, 0, 0]], [[0, 0, 0]]),
    "scale": (q.Scale, [1, -2.5, [1, 2, 3]], [0, [1, 0, 1], [1, 1], True]),
    "samples": (Samples, [1, 255], [0, 256]),
    "taps": (Taps, [3, 255], [1, 2, 4, 254, 256, 257]),
    "profile": (Profile, ["skin", [ROW], [ROW] * 64], [[], [ROW] * 65, "wood"]),
    "one or three": (q.OneOrThree[q.Positive], [1, [1, 2, 3]], [0, [1, 2], [1, 2, 0]]),
}


def takes(quantity, value):
    try:
        TypeAdapter(quantity, config=q.Table.model_config).validate_python(value)
    except ValidationError:
        return False
    return True


@pytest.mark.parametrize("name", BORDERS)
def test_the_borders(name):
    quantity, taken, refused = BORDERS[name]
    assert [value for value in taken if not takes(quantity, value)] == []
    assert [value for value in refused if takes(quantity, value)] == []


def test_one_number_scales_all_axes():
    adapter = TypeAdapter(q.Scale, config=q.Table.model_config)
    assert adapter.validate_python(2) == (2, 2, 2) and adapter.validate_python([1, 2, 3]) == (1, 2, 3)
