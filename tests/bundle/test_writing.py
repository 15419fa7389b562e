"""The files of a bundle, of a small scene with two lights, a picture and rounds."""

import json
import re

import numpy as np
import pytest
import trimesh
from PIL import Image
from scenes import LIGHT, around, two_squares, written

from sss_ref.bundle.writing import write_bundle
from sss_ref.errors import DumpError
from sss_ref.scene.load import load_scene

CODES = np.arange(18, dtype=np.uint8).reshape(2, 3, 3) * 14  # of a picture, row 0 at the top
LIGHTS = [{"position": LIGHT}, {"position": [-1.0, 0.0, 3.0]}]
FILES = ["PORTING.md", "mapping.toml", "mesh", "mesh.glb", "passes.json", "scene.json", "shaders", "textures"]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    folder = tmp_path_factory.mktemp("squares")
    Image.fromarray(CODES).save(folder / "paint.png")
    data = around(written(folder / "squares.obj", *two_squares()), 6, method="texture_space", lights=LIGHTS)
    data["mesh"]["texture"] = str(folder / "paint.png")
    return load_scene(data, **{"irradiance_map.width": 5, "irradiance_map.height": 3})


@pytest.fixture(scope="module")
def bundle(scene, tmp_path_factory):
    return write_bundle(scene, tmp_path_factory.mktemp("bundle") / "glsl")


def read(folder, name):
    return json.loads((folder / name).read_text())


def test_its_files(bundle):
    assert sorted(path.name for path in bundle.iterdir()) == sorted([*FILES, "uniforms.json"])
    listed = read(bundle, "passes.json")["passes"]
    shaders = {one["vertex_shader"] for one in listed} | {
        each["fragment_shader"] for one in listed for each in one["draws"]
    }
    assert {f"shaders/{path.name}" for path in (bundle / "shaders").iterdir()} == shaders
    text = (bundle / "passes.json").read_text()
    assert text.startswith('{\n "format": ') and text.endswith("}\n") and not text.endswith("}\n\n")


def test_its_uniforms_are_those_that_its_shaders_have(scene, bundle):
    """Each with the numbers of the scene, matrices row by row; no buffer is among them."""
    uniforms = read(bundle, "uniforms.json")
    shaders = "".join(path.read_text() for path in (bundle / "shaders").iterdir())
    named = set(re.findall(r"^uniform \w+ (\w+)", shaders, re.MULTILINE))
    assert named - set(uniforms) == {name for name in named if name in scene.method.outputs}
    assert set(uniforms) <= named and not set(uniforms) & set(scene.method.outputs)
    for name, told in uniforms.items():
        value = told["value"] if "value" in told else np.load(bundle / told["file"])
        assert np.array_equal(np.asarray(value, np.float32), scene.uniforms[name]), name
    assert {name: told["file"] for name, told in uniforms.items() if "file" in told} == {
        "albedo_map": "textures/albedo_map.npy"
    }
    kinds = {name: uniforms[name]["type"] for name in ("albedo_map", "tap_offset", "tap_count", "world_from_model")}
    assert [*kinds.values()] == ["texture of vec3", "Array[vec2]", "int", "mat4"]
    assert uniforms["x"]["value"] == 2 and uniforms["exponent"]["value"] == 0.6
    assert isinstance(uniforms["tap_count"]["value"], int) and isinstance(uniforms["x"]["value"], float)


def test_its_picture_has_the_codes_of_the_scenes(bundle):
    (picture,) = [path for path in (bundle / "textures").iterdir() if path.suffix == ".png"]
    assert np.array_equal(np.asarray(Image.open(picture)), CODES)
    assert sorted(path.name for path in (bundle / "textures").iterdir()) == sorted(["albedo_map.npy", picture.name])


def test_its_mesh_is_there_to_look_at_and_in_arrays(scene, bundle):
    looked_at = trimesh.load(bundle / "mesh.glb", force="mesh", process=False)
    assert np.array_equal(looked_at.vertices, scene.mesh.positions) and np.array_equal(
        looked_at.faces, scene.mesh.triangles
    )
    assert np.array_equal(np.load(bundle / "mesh" / "position.npy"), scene.mesh.attributes["position"])
    assert np.array_equal(np.load(bundle / "mesh" / "triangles.npy"), scene.mesh.triangles)


def test_where_an_array_is_a_texture_it_is_a_file(scene, tmp_path):
    folder = write_bundle(scene, tmp_path / "wgsl", "wgsl")
    uniforms = read(folder, "uniforms.json")
    files = {name: told["file"] for name, told in uniforms.items() if "file" in told}
    assert files == {name: f"textures/{name}.npy" for name in ("albedo_map", "tap_offset", "tap_weight")}
    assert np.array_equal(np.load(folder / "textures" / "tap_weight.npy"), scene.uniforms["tap_weight"])
    assert uniforms["tap_offset"]["type"] == "texture of vec2" and read(folder, "passes.json")["dialect"] == "wgsl"


@pytest.mark.parametrize("content", [None, "{}", "[]", "{", '{"format": "sss_ref bundle 0"}', '{"format": ["a"]}'])
def test_nothing_but_an_earlier_bundle_is_replaced(scene, tmp_path, content):
    folder = tmp_path / "somebody's"
    folder.mkdir()
    (folder / "note.txt").write_text("keep")
    if content is not None:
        (folder / "passes.json").write_text(content)
    with pytest.raises(DumpError, match=r"expected .*an earlier bundle"):
        write_bundle(scene, folder)
    assert (folder / "note.txt").read_text() == "keep"


def test_an_earlier_bundle_is_replaced_as_a_whole(scene, tmp_path):
    folder = write_bundle(scene, tmp_path / "b", "wgsl")
    (folder / "note.txt").write_text("gone")
    write_bundle(scene, folder)
    assert read(folder, "passes.json")["dialect"] == "glsl" and not (folder / "note.txt").exists()
