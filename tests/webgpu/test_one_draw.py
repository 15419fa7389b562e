"""A single stage by itself on lavapipe: from given buffers and uniforms to what it writes."""

from typing import NamedTuple

import numpy as np
import pytest
from lavapipe import LAVAPIPE, needs_lavapipe

from sss_ref.errors import ShaderError
from sss_ref.gl.shaders import own_shaders
from sss_ref.interpret.shader import WGSL, stage_source
from sss_ref.language import float32, select, stage, vec3
from sss_ref.language.pipeline import Pass, ScreenDraw
from sss_ref.passes.phong import phong_shading
from sss_ref.webgpu.adapter import open_device
from sss_ref.webgpu.one_draw import OneDraw
from sss_ref.webgpu.textures import downloaded, uploaded

pytestmark = needs_lavapipe


class Told(NamedTuple):
    """Which values are what."""

    kind: float
    scaled: vec3


@stage(source="a test")
def told(value: float, other: float, by: vec3, flag: bool, count: int) -> Told:
    """1 for NaN, 2 for equal, 0 for what differs; 4 more where a flag is set, and 8 times a count."""
    kind = select(value != value, 1.0, select(value != other, 0.0, 2.0))
    return Told(kind + select(flag, 4.0, 0.0) + 8.0 * float32(count), by * value)


@pytest.fixture
def device():
    opened = open_device(LAVAPIPE)
    yield opened
    opened.destroy()


def test_a_stage_is_drawn_from_buffers_and_uniforms(device):
    value = np.float32([[np.nan, 1.5, -2.0], [0.0, np.inf, 3.0]])
    uniforms = {"other": np.float32(1.5), "by": np.float32([1, 2, 3]), "flag": True, "count": np.int32(1)}
    one = Pass("own", "camera", ScreenDraw(), (told,))
    (pair,) = own_shaders(one, {"value"}, ["kind", "scaled"], {}, None, WGSL)
    targets = {name: (one.values[name], 77.0) for name in pair.outputs}
    encoder = device.create_command_encoder()
    drawn = OneDraw(device, pair, targets).record(encoder, {"value": uploaded(device, value)}, uniforms, (3, 2))
    device.queue.submit([encoder.finish()])
    kind, scaled = (downloaded(device, drawn[name], one.values[name]) for name in ("kind", "scaled"))
    np.testing.assert_array_equal(kind, [[13, 14, 12], [12, 12, 12]])
    np.testing.assert_array_equal(scaled, value[..., None] * np.float32([1, 2, 3]))


def test_an_inequality_says_true_of_nan():
    assert "select(select(2.0, 0.0, !(value == other)), 1.0, !(value == value))" in stage_source(told, {}, WGSL)


def test_what_nobody_gives_is_told(device):
    one = Pass("own", "camera", ScreenDraw(), (phong_shading,))
    (pair,) = own_shaders(one, set(), ["phong"], {}, None, WGSL)
    with pytest.raises(
        ShaderError, match=r"^own: expected names of earlier buffers or uniforms \(ambient\), got albedo; "
    ):
        OneDraw(device, pair, {"phong": (vec3, 0.0)}).record(
            device.create_command_encoder(), {}, {"ambient": 0.5}, (1, 1)
        )
