"""What every implementation of a shading language's API has, and how buffers are bound there: typed from the standards.

MAX_DRAW_BUFFERS is at least 8 in OpenGL and 4 in OpenGL ES 3.0, maxColorAttachments 4 in Vulkan; Direct3D 11 has 8
render targets, and registers from 0 on; WebGPU, "Limits", 8 attachments, of 32 bytes a sample together. Longer uniform
arrays are textures.
"""

import pytest

from sss_ref.interpret.shader import ARRAY_WIDTH, DIALECTS
from sss_ref.language.types import vec2, vec3, vec4

# most outputs, most bytes of these, longest array, groups, first texture, indices, overloads, four channels of a texel
LIMITS = {
    "glsl": (8, None, 64, None, 1, True, True, True),
    "vulkan": (4, None, 64, (0, 1), 1, True, True, True),
    "essl": (4, None, 64, None, 1, False, True, True),
    "hlsl": (8, None, 64, (0, 0), 0, True, True, False),
    "wgsl": (8, 32, 0, (0, 1), 1, False, False, True),
}
ROOM = {  # of a draw's targets in WGSL, 16 + 16 bytes and so on; bytes begin where 4 may
    (): True,
    (vec3, vec4): True,
    (vec3, vec3, bool): False,
    (vec2,) * 4: True,
    (vec2, vec2, vec2, float, bool): True,
    (vec2, vec2, vec2, float, bool, int): False,
    (float,) * 8: True,
    (int,) * 8: True,
    (bool,) * 8: True,
    (vec4, float, int, bool, float): True,
    (vec4, vec2, float, bool, int): False,
    (bool,) * 9: False,
}


@pytest.mark.parametrize("name", LIMITS)
def test_what_every_implementation_has(name):
    one = DIALECTS[name]
    found = one.most_outputs, one.most_bytes, one.longest_array, one.groups, one.first_texture
    assert (*found, one.indexed, one.overloads, one.four_channels) == LIMITS[name]
    assert one.bound({"a": None, "b": None}) == {"a": one.first_texture, "b": one.first_texture + 1}


def test_every_language_is_among_these():
    assert DIALECTS.keys() == LIMITS.keys()


@pytest.mark.parametrize("kinds", ROOM)
def test_the_bytes_of_all_targets_together(kinds):
    assert DIALECTS["wgsl"].has_room(kinds) is ROOM[kinds]
    assert DIALECTS["glsl"].has_room(kinds) is (len(kinds) <= 8)


def test_the_width_of_a_texture_that_holds_a_long_array():
    assert ARRAY_WIDTH == 4096
