"""The page that judges, as text: what its script is given of a scene, without a browser that runs it."""

import json
import re

import pytest
from judging import small

from sss_ref.pictures.page_style import PAGE_STYLE
from sss_ref.webgl.judge_page import judge_page


@pytest.fixture(scope="module")
def scene():
    return small("wedge", 8)


@pytest.fixture(scope="module")
def page(scene):
    return judge_page(scene)


@pytest.fixture(scope="module")
def content(page):
    (text,) = re.findall(r'<script type="application/json"[^>]*>(.*?)</script>', page, re.DOTALL)
    return json.loads(text)


def test_every_stage_has_its_exam_after_the_draw_of_its_mesh(scene, content):
    """But those that are drawn on demand, or never."""
    expected = []
    for each in scene.method.passes:
        if not each.on_demand:
            expected += [(each.name, stage.name) for stage in each.draw.vertex_stages]
            expected += [(each.name, stage.name) for stage in each.stages if each.rounds]
    assert [(each["pass"], each["stage"]) for each in content["exams"]] == expected
    assert any(each.on_demand for each in scene.method.passes)


def test_all_names_of_shaders_are_known(scene, content):
    names = content["names"]
    assert {*scene.uniforms, *scene.method.values, "fragment_position", "fragment_normal"} <= {*names.values()}
    assert all(each in content["names"].values() for exam in content["exams"] for each in exam["given"])


def test_the_buffers_are_those_that_exams_name(content):
    named = {each for exam in content["exams"] for each in {**exam["given"], **exam.get("shown", {})}.values()}
    assert named <= {*content["buffers"]} and "camera/fragment_normal" in named
    assert {(each["width"], each["height"]) for each in content["buffers"].values()} == {(8, 8)}


def test_the_page_says_where_it_comes_from(scene, page, content):
    about = content["about"]
    assert (about["scene"], about["method"], about["subpixel_bits"]) == ("wedge", scene.method.name, 4)
    assert PAGE_STYLE in page and "<title>Is it right? wedge</title>" in page
