"""Shaders with one fault each, drawn on a software OpenGL: the stage with the fault is named, and right ones pass."""

from dataclasses import replace
from pathlib import Path
from runpy import run_path

import pytest
from edited import SHIPPED, blamed, drawn, judged, rendered
from faults import SCREEN_SPACE as FAULTS
from opengl import needs_mesa

from sss_ref.cli import main
from sss_ref.gl import draw
from sss_ref.rendering.fold import render
from sss_ref.scene import scene_names
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa


@pytest.mark.parametrize("fault", FAULTS)
def test_the_stage_with_the_fault_is_named(fault, tmp_path):
    found = judged(FAULTS[fault], tmp_path)
    assert not found.passed and blamed(found.culprit) == [FAULTS[fault].at]


@pytest.mark.parametrize("scene", ["slabs", *SHIPPED])
def test_the_scenes_that_show_the_faults_pass_without_them(scene):
    found = validate(rendered(scene), drawn(scene), explain=False)
    assert found.passed, found.summary


@pytest.mark.parametrize("name", scene_names())
def test_our_own_shaders_pass(name):
    small = {f"{t}.{s}": 96 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
    loaded = load_scene(name, **small)
    found = validate(render(loaded, interpreter="arrays"), draw(loaded))
    assert found.passed, found.summary
    assert not found.missing


def test_a_stage_of_ones_own_is_drawn_and_judged_like_ours():
    example = Path(__file__).parents[2] / "examples" / "beer_lambert.py"
    scene = run_path(str(example))["scene"]
    changes = {f"{t}.{s}": 64 for t in ("camera", "shadow_map") for s in ("width", "height")}
    loaded = load_scene("figure3_with", **changes, **{"translucency.combine": "transmit", "shadow_map.test": "slope"})
    small = replace(loaded, own_stages=scene.own_stages, own_uniforms=scene.own_uniforms)
    found = validate(render(small, interpreter="arrays"), draw(small))
    assert found.passed and "transmittance" in {one.buffer for one in found.verdicts}


COMMAND = [
    "--size",
    "64x64",
    "--set",
    "shadow_map.width=64",
    "--set",
    "shadow_map.height=64",
    "--interpreter",
    "arrays",
]


@pytest.mark.parametrize("registers", [["--registers"], []])
def test_shaders_that_write_registers_name_the_stage_for_certain(registers, tmp_path, capsys):
    assert main(["glsl", "--scene", "figure4_wax", "-o", str(tmp_path), *registers, *COMMAND[:-2]]) == 0
    for path in tmp_path.glob("*.frag"):
        path.write_text(path.read_text().replace("lit = phong + albedo", "lit = phong * albedo"))
    assert main(["validate", "figure4_wax", str(tmp_path), "--run-glsl", *COMMAND]) == 1
    certain, doubtful = "stage lit_add of pass camera is", "stage stored_rgb8 of pass camera, or one before it whose "
    assert (certain if registers else f"{doubtful}output was not given (camera/lit_add), is") in capsys.readouterr().out


def test_on_the_command_line(tmp_path, capsys):
    small = COMMAND
    assert main(["validate", "sphere", "--run-glsl", *small]) == 0
    assert "every stage gives what it should" in capsys.readouterr().out
    assert main(["glsl", "--scene", "sphere", "-o", str(tmp_path), *small[:-2]]) == 0
    for path in tmp_path.glob("*.frag"):
        path.write_text(path.read_text().replace("pow(x, y) / pow(", "pow(x, y) * pow("))
    assert main(["validate", "sphere", str(tmp_path), "--run-glsl", *small]) == 1
    assert "stage translucency_ratio_throughout of pass camera is the first that is wrong" in capsys.readouterr().out
    (tmp_path / "blurr.frag").write_text("")
    assert main(["validate", "sphere", str(tmp_path), "--run-glsl", *small]) == 2
    assert "expected the name of a pass (shadow_map, camera, blur, composite), got blurr" in capsys.readouterr().err
    assert main(["validate", "sphere", str(tmp_path / "none"), "--run-glsl", *small]) == 2
    assert "expected files NAME.frag or NAME.vert" in capsys.readouterr().err


def test_a_vertex_shader_alone_on_the_command_line(tmp_path, capsys):
    """Normals taken for positions: nothing but the stage of the vertices is in doubt."""
    assert main(["glsl", "--scene", "sphere", "-o", str(tmp_path / "all"), *COMMAND[:-2]]) == 0
    text = (tmp_path / "all" / "camera.vert").read_text()
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "camera.vert").write_text(text)
    assert main(["validate", "sphere", str(tmp_path / "mine"), "--run-glsl", *COMMAND]) == 0
    wrong = text.replace("transform(normal_from_model, normal)", "transform(normal_from_model, normal.yxz)")
    (tmp_path / "mine" / "camera.vert").write_text(wrong)
    assert main(["validate", "sphere", str(tmp_path / "mine"), "--run-glsl", *COMMAND]) == 1
    assert "camera/mesh_vertex" in capsys.readouterr().out
