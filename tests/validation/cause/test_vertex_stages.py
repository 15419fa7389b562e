"""How a vertex stage is misread: what each misreading gives for one vertex, by hand."""

import numpy as np
import pytest

from sss_ref.language.types import mat3, mat4, vec2, vec3
from sss_ref.passes.vertex import layout_vertex, mesh_vertex
from sss_ref.validation.cause.hypothesis import SOURCE
from sss_ref.validation.cause.vertex_stages import vertex_stages

CLIP = [[2, 0, 0, 1], [0, 4, 0, 3], [0, 0, 1, -2], [0, 0, -1, 7]]
WORLD = [[0, 2, 0, 5], [1, 0, 0, 6], [0, 0, 3, 7], [0, 0, 0, 1]]
GIVEN = {
    "position": vec3(*np.float32([1, 2, 3])),
    "normal": vec3(*np.float32([0, 1, -1])),
    "uv": vec2(*np.float32([0.25, 0.125])),
    "world_from_model": mat4(WORLD),
    "normal_from_model": mat3(2 * np.eye(3)),
    "clip_from_model": mat4(CLIP),
}
RIGHT = {
    "clip_position": [3, 11, 1, 4],
    "fragment_position": [9, 7, 16],
    "fragment_normal": [0, 2, -2],
    "fragment_uv": [0.25, 0.125],
}
MISREAD = {  # in words -> what is another output then
    "clip_position is not divided by w": {"clip_position": [3, 11, 1, 1]},
    "clip_position is divided by w in the shader": {"clip_position": [0.75, 2.75, 0.25, 1]},
    "clip_position.y is negated": {"clip_position": [3, -11, 1, 4]},
    "the normal is turned by world_from_model": {"fragment_normal": [2, 0, -3]},
    "the normal is moved like a point": {"fragment_normal": [7, 6, 4]},
    "the position is turned and not moved": {"fragment_position": [4, 1, 9]},
    "the normal is the position": {"fragment_normal": [1, 2, 3]},
    "v counts from the top": {"fragment_uv": [0.25, 0.875]},
}


def stages(right):
    """In words -> the charge, and the stage then."""
    return {charge.text: (charge, stage) for charge, stage in vertex_stages(right)}


def given_by(stage):
    values = stage(*(GIVEN[own] for own in stage.parameters))
    return {own: [float(part) for part in value] for own, value in zip(stage.writes, values, strict=True)}


def test_the_right_one_gives_this():
    assert given_by(mesh_vertex) == RIGHT


@pytest.mark.parametrize("words", MISREAD)
def test_what_a_misreading_gives_instead(words):
    ((charge, stage),) = (
        each for text, each in stages(mesh_vertex).items() if text.startswith(f"mesh_vertex: {words}")
    )
    assert given_by(stage) == RIGHT | MISREAD[words]
    assert charge.blames == SOURCE and [*stage.writes.values()] == [*mesh_vertex.writes.values()]


def test_mistakes_in_the_source_follow():
    found = [*stages(mesh_vertex)]
    assert len(found) > len(MISREAD) and found[0].startswith("mesh_vertex: clip_position is not divided by w")
    assert all("` for `" in text for text in found[len(MISREAD) :])
    assert not any("` for `" in text for text in found[: len(MISREAD)])


def test_a_layout_has_them_too():
    assert {text.replace("layout_vertex", "mesh_vertex") for text in stages(layout_vertex)} >= {
        text for text in stages(mesh_vertex) if "` for `" not in text
    }
