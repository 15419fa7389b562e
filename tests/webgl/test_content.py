"""The page without a browser: what it holds, and what it refuses."""

import base64
import json
import re
import subprocess

import numpy as np
import pytest
from scenes import around, wedge, written

from sss_ref import webgl
from sss_ref.errors import SceneError, ShaderError
from sss_ref.language.types import vec3, vec4
from sss_ref.scene.load import load_scene
from sss_ref.webgl import browser
from sss_ref.webgl.content import output, pass_settings, texture


def loaded(tmp_path, **tables):
    return load_scene(around(written(tmp_path / "wedge.obj", *wedge()), 32, **tables))


def content(page):
    """The scene that a page holds."""
    return json.loads(re.search(r'<script type="application/json" id="scene">(.*?)</script>', page, re.DOTALL)[1])


def array(text, dtype):
    return np.frombuffer(base64.b64decode(text), dtype)


def test_a_page_holds_the_mesh_the_uniforms_and_the_shaders_of_all_passes(tmp_path):
    scene = loaded(tmp_path)
    held = content(webgl.page(scene))
    mesh = held["meshes"]["mesh"]
    np.testing.assert_array_equal(array(mesh["triangles"], "<i4"), scene.mesh.triangles.ravel())
    np.testing.assert_array_equal(array(mesh["attributes"]["position"]["data"], "<f4"), scene.mesh.positions.ravel())
    assert held["uniforms"]["x"] == [float(scene.settings.translucency.x)]
    assert held["uniforms"]["light_clip_from_world"] == scene.uniforms["light_clip_from_world"].ravel().tolist()
    written_names = [o["name"] for one in held["passes"] for draw in one["draws"] for o in draw["outputs"]]
    assert written_names == held["kept"] == list(scene.method.outputs)
    assert all(len(draw["outputs"]) <= 4 for one in held["passes"] for draw in one["draws"])
    assert held["passes"][0]["draws"][0]["vertex"].startswith("#version 300 es")


def test_a_page_draws_only_what_is_kept(tmp_path):
    held = content(webgl.page(loaded(tmp_path), ["lit"]))
    assert held["kept"] == ["lit"]
    outputs = [[o["name"] for draw in one["draws"] for o in draw["outputs"]] for one in held["passes"]]
    assert outputs == [["light_triangle", "light_distance"], ["lit"]]


def test_a_page_draws_registers_on_demand(tmp_path):
    held = content(webgl.page(loaded(tmp_path, preset="published"), ["exact_lit", "lit"]))
    assert held["kept"] == ["exact_lit", "lit"]
    (draw,) = held["passes"][-1]["draws"]
    assert [output["name"] for output in draw["outputs"]] == ["exact_lit", "lit"]
    assert "out_exact_lit = exact_lit;" in draw["fragment"]


@pytest.mark.parametrize(
    ("kind", "clear", "expected"),
    [
        (float, 2.5, ("float", 1, [2.5, 2.5, 2.5, 2.5])),
        (int, -1, ("int", 1, [-1, -1, -1, -1])),
        (bool, 0, ("bool", 1, [0, 0, 0, 0])),
        (vec3, (1, 2, 3), ("float", 3, [1, 2, 3, 1])),
        (vec4, (1, 2, 3, 4), ("float", 4, [1, 2, 3, 4])),
    ],
)
def test_a_background_has_four_channels(kind, clear, expected):
    found = output("a", kind, clear)
    assert (found["name"], found["kind"], found["channels"], found["background"]) == ("a", *expected)


@pytest.mark.parametrize(("shape", "channels"), [((2, 5), 1), ((2, 5, 1), 1), ((2, 5, 3), 3), ((2, 5, 4), 4)])
def test_a_texture_says_its_size(shape, channels):
    found = texture(np.zeros(shape, np.float32), lambda data: data.shape)
    assert found == {"kind": "float", "channels": channels, "width": 5, "height": 2, "data": shape}


@pytest.mark.parametrize("overlap", ["last", "first"])
def test_the_later_of_two_triangles_wins_in_a_layout_that_says_so(overlap):
    scene = load_scene("lesson_seam", **{"irradiance_map.overlap": overlap})
    wins = {each.name: pass_settings(each, scene)["laterWins"] for each in scene.method.passes}
    assert wins == {name: name == "irradiance_map" and overlap == "last" for name in wins}
    assert "irradiance_map" in wins and "camera" in wins


def test_a_page_refuses_what_is_no_buffer(tmp_path):
    with pytest.raises(SceneError, match=r"^keep: expected .*names of buffers \(light_triangle, .*\), got 'lid'$"):
        webgl.page(loaded(tmp_path), ["lit", "lid"])


def test_a_name_cannot_leave_its_place(tmp_path):
    path = written(tmp_path / "a<b>&.obj", *wedge())
    page = webgl.page(load_scene(around(path, 32)))
    assert "<title>sss_ref: a&lt;b&gt;&amp;.obj</title>" in page
    assert page.count("</script>") == 2 and "<" not in re.search(r'id="scene">(.*?)</script>', page, re.DOTALL)[1]


def test_without_a_browser_its_names_are_told(tmp_path, monkeypatch):
    monkeypatch.setattr(browser.shutil, "which", lambda name: None)
    with pytest.raises(ShaderError, match=r"^webgl: expected one of chromium, .*, got none; install Chromium$"):
        webgl.draw(loaded(tmp_path))


@pytest.mark.parametrize(
    ("printed", "reason"),
    [('<p id="error">expected WebGL 2, got &lt;none&gt;</p>', "WebGL 2, got <none>"), ("", "a page without buffers")],
)
def test_a_page_that_is_not_drawn_says_why(tmp_path, monkeypatch, printed, reason):
    monkeypatch.setattr(browser.shutil, "which", lambda name: name)
    monkeypatch.setattr(browser.subprocess, "run", lambda *_, **__: subprocess.CompletedProcess([], 0, printed, ""))
    with pytest.raises(ShaderError, match=f"^webgl: expected every pass to be drawn, got .*{reason}$"):
        webgl.draw(loaded(tmp_path))


def test_a_browser_that_does_not_run_says_why(tmp_path, monkeypatch):
    def late(command, **_):
        raise subprocess.TimeoutExpired(command, 7)

    def failing(command, **_):
        return subprocess.CompletedProcess(command, 5, "", "No usable sandbox!")

    monkeypatch.setattr(browser.shutil, "which", lambda name: name)
    monkeypatch.setattr(browser.subprocess, "run", late)
    with pytest.raises(ShaderError, match=r"^webgl: expected a page drawn in 7 s, got none; draw a smaller picture$"):
        webgl.draw(loaded(tmp_path), seconds=7)
    monkeypatch.setattr(browser.subprocess, "run", failing)
    with pytest.raises(
        ShaderError, match=r"^webgl: expected chromium to run, got exit code 5: No usable sandbox!; try"
    ):
        webgl.draw(loaded(tmp_path))
