"""Every shader of every alternative of a scene file is taken by naga, which compiles WGSL for wgpu and Firefox."""

import pytest
from every_shader import shaders_of
from lavapipe import LAVAPIPE, needs_lavapipe

from sss_ref.interpret.shader import WGSL
from sss_ref.methods.stages import all_stages
from sss_ref.webgpu.adapter import open_device


@pytest.fixture(scope="module")
def shaders():
    """Every shader once: (suffix, source)."""
    return shaders_of(WGSL)


def test_every_stage_is_in_some_shader(shaders):
    sources = "".join(source for _, source in shaders)
    assert [name for name in all_stages() if f" {name}(" not in sources] == []


@needs_lavapipe
def test_every_shader_is_taken(shaders):
    device = open_device(LAVAPIPE)
    for _, source in shaders:
        device.create_shader_module(code=source)  # raises an error that shows the line
    assert len(shaders) > 200
    device.destroy()
