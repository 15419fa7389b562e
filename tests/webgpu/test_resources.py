"""What a WGSL shader says it is given, read from its text."""

import pytest

from sss_ref.errors import ShaderError
from sss_ref.language.types import mat4, vec3
from sss_ref.webgpu.resources import Texture2D, attributes_of, resources_of

SHADER = """
// @group(7) @binding(9) var nothing: texture_2d<f32>;
struct Constants { clip: mat4x4<f32>, color: vec3f, count: i32, strength: f32 }
@group(1) @binding(0) var<uniform> constants: Constants;
@group(1) @binding(2) var lit: texture_2d<f32>;
@group(1) @binding(3) var mask: texture_2d<u32>;
@group(1) @binding(5) var triangle: texture_2d<i32>;
"""


def refusal(text):
    with pytest.raises(ShaderError) as error:
        resources_of(text, "camera.wgsl")
    return str(error.value)


def test_textures_and_constants_are_found():
    found = resources_of(SHADER, "camera.wgsl")
    textures = (Texture2D(2, "lit", "f32"), Texture2D(3, "mask", "u32"), Texture2D(5, "triangle", "i32"))
    assert (found.group, found.textures, found.constants.binding) == (1, textures, 0)
    assert found.constants.kinds == {"clip": mat4, "color": vec3, "count": int, "strength": float}


def test_a_shader_may_read_nothing():
    found = resources_of("@fragment fn main() {}", "camera.wgsl")
    assert (found.group, found.textures, found.constants) == (0, (), None)


@pytest.mark.parametrize(
    ("more", "came"),
    [
        ("@group(0) @binding(1) var other: texture_2d<f32>;", "2 and 1"),
        ("@group(1) @binding(1) var<uniform> more: Constants;", "1 and 2"),
    ],
)
def test_all_is_in_one_group_with_one_struct(more, came):
    expected = f"expected one group, with one struct of uniforms, got {came}; bind all as our shaders do"
    assert refusal(SHADER + more) == f"camera.wgsl: {expected}"


@pytest.mark.parametrize(
    ("before", "after", "told"),
    [
        ("lit: texture_2d<f32>", "lit: texture_3d<f32>", "expected lit to be a texture_2d of f32, i32 or u32"),
        ("count: i32", "count: f16", "expected count to be of type "),
        ("struct Constants", "struct Others", "expected a struct Constants with the uniforms, got none"),
    ],
)
def test_what_is_neither_texture_nor_number_is_told(before, after, told):
    assert refusal(SHADER.replace(before, after)).startswith(f"camera.wgsl: {told}")


def test_attributes_are_those_of_the_vertex_shader():
    text = """
    @fragment fn first(@location(4) normal: vec3f) -> @location(0) vec4f {}
    @vertex fn main(@location(2) position: vec3<f32>, @location(0) uv: vec2f, @location(1) mine: f32) -> Out {}
    @fragment fn other(@location(3) normal: vec3f) {}
    """
    assert attributes_of(text, {"position": 0, "uv": 0, "normal": 0}) == {"position": 2, "uv": 0}
