"""Textures of WebGPU: what is asked of a device that only notes it."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.language.types import ivec2, vec2, vec3, vec4
from sss_ref.webgpu.textures import DEPTH, channels_in, downloaded, format_of, target, uploaded

wgpu = pytest.importorskip("wgpu", reason="pip install 'sss_ref[webgpu]'")
USAGE = wgpu.TextureUsage
KINDS = [
    (float, 1, "r32float"),
    (int, 1, "r32sint"),
    (bool, 1, "r8uint"),
    (vec2, 2, "rg32float"),
    (ivec2, 2, "rg32float"),
    (vec3, 4, "rgba32float"),
    (vec4, 4, "rgba32float"),
]


class Device:
    """Notes what is made and written; gives rows that are filled up when it is read."""

    def __init__(self, rows=None):
        self.made, self.written, self.queue = [], [], self
        self.rows = rows
        self.layout = self.size = None

    def create_texture(self, **given):
        self.made.append(given)
        return SimpleNamespace(size=given["size"])

    def write_texture(self, place, data, layout, size):
        self.written.append((data.copy(), layout, size))

    def read_texture(self, place, layout, size):
        self.layout, self.size = layout, size
        ends = [row.tobytes().ljust(layout["bytes_per_row"], b"\xee") for row in self.rows]
        return memoryview(b"".join(ends))


@pytest.mark.parametrize(("kind", "channels", "name"), KINDS)
def test_three_channels_are_stored_as_four(kind, channels, name):
    assert (channels_in(kind), format_of(kind)) == (channels, name)


def test_a_target_is_drawn_into_and_read_but_no_depth():
    device = Device()
    target(device, (3, 2), "r32float", "lit")
    target(device, (3, 2), DEPTH)
    read = USAGE.RENDER_ATTACHMENT | USAGE.TEXTURE_BINDING | USAGE.COPY_SRC
    assert [(each["label"], each["size"], each["usage"]) for each in device.made] == [
        ("lit", (3, 2, 1), read),
        ("", (3, 2, 1), USAGE.RENDER_ATTACHMENT),
    ]


@pytest.mark.parametrize(
    ("shape", "dtype", "name", "row"),
    [
        ((2, 5), "f4", "r32float", 20),
        ((2, 5), "u1", "r8uint", 5),
        ((2, 5, 2), "f4", "rg32float", 40),
        ((2, 5, 3), "f4", "rgba32float", 80),
        ((2, 5, 4), "f4", "rgba32float", 80),
        ((1, 1), "i4", "r32sint", 4),
    ],
)
def test_an_array_is_uploaded_row_by_row(shape, dtype, name, row):
    """Of three channels the first is there again as the fourth."""
    device, data = Device(), np.arange(np.prod(shape)).reshape(shape).astype(dtype)
    uploaded(device, data)
    ((stored, layout, size),) = device.written
    height, width = shape[:2]
    (made,) = device.made
    assert (made["format"], made["size"]) == (name, (width, height, 1))
    assert made["usage"] == USAGE.TEXTURE_BINDING | USAGE.COPY_DST
    assert layout == {"bytes_per_row": row, "rows_per_image": height} and size == (width, height, 1)
    expected = np.dstack([data, data[..., 0]]) if shape[2:] == (3,) else data
    assert stored.tobytes() == expected.tobytes()


@pytest.mark.parametrize("width", [1, 15, 16, 17, 64, 65])
@pytest.mark.parametrize(("kind", "stored"), [(float, 1), (bool, 1), (vec2, 2), (vec3, 4), (vec4, 4)])
def test_rows_that_begin_each_256_bytes_are_read_as_one(width, kind, stored):
    dtype = np.uint8 if kind is bool else np.float32
    data = np.arange(3 * width * stored).astype(dtype).reshape(3, width, stored)
    device = Device(data)
    got = downloaded(device, SimpleNamespace(size=(width, 3, 1)), kind)
    row = width * stored * np.dtype(dtype).itemsize
    assert device.layout == {"bytes_per_row": -(-row // 256) * 256, "rows_per_image": 3}
    assert device.size == (width, 3, 1)
    expected = data[..., 0] if stored == 1 else data[..., :3] if kind is vec3 else data
    assert got.dtype == dtype and got.shape == expected.shape and got.tolist() == expected.tolist()
    assert got.flags.writeable and got.flags.c_contiguous
