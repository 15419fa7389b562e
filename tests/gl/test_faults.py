"""Shaders with one fault each, drawn on a software OpenGL: the stage with the fault is named, and right ones pass."""

from dataclasses import replace
from pathlib import Path
from runpy import run_path

import pytest
from opengl import needs_mesa
from scenes import around, two_slabs, written

from sss_ref.cli import main
from sss_ref.gl import draw
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.methods.catalogue import method_of
from sss_ref.rendering import render
from sss_ref.scene.load import load_scene
from sss_ref.scene.uniforms import uniforms
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

FAULTS = {  # what a shader says -> what it should not say instead, and the stage that is then wrong
    "thickness from a depth": (
        "length(position_world - entry_point)",
        "(position_world - entry_point).z",
        "back_point",
    ),
    "no normalize": ("normalize(position_world - light_position)", "(position_world - light_position)", "back_point"),
    "multiply for divide": ("pow(x, y) / pow(", "pow(x, y) * pow(", "translucency_ratio"),
    "no half texel": ("map_size.x) - 0.5", "map_size.x)", "shadow_lookup_bilinear"),
    "facing away": ("facing > 0.0", "facing < 0.0", "directly_lit_slope"),
    "light without colour": ("light_color * light_intensity", "vec3(light_intensity)", "light_constant"),
    "reflected the wrong way": ("reflect(-to_light", "reflect(to_light", "phong_shading"),
    "taps swapped": ("tap_offset[tap] * pixel_scale", "tap_offset[tap].yx * pixel_scale", "scatter"),
    "sRGB write": ("out_image = image;", "out_image = pow(image, vec3(0.4545));", "over_background"),
    "normal as it is": ("normalize(fragment_normal)", "fragment_normal", "surface"),
}


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("bodies") / "slabs.obj", *two_slabs(), flat=True)
    lights = [{"position": [2.0, 1.5, 2.5], "color": [1.0, 0.5, 0.25]}]
    filtered = {"width": 96, "height": 96, "filter": "bilinear"}
    camera = {"type": "orbit", "distance": 4.5, "azimuth": 100, "elevation": 12, "fov_y": 40, "width": 96, "height": 96}
    return load_scene(
        around(path, 96, lights=lights, shadow_map=filtered, camera=camera, mesh={"path": path, "scale": 1.1})
    )


@pytest.fixture(scope="module")
def oracle(scene):
    return render(scene, interpreter="arrays")


def verdict_on(scene, oracle, shaders):
    return validate(oracle, draw(scene, shaders))


def changed(scene, folder, old, new):
    """Files of all passes in which the shaders say something else."""
    files = shader_files(method_of(scene.settings), array_lengths(uniforms(scene)))
    found = {}
    for name, text in files.items():
        if old in text and not name.startswith("taps"):
            one = name.split(".")[0].rstrip("_0123456789")
            (folder / name).write_text(text.replace(old, new))
            found.setdefault(one, []).append(folder / name)
    return found


@pytest.mark.parametrize("fault", FAULTS)
def test_the_stage_with_the_fault_is_named(scene, oracle, tmp_path, fault):
    old, new, stage = FAULTS[fault]
    files = changed(scene, tmp_path, old, new)
    assert files, "the shaders no longer say so"
    everything = {one: [tmp_path / name for name in all_files(scene, tmp_path, one)] for one in files}
    found = verdict_on(scene, oracle, everything)
    assert not found.passed and found.culprit.stage == stage


def all_files(scene, folder, one):
    """The shaders of a pass: those that were changed, and the others as they are."""
    files = shader_files(method_of(scene.settings), array_lengths(uniforms(scene)))
    for name, text in files.items():
        if name.split(".")[0].rstrip("_0123456789") == one:
            if not (folder / name).exists():
                (folder / name).write_text(text)
            yield name


@pytest.mark.parametrize("name", ["wedge", "sphere", "figure3_with", "figure5", "figure4_wax", "teaching"])
def test_our_own_shaders_pass(name):
    small = {f"{t}.{s}": 96 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
    loaded = load_scene(name, **small)
    found = verdict_on(loaded, render(loaded, interpreter="arrays"), None)
    assert found.passed, found.summary
    assert not found.missing


def test_a_stage_of_ones_own_is_drawn_and_judged_like_ours():
    example = Path(__file__).parents[2] / "examples" / "beer_lambert.py"
    scene = run_path(str(example))["scene"]
    changes = {f"{t}.{s}": 64 for t in ("camera", "shadow_map") for s in ("width", "height")}
    loaded = load_scene("figure3_with", **changes)
    small = replace(loaded, own_stages=scene.own_stages, own_uniforms=scene.own_uniforms)
    found = verdict_on(small, render(small, interpreter="arrays"), None)
    assert found.passed and "transmittance" in {one.buffer for one in found.verdicts}


def test_on_the_command_line(tmp_path, capsys):
    small = [
        "--size",
        "64x64",
        "--set",
        "shadow_map.width=64",
        "--set",
        "shadow_map.height=64",
        "--interpreter",
        "arrays",
    ]
    assert main(["validate", "sphere", "--run-glsl", *small]) == 0
    assert "every stage gives what it should" in capsys.readouterr().out
    assert main(["glsl", "--scene", "sphere", "-o", str(tmp_path), *small[:-2]]) == 0
    for path in tmp_path.glob("*.frag"):
        path.write_text(path.read_text().replace("pow(x, y) / pow(", "pow(x, y) * pow("))
    for path in tmp_path.glob("taps*"):
        path.unlink()
    assert main(["validate", "sphere", str(tmp_path), "--run-glsl", *small]) == 1
    assert "stage translucency_ratio of pass camera is the first that is wrong" in capsys.readouterr().out
    (tmp_path / "blurr.frag").write_text("")
    assert main(["validate", "sphere", str(tmp_path), "--run-glsl", *small]) == 2
    assert "expected the name of a pass (shadow_map, camera, blur, composite), got blurr" in capsys.readouterr().err
    assert main(["validate", "sphere", str(tmp_path / "none"), "--run-glsl", *small]) == 2
    assert "expected files NAME.frag or NAME.vert" in capsys.readouterr().err
