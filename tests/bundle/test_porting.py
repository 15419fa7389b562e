"""What PORTING.md says of a small scene, by hand."""

from dataclasses import replace

import pytest
from scenes import LIGHT, around, two_squares, written

from sss_ref.bundle.languages import LANGUAGES
from sss_ref.bundle.porting import guide
from sss_ref.scene.load import load_scene

PASSES = ["shadow_map", "irradiance_map", "irradiance_fill", "irradiance_blur", "camera"]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("squares") / "squares.obj", *two_squares())
    tables = {"method": "texture_space", "irradiance_map": {"width": 5, "height": 3}}
    return load_scene(around(path, 6, lights=[{"position": LIGHT}], **tables))


def test_the_guide_lists_the_passes_by_number(scene):
    lines = guide(scene, LANGUAGES["glsl"]).splitlines()
    numbered = [line for line in lines if line[:1].isdigit()]
    assert [line.split("`")[:2] for line in numbered] == [[f"{k}. ", name] for k, name in enumerate(PASSES, 1)]
    assert numbered[3] == "4. `irradiance_blur`, 5 x 3: `scatter`. Writes scattered_irradiance."


def test_passes_that_run_on_demand_alone_are_left_out(scene):
    screen = load_scene({**scene.settings.model_dump(), "method": "screen_space"})
    assert [each.name for each in screen.method.passes if each.on_demand] == ["taps"]
    numbered = [line.split("`")[:2] for line in guide(screen, LANGUAGES["glsl"]).splitlines() if line[:1].isdigit()]
    assert numbered == [["1. ", "shadow_map"], ["2. ", "camera"], ["3. ", "blur"], ["4. ", "composite"]]


def test_notes_of_the_guide_are_items_of_118_columns_whose_words_are_whole(scene):
    words = " ".join(["a" * 57, "b" * 58, "c-" * 30 + "c"])
    language = replace(LANGUAGES["glsl"], notes=(words, "x  \n y"))
    lines = guide(scene, language).splitlines()
    first = lines.index(f"- {'a' * 57} {'b' * 58}")
    assert len(lines[first]) == 118 and lines[first + 1 : first + 3] == ["  " + "c-" * 30 + "c", "- x y"]
    longer = replace(LANGUAGES["glsl"], notes=(f"{'a' * 57} {'b' * 59}", f"{'a' * 57} {'c-' * 40}c"))
    text = guide(scene, longer)
    assert f"- {'a' * 57}\n  {'b' * 59}\n" in text and f"- {'a' * 57}\n  {'c-' * 40}c\n" in text
