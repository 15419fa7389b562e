"""Whole scenes under a normal map and a specular map: which buffers there are, and what each of them changes."""

import numpy as np
import pytest
from detailed import bumpy
from PIL import Image
from scenes import sphere, written

from sss_ref.errors import SceneError
from sss_ref.rendering.fold import render
from sss_ref.scene import load_scene

SMALL_MAP = {"irradiance_map": {"width": 32, "height": 32}}


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
def test_interpreters_agree(tmp_path, method):
    scene = load_scene(bumpy(tmp_path, method=method, preset="robust", **SMALL_MAP))
    keep = ["all", "registers"]
    kernel, arrays = (render(scene, interpreter, threads=1, keep=keep) for interpreter in ("kernel", "arrays"))
    assert kernel.hashes == arrays.hashes
    assert {"unmapped_normal_world", "mapped_specular"} <= set(scene.method.outputs)
    bent = np.abs(arrays["normal_world"] - arrays["unmapped_normal_world"]).max(axis=-1)
    assert (bent[arrays["coverage"] == 1] > 0.01).mean() > 0.9


def test_light_falls_on_the_bent_normal_but_reaches_the_surface(tmp_path):
    """The shadow test is that of the mesh without a map; what is reflected is not."""
    flat = render(load_scene(bumpy(tmp_path), **{"mesh.normal_map": None}), "arrays")
    bent = render(load_scene(bumpy(tmp_path)), "arrays")
    for name in ("directly_lit", "thickness", "position_world"):
        assert flat[name].tobytes() == bent[name].tobytes()
    assert flat["normal_world"].tobytes() == bent["unmapped_normal_world"].tobytes()
    assert np.abs(flat["phong"] - bent["phong"]).max() > 0.05


def test_no_strength_is_no_map(tmp_path):
    """Of bent normals nothing is left but the rounding of a vector made unit twice."""
    result = render(load_scene(bumpy(tmp_path), **{"mesh.normal_strength": 0.0}), "arrays")
    assert np.abs(result["normal_world"] - result["unmapped_normal_world"]).max() < 2e-7


def test_green_down_is_green_up_of_the_turned_picture(tmp_path):
    scene = bumpy(tmp_path)
    up = render(load_scene(scene), "arrays")
    codes = np.asarray(Image.open(tmp_path / "bumps.png")).copy()
    codes[..., 1] = 255 - codes[..., 1]
    Image.fromarray(codes).save(tmp_path / "bumps.png")
    down = render(load_scene(scene, **{"mesh.normal_map_green": "down"}), "arrays")
    other = render(load_scene(scene), "arrays")
    assert np.abs(up["normal_world"] - down["normal_world"]).max() < 1e-6
    assert np.abs(up["normal_world"] - other["normal_world"]).max() > 0.1


def test_a_mirrored_placement_mirrors_the_picture(tmp_path):
    """A body, its camera and its light mirrored give the mirror image, bumps and all."""
    scene = bumpy(tmp_path)
    scene["camera"]["azimuth"] = 20
    scene["lights"] = [{"position": [2.0, 1.5, 2.5]}]
    right = render(load_scene(scene), "arrays")
    scene["camera"]["azimuth"] = -20
    scene["lights"] = [{"position": [-2.0, 1.5, 2.5]}]
    mirrored = render(load_scene(scene, **{"mesh.scale": [-1.0, 1.0, 1.0]}), "arrays")
    both = (right["coverage"] == 1) & (mirrored["coverage"][:, ::-1] == 1)
    apart = np.abs(right["normal_world"] - mirrored["normal_world"][:, ::-1] * [-1, 1, 1]).max(axis=-1)
    assert np.quantile(apart[both], 0.9) < 1e-4  # but beside an edge, where another triangle shows


def test_a_specular_map_scales_the_highlight(tmp_path):
    result = render(load_scene(bumpy(tmp_path, phong={"specular": 2.0})), "arrays")
    weight = result["mapped_specular"][result["coverage"] == 1]
    assert weight.min() < 0.5 and 1.5 < weight.max() <= 2


def test_a_picture_that_is_no_normal_map(tmp_path):
    scene = bumpy(tmp_path)
    Image.new("RGB", (2, 2), (200, 200, 90)).save(tmp_path / "bumps.png")
    with pytest.raises(SceneError) as error:
        load_scene(scene)
    assert str(error.value) == (
        "scene: mesh.normal_map: expected a normal map, whose blue is above a half, got bumps.png; check the picture"
    )


def test_a_specular_map_with_colours(tmp_path):
    scene = bumpy(tmp_path)
    with pytest.raises(SceneError) as error:
        load_scene(scene, **{"mesh.specular_map": str(tmp_path / "bumps.png")})
    assert str(error.value) == (
        "scene: mesh.specular_map: expected a grey picture, got bumps.png with colours; save it as grey"
    )


def test_maps_on_a_mesh_without_uvs(tmp_path):
    scene = bumpy(tmp_path)
    scene["mesh"]["path"] = written(tmp_path / "bare.obj", *sphere(8)[:2])
    with pytest.raises(SceneError) as error:
        load_scene(scene)
    assert [line.split(", got")[0] for line in str(error.value).split("\n")] == [
        "scene: mesh.normal_map: expected a mesh with UVs",
        "scene: mesh.specular_map: expected a mesh with UVs",
    ]


def test_the_printed_figures_have_no_maps(tmp_path):
    with pytest.raises(SceneError) as error:
        load_scene(bumpy(tmp_path), preset="published")
    assert [line.split(", got")[0] for line in str(error.value).split("\n")] == [
        'scene: mesh.normal_map: expected nothing with preset "published"',
        'scene: mesh.specular_map: expected nothing with preset "published"',
    ]


def test_texels_are_an_input(tmp_path):
    scene = bumpy(tmp_path)
    before = load_scene(scene).input_hashes()
    Image.new("L", (8, 8), 9).save(tmp_path / "dull.png")
    after = load_scene(scene).input_hashes()
    assert {name for name in before if before[name] != after[name]} == {"specular_map"}
    assert {"normal_map", "tangents"} <= set(before)
