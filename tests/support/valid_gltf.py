"""glTF files: a plain one, and one with sparse, skinned, morphed, copied and textured surfaces."""

import numpy as np
from gltf_files import CORNERS, GltfBuilder
from valid_file import made, picture

COPIES = "EXT_mesh_gpu_instancing"
MOVED = "KHR_texture_transform"


def gltf(name):
    """Two nodes that move a mesh with texture coordinates, normals and a material."""
    builder = GltfBuilder(
        nodes=[{"mesh": 0, "children": [1]}, {"mesh": 0, "translation": [2, 0, 0], "scale": [1, 2, 1]}]
    )
    uvs = CORNERS[:, :2].copy()
    primitive = builder.primitive(TEXCOORD_0=uvs, NORMAL=np.tile(np.float32([0, 0, 1]), (4, 1)))
    builder.add("materials", {"name": "a", "pbrMetallicRoughness": {"baseColorFactor": [0.7, 0.4, 0.3, 1.0]}})
    builder.add("meshes", {"primitives": [{**primitive, "material": 0}]})
    return made(lambda path, _: builder.written(path.parent, name), name, None)


def gltf_with_everything(name):
    """Four nodes: a morphed and sparse mesh, copies of it, a skinned one, and a joint."""
    copied = {"attributes": {}}
    nodes = [
        {"mesh": 0, "weights": [0.5]},
        {"mesh": 0, "extensions": {COPIES: copied}},
        {"mesh": 1, "skin": 0},
        {"translation": [8, 0, 0]},
    ]
    builder = GltfBuilder(nodes=nodes, scenes=[{"nodes": [0, 1, 2, 3]}], extensionsUsed=[COPIES, MOVED])
    copied["attributes"]["TRANSLATION"] = builder.accessor(np.float32([[0, 4, 0], [0, 8, 0]]))
    image = builder.add("images", {"bufferView": builder.view(picture(4, 4, 3)), "mimeType": "image/png"})
    texture = {"index": builder.add("textures", {"source": image})}
    color = {**texture, "extensions": {MOVED: {"offset": [0.25, 0], "scale": [0.5, 0.5], "rotation": 0.5}}}
    builder.add("materials", {"pbrMetallicRoughness": {"baseColorTexture": color}, "normalTexture": texture})
    uvs, normals = CORNERS[:, :2].copy(), np.tile(np.float32([0, 0, 1]), (4, 1))
    morphed = builder.primitive(POSITION=_sparse(builder), TEXCOORD_0=uvs, NORMAL=normals)
    morphed |= {"material": 0, "targets": [{"POSITION": builder.accessor(np.float32([[0, 0, 1]] * 4))}]}
    builder.add("meshes", {"primitives": [morphed]})
    joints, weights = np.zeros((4, 4), np.uint8), np.float32([[1, 0, 0, 0]] * 4)
    skinned = builder.primitive(JOINTS_0=joints, WEIGHTS_0=weights, TEXCOORD_0=uvs, NORMAL=normals)
    builder.add("meshes", {"primitives": [{**skinned, "material": 0}]})
    binds = builder.accessor(np.eye(4, dtype=np.float32).reshape(1, 16))
    builder.add("skins", {"joints": [3], "inverseBindMatrices": binds})
    return made(lambda path, _: builder.written(path.parent, name), name, None)


def _sparse(builder):
    """Corners of which the last is another."""
    number = builder.accessor(CORNERS)
    builder.tables["accessors"][number]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": builder.view(bytes([3])), "componentType": 5121},
        "values": {"bufferView": builder.view(np.float32([0, 0, 2]).tobytes())},
    }
    return number
