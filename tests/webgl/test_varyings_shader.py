"""The draws that write what the rasterizer gives, four targets each, every one with its own triangle."""

from types import SimpleNamespace

import pytest

from sss_ref.errors import SceneError
from sss_ref.language.types import vec2, vec3
from sss_ref.scene.load import load_scene
from sss_ref.webgl.judge_page import _check_size, reduced
from sss_ref.webgl.varyings_shader import varyings_draws

KINDS = {"a": vec3, "b": vec2, "c": float, "d": vec3, "e": vec2, "f": float, "g": vec3, "unread": vec3}


def outputs(read, layout=False):
    this_pass = SimpleNamespace(name="camera", draw=SimpleNamespace(layout=layout, varyings=KINDS))
    return [list(each["outputs"]) for each in varyings_draws(this_pass, list(read))]


@pytest.mark.parametrize(
    ("read", "layout", "expected"),
    [
        ("", False, [["triangle", "depth"]]),
        ("ab", False, [["triangle", "depth", "a", "b"]]),
        ("abc", False, [["triangle", "depth", "a", "b"], ["triangle_2", "c"]]),
        ("abcde", False, [["triangle", "depth", "a", "b"], ["triangle_2", "c", "d", "e"]]),
        ("abcdefg", False, [["triangle", "depth", "a", "b"], ["triangle_2", "c", "d", "e"], ["triangle_3", "f", "g"]]),
        ("abc", True, [["triangle", "a", "b", "c"]]),
        ("abcd", True, [["triangle", "a", "b", "c"], ["triangle_2", "d"]]),
    ],
)
def test_four_targets_a_draw(read, layout, expected):
    assert outputs(read, layout) == expected


def test_a_shader_writes_what_it_is_given():
    this_pass = SimpleNamespace(name="camera", draw=SimpleNamespace(layout=False, varyings=KINDS))
    first, second = varyings_draws(this_pass, ["a", "b", "c"])
    lines = first["fragment"].split("void main()")[1].split()
    assert " ".join(lines) == ("{ out_triangle = triangle_number; out_depth = gl_FragCoord.z; out_a = a; out_b = b; }")
    assert "out_triangle_2 = triangle_number;\n    out_c = c;" in second["fragment"]
    assert "in vec3 a;" in first["fragment"] and "flat in int triangle_number;" in first["fragment"]


SIDES = {"camera.width": 400, "camera.height": 200, "shadow_map.width": 64, "shadow_map.height": 512}


@pytest.mark.parametrize(
    ("side", "expected"), [(128, (128, 64, 16, 128)), (48, (48, 24, 8, 48)), (8, (8, 8, 8, 8)), (9, (9, 8, 8, 9))]
)
def test_the_longer_side_of_each_picture_is_so_long(side, expected):
    """And the other one in proportion, but never shorter than 8."""
    found = reduced(load_scene("sphere", **SIDES), side)
    assert tuple(found[key] for key in SIDES) == expected


@pytest.mark.parametrize("side", [7, 129])
def test_a_side_that_no_page_has(side):
    with pytest.raises(SceneError, match=f"side: expected 8 to 128 pixels, got {side}; take 48, which shows most"):
        reduced(load_scene("sphere"), side)


def test_a_scene_that_is_too_large_for_a_page():
    small = {"shadow_map.width": 128, "shadow_map.height": 128, "camera.width": 64, "camera.height": 128}
    _check_size(load_scene("sphere", **small))
    with pytest.raises(
        SceneError, match="camera: expected at most 128 x 128 pixels, got 64 x 129; load the scene with"
    ):
        _check_size(load_scene("sphere", **{**small, "camera.height": 129}))
