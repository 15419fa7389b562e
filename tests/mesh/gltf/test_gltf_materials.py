"""Colours of materials, and the UVs that their colour texture is looked up at."""

import json
import math

import numpy as np
import pytest
from gltf_files import GltfBuilder, refusal

from sss_ref.mesh.materials import Material
from sss_ref.scene import load_mesh

AGAIN = "; export the mesh again"
FIRST, SECOND = (
    np.float32([[0.5, 0.25], [1, 0], [0, 1], [1, 1]]),
    np.float32([[0.125, 0.75], [0, 0], [1, 0], [0.5, 0.5]]),
)
PBR = "materials[0].pbrMetallicRoughness."


def with_material(material, **attributes):
    builder = GltfBuilder(materials=[material])
    primitive = builder.primitive(**{"TEXCOORD_0": FIRST, "TEXCOORD_1": SECOND, **attributes})
    builder.add("meshes", {"primitives": [{**primitive, "material": 0}]})
    return builder


def textured(**info):
    return {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, **info}}}


def transformed(texture, **transform):
    return textured(**texture, extensions={"KHR_texture_transform": transform})


def upright(uvs):
    """UVs with v turned up."""
    return np.asarray(uvs) * [1, -1] + [0, 1]


SPECULAR = {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.25, 0.5, 1, 1], "diffuseTexture": {"index": 0}}}
MATERIALS = [
    ({}, Material("", (1, 1, 1))),
    ({"name": "skin"}, Material("skin", (1, 1, 1))),
    ({"pbrMetallicRoughness": {"baseColorFactor": [0.0131, 0.5, 0.25, 0]}}, Material("", (0.0131, 0.5, 0.25))),
    ({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}, "name": "r"}, Material("r", (1, 0, 0))),
    (textured(), Material("", (1, 1, 1), textured=True)),
    ({"extensions": SPECULAR}, Material("", (0.25, 0.5, 1), textured=True)),
]


@pytest.mark.parametrize("material, expected", MATERIALS)
def test_material(tmp_path, material, expected):
    assert with_material(material).loaded(tmp_path).materials == (expected,)


def test_no_material(tmp_path):
    builder = GltfBuilder(materials=["not looked at"])
    builder.add("meshes", {"primitives": [builder.primitive()]})
    assert builder.loaded(tmp_path).materials == (Material("", (1, 1, 1)),)


BAD = [
    ("skin", 'materials[0]: expected an object, got "skin"'),
    ({"name": 3}, "materials[0].name: expected a text, got 3"),
    ({"pbrMetallicRoughness": []}, "materials[0].pbrMetallicRoughness: expected an object, got []"),
    ({"pbrMetallicRoughness": {"baseColorFactor": "red"}}, f'{PBR}baseColorFactor: expected an array, got "red"'),
    ({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0]}},
     f"{PBR}baseColorFactor: expected at least 4 values, got [1, 0, 0]"),
    ({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, True]}},
     f"{PBR}baseColorFactor[3]: expected a number, got true"),
    ({"pbrMetallicRoughness": {"baseColorFactor": [1, -1, 0, 1]}},
     "materials[0]: expected a colour of numbers >= 0, got [1.0, -1.0, 0.0, 1.0]"),
    (textured(texCoord="1"), f'{PBR}baseColorTexture.texCoord: expected a whole number, got "1"'),
    (textured(extensions=[]), f"{PBR}baseColorTexture.extensions: expected an object, got []"),
    (transformed({}, scale=2), f"{PBR}baseColorTexture.extensions.KHR_texture_transform.scale: "
     "expected an array, got 2"),
    (transformed({}, rotation=None), f"{PBR}baseColorTexture.extensions.KHR_texture_transform.rotation: "
     "expected a number, got null"),
    ({"extensions": {"KHR_materials_pbrSpecularGlossiness": {
        "diffuseTexture": {"extensions": {"KHR_texture_transform": {"offset": 1}}}}}},
     "materials[0].extensions.KHR_materials_pbrSpecularGlossiness.diffuseTexture.extensions.KHR_texture_transform"
     ".offset: expected an array, got 1"),
]  # fmt: skip


@pytest.mark.parametrize("material, expected", BAD)
def test_bad_material(tmp_path, material, expected):
    assert refusal(with_material(material), tmp_path) == f"{expected}{AGAIN}"


def test_no_such_material(tmp_path):
    builder = with_material({})
    builder.tables["meshes"][0]["primitives"][0]["material"] = 1
    assert refusal(builder, tmp_path) == (
        "meshes[0].primitives[0].material: expected the number of one of the materials, "
        f"got 1 of 1 (they count from 0){AGAIN}"
    )


@pytest.mark.parametrize(
    "material, uvs",
    [
        ({}, FIRST),
        (textured(texCoord=0), FIRST),
        (textured(texCoord=1), SECOND),
        (transformed({"texCoord": 1}, texCoord=0), FIRST),
        (transformed({}, texCoord=1), SECOND),
        ({"emissiveTexture": {"index": 0, "texCoord": 1}}, FIRST),
    ],
)
def test_set_of_uvs(tmp_path, material, uvs):
    assert np.array_equal(with_material(material).loaded(tmp_path).uvs, upright(uvs))


def test_set_of_uvs_that_is_not_there(tmp_path):
    loaded = with_material(textured(texCoord=2)).loaded(tmp_path)
    assert loaded.uvs is None
    assert loaded.notes == (
        "UVs not used: meshes[0].primitives[0] has no TEXCOORD_2, which its colour texture asks for",
    )


def test_offset_and_scale(tmp_path):
    loaded = with_material(transformed({}, offset=[0.25, 0.125], scale=[0.5, 0.25])).loaded(tmp_path)
    assert np.array_equal(loaded.uvs, upright(FIRST * np.float32([0.5, 0.25]) + np.float32([0.25, 0.125])))


def test_example_of_the_extension(tmp_path):
    """Its own words: the lower left quadrant of the image, rotated clockwise a quarter turn."""
    square = np.float32([[0, 0], [1, 0], [0, 1], [1, 1]])
    material = transformed({}, offset=[0, 1], rotation=math.pi / 2, scale=[0.5, 0.5])
    loaded = with_material(material, TEXCOORD_0=square).loaded(tmp_path)
    assert loaded.uvs == pytest.approx(upright([[0, 1], [0, 0.5], [0.5, 1], [0.5, 0.5]]), abs=1e-7)


def test_scaled_then_rotated_then_moved(tmp_path):
    """22.5 degrees counter-clockwise as one sees it, v pointing down (Khronos glTF issue 1563)."""
    angle, sx, sy, x, y = math.pi / 8, 0.5, 0.25, 0.0625, 0.5
    loaded = with_material(transformed({}, offset=[x, y], rotation=angle, scale=[sx, sy])).loaded(tmp_path)
    u, v = FIRST.T * np.array([[sx], [sy]])
    expected = [math.cos(angle) * u + math.sin(angle) * v + x, math.cos(angle) * v - math.sin(angle) * u + y]
    assert loaded.uvs == pytest.approx(upright(np.array(expected).T), abs=1e-7)


def test_whole_numbers_brought_back_by_the_transform(tmp_path):
    """The way KHR_mesh_quantization gives for UVs (gltfpack)."""
    stored = np.uint16([[0, 4095], [4095, 0], [1024, 2048], [1, 2]])
    builder = with_material(transformed({}, scale=[1 / 4095, 1 / 4095]), TEXCOORD_0=stored)
    builder.tables["extensionsRequired"] = ["KHR_mesh_quantization", "KHR_texture_transform"]
    assert builder.loaded(tmp_path).uvs == pytest.approx(upright(stored / 4095), abs=1e-7)


def test_colours_of_an_asset(asset, tmp_path):
    document = json.loads(asset("gltf/rgb_cube_with_primitives.gltf").read_text())
    colors = {"Red": [0.013, 0.5, 0.25, 1], "Green": [0.0131, 0.5, 0.25, 1], "Blue": None}
    for material in document["materials"]:
        material["pbrMetallicRoughness"].pop("baseColorFactor", None)
        if colors[material["name"]]:
            material["pbrMetallicRoughness"]["baseColorFactor"] = colors[material["name"]]
    (tmp_path / "a.gltf").write_text(json.dumps(document))
    found = {material.name: material.color for material in load_mesh(tmp_path / "a.gltf").materials}
    assert found == {"Red": (0.013, 0.5, 0.25), "Green": (0.0131, 0.5, 0.25), "Blue": (1, 1, 1)}
