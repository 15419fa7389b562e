"""What is shown of an explanation: rows of source, value, bits and unit; in the terminal and as a page."""

import re

import numpy as np
import pytest
from scenes import around, sphere, written

from sss_ref.cli import main
from sss_ref.errors import SceneError
from sss_ref.explanation.explain import explain
from sss_ref.explanation.rows import sections
from sss_ref.explanation.values import between, bits, shown
from sss_ref.language.types import Array, Texture, ivec2, mat3, vec3
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

F = np.float32


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("bodies") / "sphere.obj", *sphere(8))
    return explain(render(load_scene(around(path, size=32)), interpreter="arrays"), (16, 17))


def rows_of(told, stage, depth=1):
    (section,) = sections(told.passes, stage, depth)
    return section.rows


@pytest.mark.parametrize(
    ("value", "text", "pattern"),
    [
        (F(0.1), "0.1", "3dcccccd"),
        (F(-0.0), "-0", "80000000"),
        (1.0, "1", "3f800000"),
        (F(1e30), "1e+30", "7149f2ca"),
        (np.True_, "true", ""),
        (False, "false", ""),
        (np.int32(-1), "-1", ""),
        (ivec2(np.int32(3), np.int32(4)), "(3, 4)", ""),
        (vec3(F(1), F(0.5), F(2)), "(1, 0.5, 2)", "3f800000 3f000000 40000000"),
        (Texture(np.zeros((2, 5, 3), F)), "5 x 2 texels", ""),
        (Array(np.zeros((13, 2), F)), "13 elements", ""),
        (mat3(np.eye(3)), "3 x 3 matrix", ""),
    ],
)
def test_values_as_text(value, text, pattern):
    assert (shown(value), bits(value)) == (text, pattern)


def test_what_a_stage_calls_otherwise_is_read_under_both_names(tmp_path):
    """Its lines have the name of the parameter; which buffer or uniform that is says the row of what it reads."""
    path = written(tmp_path / "sphere.obj", *sphere(8))
    result = render(load_scene(around(path, size=32), preset="robust"), interpreter="arrays")
    rows = {row.text: row.value for row in rows_of(explain(result, (16, 17)), "back_point")}
    assert rows["position_world = inside_point"] == shown(vec3(*result["inside_point"][17, 16]))
    assert "direction = normalize(position_world - light_position)" in rows and "light_position" in rows


@pytest.mark.parametrize(
    ("low", "high", "text"),
    [
        (F(0.1), F(0.1), "exact"),
        (F(-0.0), F(0.0), "exact"),
        (F(0.1), F(0.2), "[0.1, 0.2]"),
        (F(-np.inf), F(2), "[-inf, 2]"),
        (F(-np.inf), F(np.inf), "anything"),
        (np.False_, np.True_, "false or true"),
        (np.True_, np.True_, "exact"),
        (np.int64(3), np.int64(4), "[3, 4]"),
        (vec3(F(1), F(0.5), F(2)), vec3(F(1), F(1.5), F(2)), "(1, [0.5, 1.5], 2)"),
        (vec3(F(1), F(0.5), F(2)), vec3(F(1), F(0.5), F(2)), "exact"),
    ],
)
def test_intervals_as_text(low, high, text):
    assert between((low, high)) == text


def test_a_stage_line_by_line(told):
    rows = rows_of(told, "back_point")
    assert [row.text for row in rows] == [
        "position_world",
        "light_position",
        "stored_distance",
        "shadow_valid",
        "direction = normalize(position_world - light_position)",
        "entry_point = select(shadow_valid, light_position + direction * stored_distance, position_world)",
        "thickness = length(position_world - entry_point)",
    ]
    assert [row.kind for row in rows] == ["read"] * 4 + ["line"] * 3
    assert [row.unit for row in rows[-3:]] == ["", "scene units, world space", "scene units along the light's ray"]
    thickness = told.result["thickness"][17, 16]
    assert rows[-1].value == str(thickness) and rows[-1].bits == f"{thickness.view(np.uint32):08x}"


def test_depth_opens_calls(told):
    normalized = [row.text for row in rows_of(told, "back_point", depth=2) if row.depth == 1]
    assert normalized[:2] == ["magnitude = length(v)", "select(magnitude > 0.0, v / magnitude, vec3(0.0, 0.0, 0.0))"]
    bare = rows_of(told, "phong_shading", depth=0)
    assert not any(row.kind == "call" for row in bare)
    assert any(row.kind == "call" for row in rows_of(told, "phong_shading"))


NORMALIZED = "select(magnitude > 0.0, v / magnitude, vec3(0.0, 0.0, 0.0))"
ENTRY = "select(shadow_valid, light_position + direction * stored_distance, position_world)"
OPENED = {  # stage -> the depth that a row needs, its indentation, kind and text
    "back_point": [
        (0, 0, "line", "direction = normalize(position_world - light_position)"),
        (2, 1, "line", "magnitude = length(v)"),
        (3, 2, "call", "sqrt(dot(v, v))"),
        (4, 3, "call", "a.x * b.x + a.y * b.y + a.z * b.z"),
        (2, 1, "call", NORMALIZED),
        (0, 0, "line", f"entry_point = {ENTRY}"),
        (0, 0, "line", "thickness = length(position_world - entry_point)"),
        (2, 1, "call", "sqrt(dot(v, v))"),
        (3, 2, "call", "dot(v, v)"),
        (4, 3, "call", "a.x * b.x + a.y * b.y + a.z * b.z"),
    ],
    "scatter": [
        (0, 1, "turn", "tap = 0"),
        (0, 2, "line", "total = total + tap_sample(lit, pixel, tap_offset[tap] * pixel_scale) * tap_weight[tap]"),
        (1, 3, "call", "tap_offset[tap]"),
        (1, 3, "call", "tap_sample(lit, pixel, tap_offset[tap] * pixel_scale)"),
        (2, 4, "call", "sample_bilinear(picture, pixel + whole_part(offset), fractional_part(offset))"),
        (3, 5, "call", "whole_part(offset)"),
        (3, 5, "call", "fractional_part(offset)"),
        (1, 3, "call", "tap_weight[tap]"),
        (0, 1, "turn", "tap = 1"),
    ],
}


@pytest.mark.parametrize("stage", OPENED)
@pytest.mark.parametrize("depth", range(4))
def test_each_depth_opens_the_calls_inside_those_of_the_one_before(told, stage, depth):
    rows = [(row.depth, row.kind, row.text) for row in rows_of(told, stage, depth) if row.kind != "read"]
    first = rows.index((1, "turn", "tap = 0")) if stage == "scatter" else 0
    last = rows.index((1, "turn", "tap = 1")) + 1 if stage == "scatter" else len(rows)
    assert rows[first:last] == [tuple(shown) for needed, *shown in OPENED[stage] if needed <= depth]


def test_a_draw_tells_how_much_each_corner_counts(told):
    (draw,) = [each for each in sections(told.passes) if each.title.startswith("triangle")][1:]
    weights = [corner.weight for corner in told.passes[1].drawn.corners]
    total = sum(map(float, weights))
    assert draw.level == 2 and draw.note == "rules R1 to R5"
    for row, weight, corner in zip(draw.rows, weights, told.passes[1].drawn.corners, strict=False):
        assert (row.kind, row.text, row.value) == ("read", f"weight of corner {corner.vertex}", str(weight))
        assert row.unit == f"{100 * float(weight) / total:.1f}% of the three"
    assert [(row.kind, row.text) for row in draw.rows[3:]] == [("line", name) for name in told.passes[1].drawn.values]


def test_a_stage_says_where_it_is_from_and_the_first_line_of_what_it_is(told):
    notes = {each.title: (each.level, each.note) for each in sections(told.passes)}
    assert notes["scatter"] == (2, "paper 3.2, Table 1. The weighted sum of all taps, in order.")
    assert notes["pass composite"] == (1, "pixel 16,17: the pixel itself")
    assert notes["surface"][1].endswith("its normal is made unit here, never before (rule R6).")


def test_every_line_as_glsl(told):
    (section,) = sections(told.passes, "back_point", glsl=True)
    assert [row.glsl for row in section.rows if row.kind == "line"] == [
        "precise vec3 direction = normalize_(position_world - light_position);",
        "precise vec3 entry_point = shadow_valid ? light_position + direction * stored_distance : position_world;",
        "precise float thickness = length_(position_world - entry_point);",
    ]
    (section,) = sections(told.passes, "scatter", glsl=True)
    assert "total = total + tap_sample(lit, pixel, tap_offset[tap] * pixel_scale) * tap_weight[tap];" in [
        row.glsl for row in section.rows
    ]
    assert not any(row.glsl for row in rows_of(told, "back_point"))


def test_every_tap_is_a_turn_with_its_weight_and_sample(told):
    rows = rows_of(told, "scatter")
    turns = [k for k, row in enumerate(rows) if re.fullmatch(r"tap = \d+", row.text)]
    assert len(turns) == 13
    assert [row.text for row in rows[turns[12] + 1 : turns[12] + 5]] == [
        "total = total + tap_sample(lit, pixel, tap_offset[tap] * pixel_scale) * tap_weight[tap]",
        "tap_offset[tap]",
        "tap_sample(lit, pixel, tap_offset[tap] * pixel_scale)",
        "tap_weight[tap]",
    ]
    assert rows[turns[12] + 4].value == "(0.0735, 0.0232, 0.0097)"


def test_uniforms_of_the_vertices_are_told_once(told):
    vertices = [section for section in sections(told.passes) if section.title.startswith("mesh_vertex at vertex")]
    assert len(vertices) == 6  # three of the shadow map's triangle, three of the camera's
    assert ["world_from_model" in [row.text for row in section.rows] for section in vertices] == [
        True,
        False,
        False,
    ] * 2
    assert all("position" in [row.text for row in section.rows] for section in vertices)


def test_matrices_are_told_row_by_row(told):
    rows = rows_of(told, "shadow_lookup_nearest")
    first = next(k for k, row in enumerate(rows) if row.text == "light_clip_from_world")
    assert [(row.text, row.depth) for row in rows[first + 1 : first + 5]] == [(f"row {k}", 1) for k in range(4)]


def test_a_stage_that_did_not_run(told):
    with pytest.raises(SceneError, match=r"stage: expected one of distance_to_light, .*, got 'lit_add'; none of that"):
        sections(told.passes, "lit_add")


def test_as_a_page(told):
    page = told._repr_html_()
    assert page.count("<details") == len([section for section in sections(told.passes) if section.level == 2])
    assert "may be" not in page and "may-be" not in page  # nobody asked
    assert "directly_lit = (facing &gt; 0.0) &amp; (behind &lt;= bias)" in page
    assert f"{told.result['thickness'][17, 16].view(np.uint32):08x}" in page


def test_in_the_terminal(capsys):
    assert main(["explain", "sphere", "--pixel", "20,30", "--stage", "back_point", "--size", "48x48", "--glsl"]) == 0
    printed = capsys.readouterr().out
    assert "thickness = length(position_world - entry_point)" in printed
    assert "scene units along the light's ray" in printed
    assert "precise float thickness = length_(position_world - entry_point);" in printed
    for wrong, message in (
        ("20", "--pixel: expected COLUMN,ROW, got '20'; write it as 256,300"),
        ("20,99", "pixel: expected column 0 to 47 and row 0 to 47, got 20,99; row 0 is at the bottom"),
    ):
        assert main(["explain", "sphere", "--pixel", wrong, "--size", "48x48"]) == 2
        assert message in capsys.readouterr().err.replace("\n", " ")
