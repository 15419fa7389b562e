import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import sss_ref
from sss_ref.cli import main
from sss_ref.cli.options import Changes, Execution
from sss_ref.errors import SceneError
from sss_ref.results import verify as verify_module
from sss_ref.results.manifest import read_manifest
from sss_ref.results.verify import Verification
from sss_ref.scene_file import shipped

TETRAHEDRON = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""

SCENE = """# A tetrahedron for tests.
[mesh]
path = "tetrahedron"
[camera]
type = "orbit"
distance = 3
width = 64
height = 64
[shadow_map]
width = 64
height = 64
[[lights]]
position = [2, 3, 4]
"""


@pytest.fixture(autouse=True)
def data_folder(tmp_path_factory, monkeypatch):
    """Stands in for the shipped data."""
    folder = tmp_path_factory.mktemp("data")
    (folder / "meshes").mkdir()
    (folder / "scenes").mkdir()
    (folder / "meshes" / "tetrahedron.obj").write_text(TETRAHEDRON)
    (folder / "scenes" / "default.toml").write_text(SCENE)
    (folder / "scenes" / "uncommented.toml").write_text(SCENE.partition("\n")[2])
    monkeypatch.setattr(shipped, "data_folder", lambda: folder)
    return folder


@pytest.fixture
def out(tmp_path):
    return tmp_path / "out"


def test_render_then_verify(out, capsys):
    assert main(["render", "-o", str(out)]) == 0
    told = capsys.readouterr().out
    manifest = read_manifest(out)
    assert manifest.scene.source == "default"
    assert [word for word in ("shadow_map", "camera", "blur", "composite") if f"│ {word} " in told] == list(
        manifest.milliseconds
    )
    for record in manifest.buffers:
        assert re.search(rf"│ {record.name} +│ {record.sha256[:12]} │", told)
    assert f"{out}: open overview.png first" in told
    assert main(["verify", str(out)]) == 0
    assert capsys.readouterr().out == "verified: 22 buffers equal in every bit\n"


def test_options_reach_scene_and_manifest(out):
    arguments = ["--set", "camera.distance=4", "--set", "mesh.path=tetrahedron", "default", "--preset", "robust"]
    arguments += ["--size", "24x16", "--interpreter", "arrays", "--threads", "1", "--method", "screen_space"]
    assert main(["render", *arguments, "-o", str(out), "--keep", "final"]) == 0
    manifest = read_manifest(out)
    settings = manifest.scene.settings
    assert (settings["camera"]["distance"], settings["preset"], settings["blur"]["mask"]) == (4.0, "robust", "taps")
    assert (settings["camera"]["width"], settings["camera"]["height"]) == (24, 16)
    assert (manifest.interpreter, manifest.threads) == ("arrays", 1)
    assert [record.name for record in manifest.buffers] == ["image"]


def test_until(out):
    assert main(["render", "-o", str(out), "--interpreter", "arrays", "--until", "surface"]) == 0
    names = [record.name for record in read_manifest(out).buffers]
    assert "uv" in names and "shadow_uv" not in names
    assert not (out / "image.png").exists()


def test_verify_tells_a_difference_by_its_exit_code(out, capsys, monkeypatch):
    monkeypatch.setattr(verify_module, "verify", lambda *_: Verification(False, "computation differs: [red]"))
    assert main(["verify", str(out)]) == 1
    assert capsys.readouterr().out == "computation differs: [red]\n"


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["render", "nowhere"], "nowhere: expected a scene file, a bundle or a shipped scene (default, uncommented)"),
        (["render", "--set", "camera.widht=3"], "override: camera.widht: expected a known key, got this one; did"),
        (["render", "--set", "camera.width"], "--set: expected key.path=value, got 'camera.width'; write it as"),
        (["render", "--set", "camera.width=" + "[" * 3000], "--set: expected one value for camera.width, got [[[[["),
        (["render", "--set", "camera.width=" + "9" * 5000], "--set: expected one value for camera.width, got 999"),
        (["render", "--set", "camera.width=8\nx=8"], "--set: expected one value for camera.width, got 8\\n"),
        (["render", "--size", "9" * 5000 + "x1"], "--size: expected WIDTHxHEIGHT, got '999"),
        (["render", "--set", "=3"], "--set: expected key.path=value, got '=3'"),
        (["render", "--set", "camera.width=abc"], 'override: camera.width: expected a whole number, got "abc"'),
        (["render", "--size", "512"], "--size: expected WIDTHxHEIGHT, got '512'; write it as 512x512"),
        (["render", "--size=-1x2"], "--size: expected WIDTHxHEIGHT, got '-1x2'"),
        (["render", "--size", "0x9"], "override: camera.width: expected"),
        (["render", "--threads", "0"], "--threads: expected at least 1, got 0"),
        (["render", "--until", "dawn"], "until: expected a pass, a stage or a buffer"),
        (["render", "--until", "lit", "--keep", "final"], "--until: expected without --keep final, got both"),
        (["render", "--samples", "0"], "samples: expected at least 1, got 0; 4 makes smooth edges"),
        (["render", "--samples", "2", "--until", "lit"], "--samples: expected without --until and --keep all"),
        (["render", "--samples", "2", "--keep", "all"], "--samples: expected without --until and --keep all"),
        (["render", "--preset", "nice"], 'preset: expected "paper", "robust" or "published", got "nice"'),
        (["render", "--keep", "most"], 'Invalid value "most" for --keep'),
        (["render", "--bogus"], 'Unknown option: --bogus'),
        (["paint"], 'Unknown command "paint"'),
        (["verify", "."], "manifest.json: expected a folder written by sss-ref render"),
        (["verify"], "requires an argument"),
        (["diff", ".", "."], ".: expected a result folder or a folder of buffers, got one without NPY files"),
        (["diff", ".", ".", "-o", "x.jpg"], "x.jpg: expected a file name ending in .png, got .jpg"),
        (["diff", ".", ".", "-o", "no/x.png"], "no/x.png: expected an existing folder, got no"),
        (["info", "nothing.obj"], "nothing.obj: expected a readable file, got No such file"),
        (["info", "nothing"], "nothing: expected a mesh file or a shipped mesh's name, got neither"),
        (["init", "nothing"], "nothing: expected a mesh file or a shipped mesh's name, got neither"),
        (["init", "tetrahedron", "-o", "head.obj"], "head.obj: expected a file name that ends in .toml, got .obj; add"),
    ],
)  # fmt: skip
def test_bad_input_is_told_in_one_message(out, capsys, monkeypatch, tmp_path, arguments, message):
    monkeypatch.chdir(tmp_path)
    assert main([*arguments, "-o", str(out)] if arguments[0] == "render" else arguments) == 2
    told = capsys.readouterr()
    assert message in " ".join(told.err.split()) and told.out == ""
    assert "Traceback" not in told.err
    assert os.listdir(tmp_path) == []


def test_foreign_folder_is_refused_before_anything_is_rendered(tmp_path, capsys, monkeypatch):
    (tmp_path / "letter.txt").write_text("dear")
    monkeypatch.setattr("sss_ref.scene.load.load_scene", lambda *_, **__: pytest.fail("loaded"))
    assert main(["render", "-o", str(tmp_path)]) == 2
    assert "got other files; move them" in capsys.readouterr().err
    assert os.listdir(tmp_path) == ["letter.txt"]


def test_file_in_the_way(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert main(["render", "-o", str(tmp_path / "file" / "out")]) == 2
    assert "expected a place to write to" in capsys.readouterr().err


def test_warnings_go_to_stderr(out, capsys):
    inside = ["--set", 'camera={type="look_at", eye=[0.1, 0.1, 0.1], target=[1, 1, 1], width=8, height=8}']
    assert main(["render", "-o", str(out), "--interpreter", "arrays", *inside]) == 0
    told = capsys.readouterr()
    assert told.err.startswith("warning: camera: it is inside the mesh") and "inside the mesh" not in told.out


def test_warnings_come_before_the_folder_is_written(out, monkeypatch, capsys):
    from sss_ref.results.saving import Saving

    told, finish = [], Saving.finish
    monkeypatch.setattr(Saving, "finish", lambda *given: told.append(capsys.readouterr().err) or finish(*given))
    small = [each for key in ("width=8", "height=8", "far=1.0") for each in ("--set", f"camera.{key}")]
    assert main(["render", "-o", str(out), "--interpreter", "arrays", *small]) == 0
    assert told[0].splitlines() == [
        "warning: camera: the whole mesh lies beyond far = 1, from 2 on; set camera.far = 3.3",
        "warning: camera: nothing of the mesh is drawn",
    ]


def test_scenes_are_listed_with_their_first_comment(capsys):
    assert main(["scenes"]) == 0
    lines = [line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines()]
    assert [list(map(str.strip, line)) for line in lines] == [["default", "A tetrahedron for tests."], ["uncommented"]]


def test_warmup_says_how_long_it_took(capsys, monkeypatch):
    from sss_ref.rendering import warming

    done = []
    monkeypatch.setattr(warming, "steps", lambda: iter(done.append(name) or name for name in ("one", "two")))
    assert main(["warmup"]) == 0
    assert done == ["one", "two"]
    assert re.match(r"kernels ready after \d+\.\d s, kept in .+\n", capsys.readouterr().out)


def test_cold_cache_is_announced(out, capsys, monkeypatch):
    for cold, told in ((True, "compiling kernels (once per version; about 7 s) ...\n"), (False, "")):
        monkeypatch.setattr("sss_ref.cache.compiled.is_cold", lambda cold=cold: cold)
        assert main(["render", "nowhere", "-o", str(out)]) == 2
        assert capsys.readouterr().err.partition("error:")[0] == told


def test_interrupt(monkeypatch, out):
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("sss_ref.scene.load.load_scene", interrupted)
    with pytest.raises(SystemExit) as exit_:
        main(["render", "-o", str(out)])
    assert exit_.value.code == 130


@pytest.mark.parametrize("module", ["sss_ref", "sss_ref.cli"])
def test_as_a_process(tmp_path, module):
    environment = {**os.environ, "PYTHONPATH": str(Path(sss_ref.__file__).parents[1])}
    command = [sys.executable, "-m", module, "render", "nowhere.toml", "-o", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 2 and done.stdout == ""
    assert "error: nowhere.toml: expected a scene file" in done.stderr and "Traceback" not in done.stderr


def test_help_and_import_load_no_heavy_library():
    code = "import sys; from sss_ref.cli import main; main(['--help']); print({'numba', 'trimesh'} & set(sys.modules))"
    environment = {**os.environ, "PYTHONPATH": str(Path(sss_ref.__file__).parents[1])}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=True)
    assert done.stdout.endswith("set()\n") and "warmup" in done.stdout


def test_samples_reach_the_manifest(out, capsys):
    small = ["--size", "8x8", "--interpreter", "arrays", "--threads", "1"]
    assert main(["render", "-o", str(out), "--samples", "2", *small]) == 0
    manifest = read_manifest(out)
    assert manifest.samples == 2 and [record.name for record in manifest.buffers] == ["image"]
    assert main(["verify", str(out)]) == 0
    assert capsys.readouterr().out.endswith("verified: 1 buffer equal in every bit\n")


@pytest.fixture
def pair(out, tmp_path):
    """Two folders of one buffer; B has another value at column 1, row 0."""
    image = np.arange(24, dtype=np.float32).reshape(2, 4, 3)
    folders = tmp_path / "a", tmp_path / "b"
    for folder in folders:
        folder.mkdir()
        np.save(folder / "image.npy", image)
        image = image.copy()
        image[0, 1, 2] = 8
    return folders


def test_diff_of_different_buffers(pair, capsys, tmp_path):
    assert main(["diff", *map(str, pair), "-o", str(tmp_path / "x.png")]) == 1
    told = capsys.readouterr().out
    assert re.search(r" image +1 of 8 +3 +23( +1)? *\n", told)
    first = "first difference: buffer image, first at pixel 1,0 (column,row; row 0 at the bottom): A 3.0 (0x40400000)"
    assert first in told and "5.0 (0x40a00000), B 3.0" in told
    assert (tmp_path / "x.png").is_file()


def test_diff_of_equal_buffers(pair, capsys, tmp_path):
    assert main(["diff", str(pair[0]), str(pair[0]), "-o", str(tmp_path / "x.png")]) == 0
    assert capsys.readouterr().out == "equal in every bit: image\n"
    assert not (tmp_path / "x.png").exists()


@pytest.mark.parametrize("differs, code", [(False, 2), (True, 1)])
def test_diff_names_what_one_folder_has_alone(pair, capsys, differs, code):
    a, b = pair[0], pair[differs]
    other = b.with_name("other")
    shutil.copytree(b, other)
    np.save(other / "depth.npy", np.zeros((2, 4), np.float32))
    assert main(["diff", str(a), str(other)]) == code
    assert capsys.readouterr().err == f"only in {other}: depth\n"
    assert main(["diff", str(other), str(a)]) == code
    assert capsys.readouterr().err == f"only in {other}: depth\n"


def test_info_of_a_file_and_of_a_shipped_mesh(data_folder, capsys):
    assert main(["info", "tetrahedron"]) == 0
    told = capsys.readouterr().out
    assert main(["info", str(data_folder / "meshes" / "tetrahedron.obj")]) == 0
    assert capsys.readouterr().out == told
    rows = dict(re.split(" {2,}", line.strip(), maxsplit=1) for line in told.splitlines())
    assert rows == {
        "mesh": "tetrahedron.obj",
        "triangles": "4",
        "vertices": "4",
        "bounds": "(0, 0, 0) to (1, 1, 1)",
        "size": "(1, 1, 1)",
        "mm_per_unit": "250 if the longest side is 250 mm; the scene has to say it",
        "d_min": "0.015, 1.5 % of the longest side; see sss-ref init",
        "normals": "computed, weighted by area",
        "watertight": "yes",
        "UVs": "none; for the texture-space method set mesh.unwrap = true",
    }


def test_info_as_json(data_folder, capsys):
    path = data_folder / "meshes" / "quad.obj"
    corners = "".join(f"v {x} {y} 0.5\nvt {x / 2} {y}\n" for x, y in ((0, 0), (3, 0), (3, 1), (0, 1)))
    path.write_text(corners + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
    assert main(["info", "quad", "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert (facts["low"], facts["high"], facts["size"]) == ([0, 0, 0.5], [3, 1, 0.5], [3, 1, 0])
    assert (facts["triangles"], facts["vertices"], facts["watertight"]) == (2, 4, False)
    assert (facts["mm_per_unit"], facts["d_min"]) == (83.3, 0.045)
    uv = {"shifted": 0, "mirrored": 0, "zero_area": 0, "out_of_range": 2, "seams": 0, "bounds": [0, 0, 1.5, 1]}
    assert facts["uv"] == uv
    assert main(["info", "quad"]) == 0
    told = capsys.readouterr().out
    assert re.search(r"UV bounds +\(0, 0\) to \(1.5, 1\)", told) and re.search(
        "UV outside 0..1 +2 vertices, 0 tri", told
    )


def test_init_writes_a_scene_that_renders_and_never_replaces_one_unasked(out, capsys, monkeypatch):
    out.mkdir()
    monkeypatch.chdir(out)
    assert main(["init", "tetrahedron"]) == 0
    assert capsys.readouterr().out == "scene.toml: sss-ref render scene.toml shows it\n"
    small = ["--size", "16x16", "--set", "shadow_map.width=16", "--set", "shadow_map.height=16"]
    assert main(["render", "scene.toml", "-o", "picture", "--interpreter", "arrays", *small]) == 0
    assert "set output.exposure = -0.1" in capsys.readouterr().err  # flat faces shine as a whole
    (out / "scene.toml").write_text("mine")
    assert main(["init", "tetrahedron"]) == 2
    assert capsys.readouterr().err == (
        "error: scene.toml: expected a new file, got one that is there; choose another with -o, or give --force\n"
    )
    assert (out / "scene.toml").read_text() == "mine"
    assert main(["init", "tetrahedron", "-o", "scene.toml", "--force"]) == 0
    assert "[[lights]]" in (out / "scene.toml").read_text()


def test_values_of_set_are_toml_or_text():
    changes = Changes(set=("a.b=1", "c=[1, 2.5]", "d=true", 'e="x"', "f=plain text", "g=h=i"))
    expected = {"a.b": 1, "c": [1, 2.5], "d": True, "e": "x", "f": "plain text", "g": "h=i"}
    assert changes.overrides() == expected


def test_set_wins_over_size():
    assert Changes(set=("camera.width=7",), size="3x4").overrides() == {"camera.width": 7, "camera.height": 4}


def test_threads_are_counted_from_one():
    assert Execution(threads=1).threads == 1
    with pytest.raises(SceneError):
        Execution(threads=-1)
