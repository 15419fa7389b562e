"""Whole files: small ones rebuilt from public reports with their right values, limits, and what is not looked at."""

import json

import numpy as np
import pytest
from gltf_files import CORNERS, GltfBuilder, area, corners, message, refusal, tetrahedron, volume

from sss_ref.mesh.gltf import gltf_reader
from sss_ref.scene import load_mesh

AGAIN = "; export the mesh again"


def test_parts_keep_what_they_have(tmp_path):
    """Stored normals are used if every part has them, UVs likewise (rule R6)."""
    normals, uvs = np.float32([[0, 0, 1]] * 4), np.float32([[0, 0], [0.5, 0], [0, 0.5], [0.5, 0.5]])
    builder = GltfBuilder()
    both = builder.primitive(NORMAL=normals, TEXCOORD_0=uvs)
    builder.add("meshes", {"primitives": [both, builder.primitive()]})
    loaded = builder.loaded(tmp_path)
    assert (loaded.normals_source, loaded.uvs) == ("computed", None)
    assert loaded.notes == ("UVs not used: 1 of 2 parts have none", "normals computed: 1 of 2 parts have none")


def test_materials_are_numbered_as_they_are_first_used(tmp_path):
    builder = GltfBuilder(materials=[{"name": "a"}, {"name": "b"}])
    primitives = [{**builder.primitive(), "material": number} for number in (1, 0, 1)]
    builder.add("meshes", {"primitives": primitives})
    loaded = builder.loaded(tmp_path)
    assert [material.name for material in loaded.materials] == ["b", "a"]
    assert loaded.material.tolist() == [0] * 4 + [1] * 4 + [0] * 4


def test_one_mesh_at_two_nodes(tmp_path):
    builder = tetrahedron(nodes=[{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}], scenes=[{"nodes": [0, 1]}])
    loaded = builder.loaded(tmp_path)
    assert len(loaded.triangles) == 8 and volume(loaded) == pytest.approx(2 / 6)
    assert np.array_equal(corners(loaded)[4:], corners(loaded)[:4] + np.float32([5, 0, 0]))


def test_many_parts(tmp_path, monkeypatch):
    builder = tetrahedron(nodes=[{"mesh": 0}] * 3, scenes=[{"nodes": [0, 1, 2]}])
    monkeypatch.setattr(gltf_reader, "PART_LIMIT", 2)
    expected = "nodes: expected at most 2 primitives over all nodes, got more; simplify the mesh"
    assert refusal(builder, tmp_path) == expected
    monkeypatch.setattr(gltf_reader, "PART_LIMIT", 3)
    assert len(builder.loaded(tmp_path).triangles) == 12


def test_what_a_mesh_does_not_need_is_not_looked_at(tmp_path):
    """Also broken, and also of another kind than it should be."""
    unused = {"animations": 3, "images": "x", "textures": {}, "samplers": [None], "cameras": [[]], "extras": 1}
    assert area(tetrahedron(**unused).loaded(tmp_path)) == pytest.approx(2.36603, abs=1e-5)


WRONG = [
    ({"nodes": 3}, "nodes: expected an array, got 3"),
    ({"nodes": ["a"]}, 'nodes[0]: expected an object, got "a"'),
    ({"nodes": [{"mesh": "0"}]}, 'nodes[0].mesh: expected a whole number, got "0"'),
    ({"nodes": [{"mesh": True}]}, "nodes[0].mesh: expected a whole number, got true"),
    ({"nodes": [{"mesh": -1}]}, "nodes[0].mesh: expected at least 0, got -1"),
    ({"nodes": [{"mesh": 0, "extensions": 3}]}, "nodes[0].extensions: expected an object, got 3"),
    ({"scenes": [[0]]}, "scenes[0]: expected an object, got [0]"),
    ({"scene": "first"}, 'scene: expected a whole number, got "first"'),
    ({"meshes": ["a"]}, 'meshes[0]: expected an object, got "a"'),
    ({"meshes": [{}]}, "meshes[0].primitives: expected a value, got nothing"),
    ({"meshes": [{"primitives": {}}]}, "meshes[0].primitives: expected an array, got {}"),
    ({"meshes": [{"primitives": [None]}]}, "meshes[0].primitives[0]: expected an object, got null"),
    ({"meshes": [{"primitives": [{}]}]}, "meshes[0].primitives[0].attributes: expected a value, got nothing"),
    (
        {"meshes": [{"primitives": [{"attributes": {"POSITION": [0]}}]}]},
        "meshes[0].primitives[0].attributes.POSITION: expected a whole number, got [0]",
    ),
    ({"accessors": [3, 4]}, "accessors[0]: expected an object, got 3"),
    ({"bufferViews": [None]}, "bufferViews[0]: expected an object, got null"),
    ({"buffers": [[]]}, "buffers[0]: expected an object, got []"),
    ({"buffers": [{"uri": "a.bin"}]}, "buffers[0].byteLength: expected a value, got nothing"),
    ({"buffers": [{"uri": 3, "byteLength": 1}]}, "buffers[0].uri: expected a text, got 3"),
    ({"extensionsRequired": "KHR"}, 'extensionsRequired: expected an array, got "KHR"'),
    ({"asset": []}, "asset: expected an object, got []"),
]


@pytest.mark.parametrize("top, expected", WRONG, ids=range(len(WRONG)))
def test_json_of_another_kind(tmp_path, top, expected):
    path = tmp_path / "a.gltf"
    path.write_text(json.dumps({**tetrahedron().document({"uri": "a.bin"}), **top}))
    assert message(path) == f"{expected}{AGAIN}"


def test_asset_of_two_nodes_in_a_glb(asset):
    """Its node turns 90 degrees about x: what is left of 1 - 2*x*x stays within one rounding."""
    loaded = load_mesh(asset("gltf/no_indices_3storybuilding.glb"))
    assert len(loaded.triangles) == 72 and np.abs(loaded.positions[:, 1]).min() < 1e-13


def test_textures_are_not_decoded(asset, monkeypatch):
    """A picture of 4096 x 4096 texels takes longer than its mesh."""
    from PIL import Image

    monkeypatch.setattr(Image, "open", None)
    assert len(load_mesh(asset("gltf/AlphaBlendModeTest.glb")).triangles) == 61


def test_every_kind_of_file_gives_the_same(tmp_path):
    first, second = tetrahedron().loaded(tmp_path), tetrahedron().loaded(tmp_path, "a.glb")
    assert first.hashes() == second.hashes() and np.array_equal(first.positions, CORNERS)
