"""Draws, passes and methods: what each reads and writes, and what is left of it for a few buffers."""

from typing import NamedTuple

import pytest

from sss_ref.language import mat4, stage, vec2, vec3, vec4
from sss_ref.language.pipeline import REGISTERS, MeshDraw, Method, Pass, ScreenDraw


class Placed(NamedTuple):
    clip_position: vec4
    fragment_uv: vec2


@stage(source="test")
def placed(position: vec3, uv: vec2, clip_from_model: mat4) -> Placed:
    """A vertex stage with one varying."""
    return Placed(clip_from_model * vec4(position, 1.0), uv)


class Out(NamedTuple):
    out: float


@stage(source="test")
def doubled(value: float) -> Out:
    """Twice a value."""
    return Out(value * 2.0)


@stage(source="test")
def across(fragment_uv: vec2, scale: float) -> Out:
    """A coordinate of the surface, scaled."""
    return Out(fragment_uv.x * scale)


MESH = MeshDraw(placed, triangle="triangle", depth="depth")
FIRST = Pass("first", "picture", MESH, (across.bound(out="a"), doubled.bound(value="a", out="exact_b")))
SECOND = Pass(
    "second",
    "picture",
    ScreenDraw(stencil="triangle"),
    (doubled.bound(value="exact_b", out="c"), doubled.bound(value="c", out="d"), doubled.bound(value="a", out="e")),
    registers=("c",),
)
EXTRA = Pass("extra", "picture", ScreenDraw(), (doubled.bound(value="e", out="f"),), on_demand=True)
METHOD = Method("test", (FIRST, SECOND, EXTRA))


def test_a_draw_of_the_mesh():
    assert MESH.varyings == {"fragment_uv": vec2}
    assert MESH.reads == {"clip_from_model": mat4}
    assert MESH.outputs == {"triangle": int, "depth": float}
    assert MESH.covered_by({"fragment_uv", "scale"}) == {"triangle"}
    assert MESH.covered_by({"scale"}) == set()


@pytest.mark.parametrize(
    ("triangle", "coverage", "extent"), [("t", "c", "t"), ("t", "", "t"), ("", "c", "c"), ("", "", "")]
)
def test_the_extent_of_a_draw_is_its_triangles_or_else_its_coverage(triangle, coverage, extent):
    assert MeshDraw(placed, triangle=triangle, coverage=coverage).extent == extent


def test_unless_told_a_draw_is_no_layout_and_a_pass_runs_once_and_always():
    assert (MESH.layout, ScreenDraw().layout, FIRST.on_demand, FIRST.rounds) == (False, False, False, 1)


def test_what_a_pass_gives_and_what_of_it_are_buffers():
    """A share before rounding is a register by its name, another value where the pass says so."""
    assert list(FIRST.values) == ["triangle", "depth", "a", "exact_b"]
    assert list(FIRST.outputs) == ["triangle", "depth", "a"]
    assert (list(SECOND.values), list(SECOND.outputs)) == (["c", "d", "e"], ["d", "e"])


def test_what_a_pass_reads_comes_from_outside():
    assert (FIRST.reads, FIRST.needs) == ({"scale": float}, {"scale", "clip_from_model"})
    assert (SECOND.reads, SECOND.needs) == ({"a": float, "exact_b": float}, {"a", "exact_b", "triangle"})


def test_for_a_few_buffers_the_stages_they_depend_on_are_left_in_order():
    assert [each.writes["out"] for each in SECOND.only({"d"}).stages] == ["c", "d"]
    assert [each.writes["out"] for each in SECOND.only({"e"}).stages] == ["e"]
    assert SECOND.only({"a"}).stages == ()


def test_for_a_few_buffers_the_passes_they_depend_on_are_left_in_order():
    left = METHOD.only({"f"})
    assert [(each.name, [s.writes["out"] for s in each.stages]) for each in left.passes] == [
        ("first", ["a"]),
        ("second", ["e"]),
        ("extra", ["f"]),
    ]
    assert [each.name for each in METHOD.only({"depth"}).passes] == ["first"]
    assert METHOD.only({"other"}).passes == ()


def test_a_method_has_its_passes_by_name_and_their_values_in_order():
    assert METHOD["second"] is SECOND
    assert list(METHOD.outputs) == ["triangle", "depth", "a", "d", "e"]
    assert list(METHOD.values) == ["triangle", "depth", "a", "exact_b", "c", "d", "e", "f"]
    assert METHOD.on_demand == {"extra": ["f"], REGISTERS: ["exact_b", "c"]}


def test_each_pass_comes_with_what_those_after_it_read():
    assert [(each.name, later) for each, later in METHOD.in_order()] == [
        ("first", {"a", "exact_b", "triangle", "e"}),
        ("second", {"e"}),
        ("extra", set()),
    ]
