"""The printed figures' methods: both interpreters, their buffers, and what eight bits make of them."""

import numpy as np
import pytest
from scenes import around, cube, sphere, wall, written

from sss_ref.passes.buffers import BUFFERS
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

IN_BYTES = ("light_distance", "irradiance", "lit", "image")
LIGHT_VIEW = ["light_triangle", "light_depth", "light_distance"]
SURFACE = ["triangle", "depth", "coverage", "position_world", "normal_world", "uv", "albedo", "incident_light"]
THROUGH = ["entry_point", "thickness", "directly_lit", "phong", "translucency"]
SCREEN = [*LIGHT_VIEW, *SURFACE, *THROUGH, "lit", "scattered", "image"]
TEXTURE = [*LIGHT_VIEW, "light_uv", "irradiance_mask", "irradiance", *SURFACE, *THROUGH, "irradiance_used", "image"]


@pytest.fixture(scope="module")
def bodies(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bodies")
    return {"sphere": written(folder / "sphere.obj", *sphere(12)), "cube": written(folder / "cube.obj", *cube())}


def scene_of(path, method, **overrides):
    small = {
        f"{table}.{side}": 48 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
    }
    return load_scene({**around(path, size=48), "preset": "published", "method": method}, **small, **overrides)


@pytest.mark.parametrize(("method", "names"), [("screen_space", SCREEN), ("texture_space", TEXTURE)])
def test_both_interpreters_give_the_same_bits_of_every_buffer(bodies, method, names):
    scene = scene_of(bodies["sphere"], method)
    result = render(scene)
    assert list(result.buffers) == names and set(names) <= set(BUFFERS)
    assert result.hashes == render(scene, interpreter="arrays").hashes


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
@pytest.mark.parametrize(
    ("path", "distance"), [("head_lps/leeperrysmith.obj", 15.0), ("spot/spot_triangulated.obj", 3.4)]
)
def test_both_interpreters_give_the_same_bits_on_scanned_meshes(asset, path, distance, method):
    lights = [{"position": [3 * distance, distance, 0.0]}]
    scene = scene_of(str(asset(path)), method, lights=lights, **{"camera.distance": distance})
    result = render(scene)
    assert result.hashes == render(scene, interpreter="arrays").hashes
    assert len(np.unique(result["triangle"])) > 200


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
def test_targets_hold_bytes_and_are_cleared_to_0(bodies, method):
    result = render(scene_of(bodies["sphere"], method), interpreter="arrays")
    limits = {"light_distance": result["light_triangle"] < 0, "lit": result["coverage"] == 0}
    if method == "texture_space":
        limits |= {"irradiance": result["irradiance_mask"] == 0, "image": result["coverage"] == 0}
    for name in set(IN_BYTES) & set(result.buffers):
        steps = result[name] * np.float32(255)
        assert np.array_equal(np.rint(steps) / np.float32(255), result[name])
        assert name not in limits or not result[name][limits[name]].any()
    assert len(np.unique(result["image"])) > 50


def test_a_light_nearer_than_1_is_kept_and_one_beyond_saturates(bodies):
    """From (0, 0, 1.5) the sphere's nearest point is .5 away: round(.5 * 255) = 128 of 255; from 3 all is beyond 1."""
    for height, least in ((1.5, 128 / 255), (3.0, 1.0)):
        scene = scene_of(bodies["sphere"], "screen_space", lights=[{"position": [0.0, 0.0, height]}])
        stored = render(scene, interpreter="arrays", keep=["light_distance", "light_triangle"])
        distances = stored["light_distance"][stored["light_triangle"] >= 0]
        assert abs(distances.min() - least) < 1.5 / 255 and distances.max() <= 1


def test_normals_stay_in_the_space_of_the_mesh(tmp_path):
    """A wall that faces +Z, turned to face +X: its normals are those of the file."""
    path = written(tmp_path / "wall.obj", *wall(), flat=True)
    turned = {"mesh.rotate_degrees": [0.0, 90.0, 0.0], "camera": {"type": "look_at", "eye": [5.0, 0.0, 0.0]}}
    scene = scene_of(path, "screen_space", lights=[{"position": [2.0, 0.0, 0.0]}], **turned)
    result = render(scene, interpreter="arrays")
    assert np.array_equal(result["normal_world"][24, 24], [0, 0, 1])
    assert abs(result["position_world"][24, 24, 0]) < 1e-6


def test_the_entry_point_is_interpolated_from_the_vertices(bodies):
    """Over each face of a cube it is linear; computed per fragment it would lie on a sphere around the light."""
    scene = scene_of(bodies["cube"], "screen_space", lights=[{"position": [0.0, 0.0, 3.0]}])
    result = render(scene, interpreter="arrays")
    on_face = (result["triangle"] == result["triangle"][24, 24]) & (result["coverage"] != 0)
    points = result["entry_point"][on_face].astype(np.float64)
    inputs = np.column_stack([result["position_world"][on_face].astype(np.float64), np.ones(on_face.sum())])
    linear, *_ = np.linalg.lstsq(inputs, points, rcond=None)
    assert on_face.sum() > 50 and np.abs(inputs @ linear - points).max() < 1e-5
    from_light = np.linalg.norm(points - [0.0, 0.0, 3.0], axis=1)
    assert from_light.max() - from_light.min() > 0.01


def test_where_the_thickness_is_0_the_fragment_is_lit(tmp_path):
    """The irradiance map holds D < 1 in whole bytes; on a wall at D = 1, exactly, the entry point is the fragment."""
    uvs = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float64)
    path = written(tmp_path / "wall.obj", *wall(), uvs)
    light = {"lights": [{"position": [0.0, 0.0, 1.0], "target": [0.0, 0.0, 0.0]}]}
    near = {"camera": {"type": "look_at", "eye": [0.0, 0.0, 0.001], "near": 0.0001}}
    result = render(scene_of(path, "texture_space", **light, **near), interpreter="arrays")
    lit = result["directly_lit"] != 0
    assert np.array_equal(lit, (result["thickness"] == 0) & (result["coverage"] != 0))
    assert lit.any() and not result["translucency"][lit].any()
