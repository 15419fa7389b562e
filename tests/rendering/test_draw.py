"""The texels of a UV layout that several triangles cover, and the columns of what is interpolated."""

import numpy as np
import pytest
from scenes import around, two_squares, written

from sss_ref.errors import MeshError
from sss_ref.rendering.draw import Machine, draw, varying_columns
from sss_ref.scene.load import load_scene

POLICIES = ("first", "last", "error")


def layout(tmp_path, policy, uvs, positions=None, triangles=None):
    """The draw of an irradiance map of eight by eight texels."""
    squares = two_squares()
    path = written(
        tmp_path / "squares.obj", *(squares[:2] if positions is None else (positions, triangles)), np.array(uvs)
    )
    size = {"width": 8, "height": 8, "overlap": policy}
    scene = load_scene(around(path, 8, method="texture_space", irradiance_map=size))
    (this_pass,) = (each for each in scene.method.passes if getattr(each.draw, "layout", False))
    return draw(scene, this_pass, {}, Machine())


def in_columns(*, second):
    """The UVs of two squares: the first has all columns, the second those from there on."""
    return [(0, 0), (1, 0), (1, 1), (0, 1), (second, 0), (1, 0), (1, 1), (second, 1)]


@pytest.mark.parametrize("policy", POLICIES)
def test_without_overlap_no_policy_counts(tmp_path, policy):
    """The first square in the left half, the second in the right one."""
    left_and_right = [(u / 2 + (k > 3) / 2, v) for k, (u, v) in enumerate(in_columns(second=0))]
    sketch = layout(tmp_path, policy, left_and_right)
    found = sketch.fragments.primitives.triangle[sketch.fragments.piece]
    assert sketch.notes == () and (found[:, :4] < 2).all() and (found[:, 4:] > 1).all()


@pytest.mark.parametrize(("policy", "triangles"), [("first", {0, 1}), ("last", {2, 3})])
def test_one_of_those_that_overlap_counts(tmp_path, policy, triangles):
    """The right half of the columns, 32 of 64 texels, is covered twice."""
    sketch = layout(tmp_path, policy, in_columns(second=0.5))
    found = sketch.fragments.primitives.triangle[sketch.fragments.piece]
    assert set(found[:, :4].flat) == {0, 1} and set(found[:, 4:].flat) == triangles
    assert sketch.notes == (
        f"irradiance map: 32 of 64 texels are covered more than once; the {policy} triangle counts",
    )


def test_overlap_is_an_error_that_names_two_triangles(tmp_path):
    """Those of the first such texel, in rows from the bottom up: at the bottom both squares have their first half."""
    with pytest.raises(MeshError) as error:
        layout(tmp_path, "error", in_columns(second=0.5))
    assert str(error.value) == (
        "squares.obj: expected UVs without overlap, got 32 texels covered twice or more, triangles 0 and 2 among them; "
        'set irradiance_map.overlap = "first", or export the mesh without UVs and set mesh.unwrap = true'
    )


def test_one_triangle_is_enough_and_none_is_an_error(tmp_path):
    corners, triangle = [(0, 0, 0), (1, 0, 0), (0, 1, 0)], np.array([(0, 1, 2)])
    whole = layout(tmp_path, "error", [(0, 0), (1, 0), (0, 1)], corners, triangle)
    assert (whole.fragments.piece >= 0).sum() > 20 and whole.notes == ()
    with pytest.raises(
        MeshError, match=r"squares\.obj: expected UVs inside 0 to 1, got none that cover a texel; export"
    ):
        layout(tmp_path, "error", [(0, 0), (0.01, 0), (0, 0.01)], corners, triangle)


def test_what_is_read_lies_column_by_column():
    """A position and a normal of three columns each, in the camera's pass; the shadow map's reads its position."""
    scene = load_scene("sphere", preset="robust")
    passes = {each.name: varying_columns(each) for each in scene.method.passes if each.draw.vertex_stages}
    assert passes["shadow_map"] == ({"fragment_position": 0}, 3)
    columns, count = passes["camera"]
    assert list(columns.items())[:2] == [("fragment_position", 0), ("fragment_normal", 3)]
    assert count == (8 if columns.get("fragment_uv") == 6 else 6)
