"""What a note says of a material's normal map: the key to set, and what does not fit."""

import numpy as np
import pytest
from gltf_files import GltfBuilder

UVS = np.float32([[0.5, 0.25], [1, 0], [0, 1], [1, 1]])
INSIDE = "the normal map inside the file ({}) is not read; save it and give it as mesh.normal_map"
BESIDE = 'the normal map "pores n.png" is not read by itself; set mesh.normal_map to its path'
IMAGES = [{"bufferView": 0}, {"uri": "data:image/png;base64,"}, {"uri": "pores%20n.png"}]


def notes(tmp_path, texture, images=IMAGES, material=None, **attributes):
    builder = GltfBuilder(materials=[{**(material or {}), "normalTexture": texture}])
    primitive = builder.primitive(TEXCOORD_0=UVS, TEXCOORD_1=UVS, **attributes)
    builder.add("meshes", {"primitives": [{**primitive, "material": 0}]})
    builder.tables |= {"images": images, "textures": [{"source": k} for k in range(3)]}
    return builder.loaded(tmp_path).notes


@pytest.mark.parametrize(
    ("texture", "told"),
    [
        ({"index": 0}, INSIDE.format("images[0]")),
        ({"index": 1}, INSIDE.format("images[1]")),
        ({"index": 2}, BESIDE),
        ({"index": 2, "scale": 0.5}, f"{BESIDE} and mesh.normal_strength = 0.5"),
        ({"index": 0, "scale": 1.0}, INSIDE.format("images[0]")),
        ({"index": 7}, INSIDE.format("an image")),
        ("broken", INSIDE.format("an image")),
        ({"index": -1, "scale": "2"}, INSIDE.format("an image")),
    ],
)
def test_the_note_names_the_key_to_set(tmp_path, texture, told):
    assert notes(tmp_path, texture) == (told,)


def test_tables_that_are_none(tmp_path):
    assert notes(tmp_path, {"index": 0}, images=3) == (INSIDE.format("images[0]"),)


def test_another_uv_set_and_tangents_of_the_file(tmp_path):
    told = notes(tmp_path, {"index": 2, "texCoord": 1}, TANGENT=np.float32([[1, 0, 0, 1]] * 4))
    assert told == (
        BESIDE,
        "the normal map lies over UV set 1, but the mesh is read with set 0",
        "the file's tangents are not used; a normal map gets those of rule R11",
    )
    color = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}}
    assert notes(tmp_path, {"index": 2, "texCoord": 1}, material=color) == (BESIDE,)
