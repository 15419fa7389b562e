"""The page in a Chromium without a GPU: right shaders pass, wrong ones are named, as `validate` does."""

import json

import numpy as np
import pytest
from judging import JudgePage, small, software_chromium
from viewing import needs_page

from sss_ref.errors import SceneError
from sss_ref.rendering.fold import render
from sss_ref.scene import scene_names
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import checks_of
from sss_ref.validation.verdict.outcomes import FAIL, outcome_map
from sss_ref.webgl import judge_page, reduced
from sss_ref.webgl.exams import WEBGL, every_value

pytestmark = needs_page
QUICK = ["lesson_seam"]
TECHNIQUES = ["separable", "burley", "preintegrated", "gaussian_texture"]
PLANTED = 25
SCENE = small("teaching", 48)
EDITS = [  # of a vertex stage, as readers make them
    (
        "camera/mesh_vertex",
        "transform(clip_from_model, model)",
        "transform(clip_from_model, vec4(normal, 1.0))",
        "triangle",
    ),
    ("camera/mesh_vertex", "transform(normal_from_model, normal)", "normal", "fragment_normal"),
    (
        "camera/mesh_vertex",
        "transform(clip_from_model, model)",
        "transform(clip_from_model, vec4(position * 1.1, 1.0))",
        "triangle",
    ),
    ("camera/mesh_vertex", "world.xyz", "position", "fragment_position"),
    (
        "shadow_map/mesh_vertex",
        "gl_Position = vertex.clip_position;",
        "gl_Position = vertex.clip_position.yxzw;",
        "triangle",
    ),
]


@pytest.fixture(scope="module")
def browser():
    with software_chromium() as found:
        yield found


@pytest.fixture(scope="module")
def opened(browser, tmp_path_factory):
    yield JudgePage(browser, tmp_path_factory.mktemp("judge"), SCENE)


@pytest.fixture
def page(opened):
    yield opened
    opened.restore()
    assert opened.verdict.startswith("All "), opened.verdict
    assert opened.errors == []


def test_all_stages_are_right_and_the_page_is_small(page, tmp_path):
    report = page.report
    assert report["passed"] and report["first_wrong"] is None
    assert {stage["state"] for stage in report["stages"]} == {"passed"}
    written = {buffer["name"] for stage in report["stages"] for buffer in stage["buffers"]}
    stages = {
        name for each in SCENE.method.passes if not each.on_demand for s in each.stages for name in s.writes.values()
    }
    assert written >= stages | {"triangle", "depth", "fragment_position", "fragment_normal"}
    assert len(judge_page(SCENE)) < 1e6


@pytest.mark.parametrize(
    "name", [*QUICK, *(pytest.param(each, marks=pytest.mark.full) for each in scene_names() if each not in QUICK)]
)
def test_no_stage_of_a_shipped_scene_is_wrong(browser, tmp_path, name):
    page = JudgePage(browser, tmp_path, small(name))
    assert page.report["passed"], page.verdict
    assert page.errors == []


@pytest.mark.full
@pytest.mark.parametrize("method", TECHNIQUES)
def test_no_stage_of_a_technique_is_wrong(browser, tmp_path, method):
    page = JudgePage(browser, tmp_path, small("figure3_with", method=method))
    assert page.report["passed"], page.verdict


def test_every_planted_mistake_is_named(page):
    """As a reader plants them: the stage that has the mistake is the first wrong one, and the only one."""
    script = """() => judge.mistakes.map((_, index) => {
        judge.plant(index);
        const planted = judge.exams[judge.chosen].name;
        judge.drawChosen();
        const { first_wrong, stages } = judge.report();
        judge.restore([judge.chosen]);
        return [planted, first_wrong, stages.filter(({ state }) => state !== "passed").length];
    })"""
    found = page.run(script)
    assert len(found) >= PLANTED
    assert [(first, count) for _, first, count in found] == [(planted, 1) for planted, _, _ in found]


@pytest.mark.parametrize(("name", "before", "after", "buffer"), EDITS)
def test_a_wrong_vertex_stage_is_named(page, name, before, after, buffer):
    number = page.edit(name, before, after)
    assert f"The first wrong stage is {name}." in page.verdict
    assert page.drawn(number)[buffer][1].any()
    assert page.report["first_wrong"] == name


def test_what_is_wrong_in_the_page_is_wrong_for_validate(page):
    """The drawn buffers of a stage with a mistake, beside the reference's: the same pixels are out of reach.

    Where a stage reads what is interpolated, the page knows its exact value, so that it may see more.
    """
    oracle = render(SCENE, "arrays", keep=every_value(SCENE))
    edits = [
        ("camera/back_point", "position_world - entry_point", "position_world - entry_point * 0.999"),
        ("camera/back_point", "position_world - entry_point", "(position_world - entry_point) * 1.000001"),
        ("camera/light_constant", "light_color * light_intensity", "light_color / light_intensity"),
        ("camera/phong_shading", "* mirror) * albedo", "* mirror) * albedo * 0.99"),
        ("composite/over_background", "scattered :", "scattered * 1.0001 :"),
        ("camera/surface", "fragment_position", "fragment_position * 1.001"),
    ]
    seen = 0
    for name, before, after in edits:
        number = page.edit(name, before, after)
        wrong = of_validate(oracle, name, {own: values for own, (values, _) in page.drawn(number).items()})
        for own, (_, of_page) in page.drawn(number).items():
            exact = name != "camera/surface"
            assert np.array_equal(wrong[own], of_page) if exact else not (wrong[own] & ~of_page).any(), (name, own)
            seen += wrong[own].sum()
        page.restore()
    assert seen > 1000


def of_validate(oracle, name, drawn):
    """Bool (H, W) by buffer: what the validator finds wrong in one stage, all else being the reference's."""
    pass_name, stage = name.split("/")
    case = Case(oracle, Drawing({**oracle.buffers, **drawn}), WEBGL)
    checks = [check for check in checks_of(case, SCENE.method[pass_name]) if check.stage == stage]
    return {check.buffer: outcome_map(check) == FAIL for check in checks}


def test_a_refused_shader_is_told_with_its_line(page):
    page.edit("camera/back_point", "vec3 direction =", "vec3 direction = unknown_thing +")
    assert "refuses the shader of camera/back_point" in page.verdict
    line = int(page.page.inner_text("#gutter .bad"))
    assert "unknown_thing" in page.page.input_value("#source").splitlines()[line - 1]
    assert page.page.inner_text("#refused") == f"line {line}: 'unknown_thing' : undeclared identifier"
    (stage,) = (one for one in page.report["stages"] if one["state"] == "refused")
    assert stage["refused"][0]["line"] == line and stage["changed"]


def test_a_pixel_shows_what_it_reads_and_what_is_right(page):
    page.edit("camera/back_point", "position_world - entry_point", "position_world + entry_point")
    shown = page.page.inner_text("#pixel")
    name, drawn, right, reference = page.page.inner_text("#pixel tr.wrong").split("\t")
    assert name == "thickness" and float(drawn) > float(reference) and right.startswith(reference[:4])
    assert "light_position" in shown and "stored_distance" in shown
    before = page.page.inner_text("#pixel caption >> nth=0")
    page.page.click("#pictures canvas >> nth=2", position={"x": 5, "y": 5})
    assert page.page.inner_text("#pixel caption >> nth=0") != before


def test_the_verdict_is_copied_as_json(page):
    page.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.page.click("#copy")
    page.page.wait_for_function("document.getElementById('told').textContent !== ''")
    report = json.loads(page.run("() => navigator.clipboard.readText()"))
    assert report == page.report
    assert (report["format"], report["format_version"]) == ("sss_ref verdict of a page", 1)
    assert "SwiftShader" in report["device"]["renderer"] and "Chrome" in report["browser"]
    assert report["scene"] == "teaching" and report["rules"] >= 2


def test_a_narrow_page_is_not_wider_than_its_window(browser, tmp_path):
    page = JudgePage(browser, tmp_path, small("wedge", 16), width=390)
    assert page.run("() => document.documentElement.scrollWidth") <= 390
    assert page.report["passed"]


def test_a_larger_picture_is_refused():
    with pytest.raises(SceneError, match=r"^shadow_map: expected at most 128 x 128 pixels, got 2048 x 2048; load"):
        judge_page(load_scene("teaching"))


@pytest.mark.parametrize("side", [7, 129])
def test_no_page_has_pictures_of_such_a_side(side):
    with pytest.raises(SceneError, match=f"^side: expected 8 to 128 pixels, got {side}; "):
        reduced(SCENE, side)


def test_the_longer_side_counts():
    found = reduced(load_scene("figure4_wax"), 48)
    assert (
        found == {name: found[name] for name in found} and found["camera.width"] == 48 and found["camera.height"] == 27
    )
