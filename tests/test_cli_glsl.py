import pytest

from sss_ref.cli import main
from sss_ref.interpret.shader import DIALECTS, array_lengths, shader_files, stage_source
from sss_ref.passes.phong import phong_shading
from sss_ref.passes.translucency import translucency_beer
from sss_ref.scene.load import load_scene
from sss_ref.webgl import judge_page, page, reduced


def test_a_stage_is_printed_with_what_it_uses(capsys):
    keys = ["translucency.form=beer", "translucency.combine=transmit", "shadow_map.test=slope"]
    assert main(["glsl", "translucency_beer", *(word for key in keys for word in ("--set", key))]) == 0
    assert capsys.readouterr().out == stage_source(translucency_beer, {}) + "\n"


@pytest.mark.parametrize("dialect", ["vulkan", "essl", "hlsl", "wgsl"])
def test_other_dialects(dialect, tmp_path, capsys):
    assert main(["glsl", "phong_shading", "--dialect", dialect, "-o", str(tmp_path)]) == 0
    loaded = load_scene("default")
    method, lengths = loaded.method, array_lengths(loaded.uniforms, DIALECTS[dialect])
    files = shader_files(method, lengths, DIALECTS[dialect])
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == files
    assert stage_source(phong_shading, lengths, DIALECTS[dialect]) in capsys.readouterr().out


def test_without_a_stage_passes_and_stages_are_listed(capsys):
    assert main(["glsl", "--scene", "wedge", "--method", "texture_space", "--preset", "paper"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "irradiance_blur: scatter" in lines
    assert lines[0] == "shadow_map: mesh_vertex, distance_to_light, uv_at_light"


def test_the_shaders_of_all_passes_are_written(tmp_path, capsys):
    assert main(["glsl", "--scene", "figure5", "-o", str(tmp_path / "new" / "folder")]) == 0
    scene = load_scene("figure5")
    files = shader_files(scene.method, array_lengths(scene.uniforms))
    assert {path.name: path.read_text() for path in (tmp_path / "new" / "folder").iterdir()} == files
    assert "irradiance_fill.frag, " in capsys.readouterr().out


def test_shaders_write_registers_if_asked(tmp_path, capsys):
    assert main(["glsl", "--scene", "figure4_wax", "--registers", "-o", str(tmp_path)]) == 0
    assert "out_exact_lit = exact_lit;" in "".join(path.read_text() for path in tmp_path.glob("camera_*.frag"))
    assert main(["glsl", "--scene", "figure4_wax", "--all"]) == 0
    printed = capsys.readouterr().out
    assert "exact_lit" in printed and "out_exact_lit" not in printed


def test_the_shaders_of_all_passes_are_printed(capsys):
    assert main(["glsl", "--scene", "wedge", "--all"]) == 0
    scene = load_scene("wedge")
    files = shader_files(scene.method, array_lengths(scene.uniforms))
    assert capsys.readouterr().out == "\n".join(f"// {name}\n{text}" for name, text in files.items()) + "\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["scatter"], "error: stage: expected a stage of the scene (mesh_vertex, "),
        (["--scene", "none"], "error: none: expected"),
        (["-o", "{file}"], "error: {file}: expected a folder to write into, got"),
    ],
)
def test_what_is_not_there_is_told(arguments, message, tmp_path, capsys):
    file = tmp_path / "file"
    file.write_text("")
    assert main(["glsl", *(argument.format(file=file) for argument in arguments)]) == 2
    assert capsys.readouterr().err.startswith(message.format(file=file))


def test_a_page_is_written(tmp_path, capsys):
    path = tmp_path / "new" / "page.html"
    assert main(["webgl", "wedge", "--size", "32x16", "-o", str(path)]) == 0
    assert path.read_text() == page(load_scene("wedge", **{"camera.width": 32, "camera.height": 16}))
    assert capsys.readouterr().out == f"{path}: open it in a browser\n"


def test_a_page_that_judges_is_written(tmp_path, capsys):
    path = tmp_path / "judge.html"
    assert main(["webgl", "wedge", "--judge", "--side", "16", "-o", str(path)]) == 0
    scene = load_scene("wedge", **reduced(load_scene("wedge"), 16))
    assert path.read_text() == judge_page(scene)
    assert capsys.readouterr().out == f"{path}: open it in a browser\n"


def test_pages_have_names_of_their_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["webgl", "wedge", "--size", "32x16"]) == main(["webgl", "wedge", "--judge", "--side", "16"]) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["judge.html", "webgl.html"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--side", "16"], "error: --side: expected with --judge, got it alone; give"),
        (["--judge", "--side", "3"], "error: side: expected 8 to 128 pixels, got 3; "),
    ],
)
def test_a_side_that_no_page_has_is_told(arguments, message, tmp_path, capsys):
    assert main(["webgl", "wedge", *arguments, "-o", str(tmp_path / "page.html")]) == 2
    assert capsys.readouterr().err.startswith(message)
