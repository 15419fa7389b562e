"""The faults that are drawn on OpenGL, in WGSL on lavapipe: the same stages are named, by another compiler."""

from functools import partial

import pytest
from edited import SHIPPED, blamed, drawn_edited, rendered
from faults import SCREEN_SPACE, TEXTURE_SPACE
from lavapipe import LAVAPIPE, needs_lavapipe
from wgsl_words import ONLY_OF, edits_in_wgsl

from sss_ref import webgpu
from sss_ref.cli import main
from sss_ref.interpret.shader import WGSL
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_lavapipe

QUICK = ("exponent 0.601", "taps swapped")
TABLES = {"screen": SCREEN_SPACE, "texture": TEXTURE_SPACE}


def cases():
    """Every fault of both tables; the long way in full."""
    for table, faults in TABLES.items():
        for name in faults:
            quick = table == "screen" and name in QUICK
            yield pytest.param(table, name, marks=() if quick else pytest.mark.full, id=f"{table}: {name}")


draw = partial(webgpu.draw, adapter=LAVAPIPE)


@pytest.mark.parametrize(("table", "name"), list(cases()))
def test_the_stage_with_the_fault_is_named(table, name, tmp_path):
    fault = TABLES[table][name]
    files = ONLY_OF.get(name, fault.files)
    drawing = drawn_edited(fault.scene, edits_in_wgsl(name, fault.edits), tmp_path, files, WGSL, draw)
    found = validate(rendered(fault.scene), drawing, profile="wgsl", explain=False)
    assert not found.passed and blamed(found.culprit) == [fault.at]


@pytest.mark.full
@pytest.mark.parametrize("scene", ["slabs", *SHIPPED])
def test_the_scenes_that_show_the_faults_pass_without_them(scene, tmp_path):
    found = validate(rendered(scene), drawn_edited(scene, {}, tmp_path, "", WGSL, draw), profile="wgsl", explain=False)
    assert found.passed, found.summary


SIZES = {f"{table}.{side}": 24 for table in ("camera", "shadow_map") for side in ("width", "height")}
COMMAND = [part for key, value in SIZES.items() for part in ("--set", f"{key}={value}")]


def test_ones_own_shaders_are_drawn_and_judged_on_the_command_line(tmp_path, capsys):
    """One file is the user's. Nothing is wrong before it: lavapipe takes the sum of two lights together, as it may."""
    assert main(["glsl", "--dialect", "wgsl", "--scene", "wax", "-o", str(tmp_path / "all"), *COMMAND]) == 0
    text, mine = (tmp_path / "all" / "composite.frag").read_text(), tmp_path / "mine"
    mine.mkdir()
    swapped = text.replace("textureLoad(scattered, pixel, 0).xyz", "textureLoad(scattered, pixel, 0).yxz")
    (mine / "composite.frag").write_text(swapped)
    assert main(["validate", "wax", str(mine), "--run-wgsl", *COMMAND, "--quick", "--interpreter", "arrays"]) == 1
    printed = capsys.readouterr().out
    assert "\nprofile wgsl, llvmpipe" in printed
    assert "of pass composite is the first that is wrong" in printed


def test_what_draws_is_one_of_two(capsys):
    assert main(["validate", "sphere", "--run-wgsl", "--run-glsl"]) == 2
    assert capsys.readouterr().err == (
        "error: validate: expected one of --run-glsl and --run-wgsl, got both; give one\n"
    )
