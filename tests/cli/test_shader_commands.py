"""What `sss-ref glsl`, `bundle`, `webgl`, `mapping` and `init` write and print; shaders have tests of their own."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from sss_ref.cli import main, shader_commands


def one_pass(name, vertex, stages):
    def named(names):
        return [SimpleNamespace(name=each) for each in names]

    return SimpleNamespace(name=name, draw=SimpleNamespace(vertex_stages=named(vertex)), stages=named(stages))


@pytest.fixture
def asked(monkeypatch):
    """Runs a command on a scene of two passes; the files that were written, and what was asked of the rooms below."""
    seen = []

    def load_scene(name, **overrides):
        passes = [one_pass("map", ["mesh"], ["depth"]), one_pass("camera", ["mesh"], ["uv", "lit", "uv"])]
        return SimpleNamespace(name=name, overrides=overrides, method=SimpleNamespace(passes=passes), uniforms="u")

    def shader_files(method, lengths, dialect, registers):
        seen.append((lengths, dialect, registers))
        return {"camera.frag": "a[i] = b;", "map.frag": "[bold]"}

    rooms = {
        "scene.load.load_scene": load_scene,
        "interpret.shader.DIALECTS": {name: name.upper() for name in ("glsl", "wgsl")},
        "interpret.shader.array_lengths": lambda uniforms, dialect: f"{uniforms} {dialect}",
        "interpret.shader.shader_files": shader_files,
        "interpret.shader.stage_source": lambda stage, lengths, dialect: (
            f"float[2] {stage.name}; // {lengths} {dialect}"
        ),
        "bundle.writing.write_bundle": lambda scene, folder, dialect: folder / dialect,
        "webgl.page": lambda scene: f"page of {scene.name} {scene.overrides}",
        "webgl.judge_page": lambda scene: f"judge of {scene.name} {scene.overrides}",
        "webgl.reduced": lambda scene, side: {"side": side},
    }
    for name, stand_in in rooms.items():
        monkeypatch.setattr(f"sss_ref.{name}", stand_in)
    monkeypatch.setattr(shader_commands, "write_texts", lambda folder, files, error: seen.append((folder, files)))

    def run(*words):
        seen.clear()
        return main([*words])

    run.seen = seen
    return run


FILES = {"camera.frag": "a[i] = b;", "map.frag": "[bold]"}
OUT = Path("out[bold]")
LISTED = "map: mesh, depth\ncamera: mesh, uv, lit\n"
PRINTED = "// camera.frag\na[i] = b;\n// map.frag\n[bold]\n"
LIT = "float[2] lit; // u GLSL GLSL\n"


@pytest.mark.parametrize(
    ("words", "printed", "seen"),
    [
        ((), LISTED, []),
        (("--all",), PRINTED, [("u GLSL", "GLSL", False)]),
        (("-o", str(OUT)), f"{OUT}: camera.frag, map.frag\n", [("u GLSL", "GLSL", False), (OUT, FILES)]),
        (("--all", "-o", str(OUT)), f"{OUT}: camera.frag, map.frag\n", [("u GLSL", "GLSL", False), (OUT, FILES)]),
        (("lit",), LIT, []),
        (("lit", "--all", "--registers"), PRINTED + LIT, [("u GLSL", "GLSL", True)]),
        (("mesh", "--dialect", "wgsl"), "float[2] mesh; // u WGSL WGSL\n", []),
    ],
)
def test_stages_and_shaders_are_listed_printed_or_written(words, printed, seen, asked, capsys):
    assert asked("glsl", *words) == 0
    assert capsys.readouterr().out == printed and asked.seen == seen


def test_a_stage_that_is_not_there_is_told(asked, capsys):
    assert asked("glsl", "light") == 2
    assert "stage: expected a stage of the scene (mesh, depth, uv, lit), got " in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "path", "text"),
    [
        ((), "webgl.html", "page of default {}"),
        (("--judge",), "judge.html", "judge of default {'side': 48}"),
        (("--judge", "--side", "16"), "judge.html", "judge of default {'side': 16}"),
        (("--judge", "--preset", "paper"), "judge.html", "judge of default {'preset': 'paper', 'side': 48}"),
        (("-o", "a[b]/c[d].html"), "a[b]/c[d].html", "page of default {}"),
    ],
)
def test_a_page_is_written_and_told(words, path, text, asked, capsys):
    assert asked("webgl", *words) == 0
    assert capsys.readouterr().out == f"{path}: open it in a browser\n"
    assert asked.seen == [(Path(path).parent, {Path(path).name: text})]


def test_a_side_is_for_judging(asked, capsys):
    assert asked("webgl", "--side", "16") == 2
    assert "--side: expected with --judge, got it alone" in capsys.readouterr().err and not asked.seen


def test_a_bundle_says_what_to_read_first(asked, capsys):
    assert asked("bundle", "-o", str(OUT), "--dialect", "wgsl") == 0
    assert capsys.readouterr().out == f"{OUT}/wgsl: read PORTING.md first\n"


def test_a_mapping_is_printed_with_its_tables(asked, capsys, monkeypatch):
    monkeypatch.setattr(
        "sss_ref.cli.mapping_command.mapping_template", lambda scene: f"# {scene.name}\n[buffers.lit]\nrows = [1]\n"
    )
    assert asked("mapping", "wedge") == 0
    assert capsys.readouterr().out == "# wedge\n[buffers.lit]\nrows = [1]\n"


def test_a_first_scene_says_how_to_see_it(monkeypatch, capsys):
    seen = []
    monkeypatch.setattr(
        "sss_ref.scene.first_scene.write_first_scene", lambda mesh, path, replace: seen.append((mesh, path, replace))
    )
    assert main(["init", "head.obj"]) == main(["init", "head.obj", "-o", "a[b].toml", "--force"]) == 0
    assert seen == [("head.obj", Path("scene.toml"), False), ("head.obj", Path("a[b].toml"), True)]
    assert capsys.readouterr().out == (
        "scene.toml: sss-ref render scene.toml shows it\na[b].toml: sss-ref render a[b].toml shows it\n"
    )
