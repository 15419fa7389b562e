"""The page about CI, done: a small project with a shader, its test run by pytest in a process and folder of its own."""

import os
import re
import subprocess
import sys
import tomllib
from importlib import import_module
from importlib.metadata import entry_points
from pathlib import Path

import pytest
from opengl import needs_mesa

import sss_ref
from sss_ref.interpret.shader import array_lengths, shader_files

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "how_to" / "ci.md").read_text()
PLUGIN = "sss_ref.pytest_plugin"


def is_installed():
    return any(each.value == PLUGIN for each in entry_points(group="pytest11"))


def test_the_entry_point_names_the_plugin():
    points = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["entry-points"]["pytest11"]
    assert points == {"sss_ref": PLUGIN}
    assert hasattr(import_module(PLUGIN), "sss_ref_oracle")


def run_pytest(folder, *words):
    """pytest as the page sets it up; where the package is on the path only, nothing registers its plugin."""
    plugin = [] if is_installed() else ["-p", PLUGIN]
    settings = dict(re.findall(r"(\w+)=(\w+)", re.search(r"^export (.*)$", PAGE, re.MULTILINE)[1]))
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *plugin, *words]
    return subprocess.run(command, cwd=folder, env=os.environ | settings, capture_output=True, text=True, check=False)


@pytest.fixture
def project(tmp_path):
    """The page's test, and our blur as the project's."""
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "test_shaders.py").write_text(code)
    (tmp_path / "shaders").mkdir()
    scene = sss_ref.load_scene("figure3_with")
    files = shader_files(scene.method, array_lengths(scene.uniforms))
    (tmp_path / "shaders" / "blur.frag").write_text(files["blur.frag"])
    return tmp_path


@needs_mesa
def test_a_right_shader_passes(project):
    done = run_pytest(project)
    assert done.returncode == 0 and "1 passed" in done.stdout, done.stdout


@needs_mesa
def test_a_wrong_shader_fails_with_the_stage_and_the_cause(project):
    shader = project / "shaders" / "blur.frag"
    right = shader.read_text()
    shader.write_text(re.sub(r"\btap_count\b(?=; )", "tap_count - 1", right))
    assert shader.read_text() != right
    done = run_pytest(project)
    assert done.returncode == 1 and "1 failed" in done.stdout
    assert re.search(r"^E +AssertionError: fail: stage scatter_inside_surface of pass blur is", done.stdout, re.M)
    assert re.search(r"^E +first at pixel \d+,\d+ ", done.stdout, re.M)
    assert "stage_by_stage.py" not in done.stdout  # the test's own line is shown, and none of ours


ONCE = """
import sss_ref

SMALL = {"camera.width": 32, "camera.height": 32, "shadow_map.width": 32, "shadow_map.height": 32}


def test_one(sss_ref_oracle):
    first = sss_ref_oracle("wedge", **SMALL)
    assert first is sss_ref_oracle("wedge", **dict(reversed(SMALL.items())))
    assert first is not sss_ref_oracle("wedge", **SMALL, **{"translucency.exponent": 0.7})
    sss_ref_oracle.first = first


def test_two(sss_ref_oracle, tmp_path):
    assert sss_ref_oracle("wedge", **SMALL) is sss_ref_oracle.first
    sss_ref.assert_valid(sss_ref_oracle.first, sss_ref_oracle.first.save(tmp_path / "out"), profile="ieee")


def test_three(sss_ref_oracle):
    sss_ref_oracle("nowhere")
"""


def test_a_scene_is_rendered_once_a_session_and_folders_are_read(tmp_path):
    (tmp_path / "test_once.py").write_text(ONCE)
    done = run_pytest(tmp_path)
    assert "2 passed" in done.stdout and "1 failed" in done.stdout, done.stdout
    assert "SceneError: nowhere: expected a scene file, a bundle or a shipped scene" in done.stdout


def test_pytest_lists_the_fixture_and_loads_nothing_heavy_for_it(tmp_path):
    (tmp_path / "test_none.py").write_text("import sys\n\ndef test_light():\n    assert 'numba' not in sys.modules\n")
    done = run_pytest(tmp_path)
    assert done.returncode == 0, done.stdout
    assert "sss_ref_oracle [session scope]" in run_pytest(tmp_path, "--fixtures").stdout
