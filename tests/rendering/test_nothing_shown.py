"""Notes on renderings that show nothing."""

import numpy as np
import pytest
from scenes import LIGHT, around, sphere, wall, written

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.shipped import scene_names


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    positions, triangles, _ = sphere(8)
    return around(written(tmp_path_factory.mktemp("bodies") / "ball.obj", positions, triangles), size=24)


def notes(scene, **overrides):
    return render(load_scene(scene, **overrides), interpreter="arrays", keep="final").notes


@pytest.mark.parametrize("name", scene_names())
def test_shipped_scenes_are_drawn_without_a_word(name):
    tables = ("camera", "shadow_map", "irradiance_map")
    found = load_scene(name, **{f"{table}.{side}": 192 for table in tables for side in ("width", "height")})
    assert found.warnings == () and render(found, keep="final").notes == ()


def test_what_is_seen_needs_no_note(scene):
    assert notes(scene) == ()
    assert notes(scene, **{"camera.width": 1, "camera.height": 1}) == ()


def test_empty_picture_whose_reason_the_scene_has_told(scene):
    assert notes(scene, **{"camera.far": 1.0}) == ("camera: nothing of the mesh is drawn",)


def test_empty_picture_between_the_pixels(tmp_path):
    """A needle of 0.02 in width passes between the middles of the pixels of a picture of two by two."""
    needle = np.array([(-0.01, -1, 0), (0.01, -1, 0), (0, 1, 0)]), np.array([(0, 1, 2)])
    scene = around(written(tmp_path / "needle.obj", *needle), size=2, shadow_map={"width": 999, "height": 999})
    scene["camera"] |= {"azimuth": 0, "elevation": 0}
    found = notes(scene)
    fov_y = np.degrees(2 * np.arcsin(1.05 * np.hypot(0.01, 1) / 4.5))
    assert found == (
        "camera: nothing of the mesh is drawn, no triangle is at the middle of a pixel; "
        f"set camera.fov_y = {fov_y:.3g} or move it",
    )


def test_black_on_black(scene):
    dark = {"phong.ambient": 0, "output.background": [0, 0, 0], "lights": [{"position": LIGHT, "intensity": 0}]}
    assert notes(scene, **dark) == (
        "image: every pixel looks the same, [0, 0, 0], so that nothing is seen of the mesh; "
        "set output.background = [0.5, 0.5, 0.5] or lights.0.intensity = 1",
    )
    assert notes(scene, **{**dark, "output.background": [0.5, 0.5, 0.5]}) == ()
    assert notes(scene, **{**dark, "blur.mask": "none"}) == (
        "image: every pixel looks the same, [0, 0, 0], so that nothing is seen of the mesh; set lights.0.intensity = 1",
    )


def test_white_on_white(scene):
    bright = {
        "phong.ambient": 1e6,
        "output.background": [1, 1, 1],
        "lights": [{"position": LIGHT, "intensity": 1e6}],
    }
    (line,) = notes(scene, **bright)
    assert line.startswith("image: every pixel looks the same, [1, 1, 1] to [")
    assert "set output.background = [0.0, 0.0, 0.0] or lights.0.intensity = " in line
    (line,) = notes(scene, **{**bright, "output.background": [0, 0, 0]})
    assert "are brighter than the picture can show" in line


def test_what_can_be_told_apart_is_no_surprise(tmp_path):
    """All but one part in 4000: the smallest step of a picture of 8 bits is one in 3295 at black."""
    scene = around(written(tmp_path / "wall.obj", *wall()), size=8)
    scene |= {
        "phong": {"ambient": 1, "diffuse": 0, "specular": 0},
        "lights": [{"position": [0, 3, 20], "intensity": 0}],
    }
    scene["camera"] |= {"distance": 60, "azimuth": 0}
    grey = {"mesh.color": [0.25] * 3, "translucency.combine": "transmit", "translucency.scale": 0, "preset": "robust"}
    grey |= {"blur.kernel": [[0, 0, 1, 1, 1]]}
    assert notes(scene, **grey, **{"output.background": [0.2501] * 3}) != ()
    assert notes(scene, **grey, **{"output.background": [0.2504] * 3}) == ()
