"""Pictures with a colour texture and with the colours of materials: both interpreters, and a naive look-up."""

import numpy as np
import pytest
from naive_stages import albedo_textured

from sss_ref.rendering.fold import render
from sss_ref.scene import load_scene


def seen(mesh, light, distance, azimuth):
    return load_scene(
        {
            "mesh": mesh,
            "camera": {
                "type": "orbit",
                "distance": distance,
                "azimuth": azimuth,
                "width": 96,
                "height": 96,
                "fov_y": 40,
            },
            "lights": [{"position": light}],
            "shadow_map": {"width": 96, "height": 96},
        }
    )


def spot(asset):
    texture = {"texture": str(asset("spot/spot_texture.png"))}
    return seen({"path": str(asset("spot/spot_triangulated.obj")), **texture}, [6, 5, 8], 3, 150)


def face(asset):
    return seen({"path": str(asset("ict_face/generic_neutral_mesh.obj")), "color": "material"}, [40, 30, 80], 70, 10)


@pytest.mark.parametrize("scene", [spot, face])
def test_interpreters_agree(asset, scene):
    kernel, arrays = (render(scene(asset), interpreter, threads=1) for interpreter in ("kernel", "arrays"))
    assert kernel.hashes == arrays.hashes


def test_the_texture_is_on_the_surface(asset):
    scene = spot(asset)
    result = render(scene, keep=["uv", "albedo", "coverage"], threads=1)
    texels = scene.albedo["albedo_map"]
    for row, column in np.argwhere(result["coverage"])[::17]:
        (expected,) = albedo_textured(result["uv"][row, column], texels)
        assert np.array_equal(result["albedo"][row, column], expected)
    brown = np.float32([0.36, 0.11, 0.04])  # the horns, which point up
    top = result["albedo"][result["coverage"].any(axis=1).nonzero()[0][-1]]
    assert np.abs(top[top.any(axis=1)] - brown).max() < 0.1


def test_every_triangle_has_its_materials_colour(asset):
    scene = face(asset)
    result = render(scene, keep=["triangle", "albedo"], threads=1)
    visible = result["triangle"] >= 0
    materials = [scene.mesh.materials[k].color for k in scene.mesh.material[result["triangle"][visible]]]
    assert np.array_equal(result["albedo"][visible], np.float32(materials)) and len(set(materials)) >= 3
