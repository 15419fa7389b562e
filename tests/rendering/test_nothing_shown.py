"""Notes on renderings that show nothing."""

import numpy as np
import pytest
from scenes import LIGHT, around, sphere, wall, written

from sss_ref.rendering.fold import render
from sss_ref.rendering.nothing_shown import hidden
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


def test_of_several_lights_it_is_the_one_whose_map_is_empty(tmp_path):
    """A needle between the pixels of maps of two by two, seen from 4.5 and from 9 away."""
    needle = np.array([(-0.01, -1, 0), (0.01, -1, 0), (0, 1, 0)]), np.array([(0, 1, 2)])
    lights = [{"position": [0, 0, 4.5], "fov_y": 60.0}, {"position": [0, 0, 9.0], "fov_y": 30.0}]
    scene = around(
        written(tmp_path / "needle.obj", *needle), size=64, shadow_map={"width": 2, "height": 2}, lights=lights
    )
    scene["camera"] |= {"azimuth": 0, "elevation": 0, "width": 65}
    asked = [np.degrees(2 * np.arcsin(1.05 * np.hypot(0.01, 1) / away)) for away in (4.5, 9)]
    assert notes(scene)[:2] == tuple(
        f"shadow_map_{number}: nothing of the mesh is drawn, no triangle is at the middle of a pixel; "
        f"set lights.{number - 1}.fov_y = {fov_y:.3g} or move it"
        for number, fov_y in enumerate(asked, start=1)
    )


def test_one_pixel_is_no_picture(scene):
    loaded = load_scene(scene)
    assert [*hidden(loaded, np.zeros((1, 1, 3), np.float32))] == []
    assert len([*hidden(loaded, np.zeros((1, 2, 3), np.float32))]) == 1


@pytest.mark.parametrize("place", [(0, 0), (3, 5), (18, 33), (19, 39)])
@pytest.mark.parametrize("channel", range(3))
def test_a_picture_is_looked_at_everywhere(scene, place, channel):
    image = np.full((20, 40, 3), 0.25, np.float32)
    assert len([*hidden(load_scene(scene), image)]) == 1
    image[(*place, channel)] += 0.01
    assert [*hidden(load_scene(scene), image)] == []
    image[...] = 5 + image
    (line,) = hidden(load_scene(scene), image)
    high = ["5.25"] * 3
    high[channel] = "5.26"
    assert line.startswith(f"image: every pixel looks the same, [5.25, 5.25, 5.25] to [{', '.join(high)}], so that")


@pytest.mark.parametrize(("grey", "other"), [(0.25, 0.5), (0.5, 0.0), (0.75, 0.0)])
def test_the_other_background_is_another(scene, grey, other):
    """And the strongest light, of two, is given the range of a picture: 3 for 4 times as bright."""
    lights = [{"position": LIGHT, "intensity": 2.0}, {"position": LIGHT, "intensity": 3.0}]
    loaded = load_scene(scene, **{"output.background": [grey, 0.1, 0.1], "lights": lights})
    (line,) = hidden(loaded, np.full((2, 2, 3), 4, np.float32))
    assert line.endswith(f"; set output.background = {[other] * 3} or lights.1.intensity = 0.75")
    (line,) = hidden(loaded, np.zeros((2, 2, 3), np.float32))
    assert line.endswith(f"; set output.background = {[other] * 3}")
