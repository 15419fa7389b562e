"""Morph targets at rest (glTF 2.0, 3.7.2.2)."""

import numpy as np
import pytest
from gltf_files import CORNERS, GltfBuilder, area, refusal, volume

AGAIN = "; export the mesh again"
UP, ASIDE = np.float32([[0, 0, 0]] * 3 + [[0, 0, 1]]), np.float32([[0, 0, 0], [2, 0, 0], [0, 0, 0], [0, 0, 0]])


def morphed(targets, mesh=None, node=None, **attributes):
    """The tetrahedron with targets of arrays or of accessors' numbers, and weights of the mesh and of the node."""
    builder = GltfBuilder(nodes=[{"mesh": 0, **({} if node is None else {"weights": node})}])
    primitive = builder.primitive(**attributes)
    primitive["targets"] = [
        {name: each if isinstance(each, int) else builder.accessor(each) for name, each in target.items()}
        for target in targets
    ]
    builder.add("meshes", {"primitives": [primitive], **({} if mesh is None else {"weights": mesh})})
    return builder


def test_weights_of_the_mesh(tmp_path):
    """The apex goes up by 1: area 4, volume 1/3."""
    loaded = morphed([{"POSITION": UP}], [1]).loaded(tmp_path)
    assert area(loaded) == pytest.approx(4) and volume(loaded) == pytest.approx(1 / 3)


def test_weights_of_the_node_come_first(tmp_path):
    targets = [{"POSITION": UP}, {"POSITION": ASIDE}]
    assert np.array_equal(morphed(targets, [1, 1], [0, 0.5]).loaded(tmp_path).positions, CORNERS + ASIDE / 2)
    assert np.array_equal(morphed(targets, [1, 1], [0, 0]).loaded(tmp_path).positions, CORNERS)
    assert np.array_equal(morphed(targets, None, [-1, 2]).loaded(tmp_path).positions, CORNERS - UP + 2 * ASIDE)


def test_without_weights_targets_are_not_looked_at(tmp_path):
    assert np.array_equal(morphed([{"POSITION": 99}, {"POSITION": 98}]).loaded(tmp_path).positions, CORNERS)
    assert np.array_equal(morphed([{"POSITION": 99}], [0]).loaded(tmp_path).positions, CORNERS)


def test_morphed_before_the_node_moves_it(tmp_path):
    builder = morphed([{"POSITION": UP}], [1])
    builder.tables["nodes"][0]["scale"] = [1, 1, 10]
    assert volume(builder.loaded(tmp_path)) == pytest.approx(20 / 6)


def test_normals_and_uvs(tmp_path):
    normals, uvs = np.float32([[0, 0, 1]] * 4), np.float32([[0, 0], [0.5, 0], [0, 0.5], [0.5, 0.5]])
    target = {"NORMAL": np.float32([[1, 0, 0]] * 4), "TEXCOORD_0": np.float32([[0.25, 0.125]] * 4)}
    loaded = morphed([target, {"POSITION": UP}], [0.5, 1], NORMAL=normals, TEXCOORD_0=uvs).loaded(tmp_path)
    assert np.array_equal(loaded.normals, [[0.5, 0, 1]] * 4)
    assert np.array_equal(loaded.uvs, (uvs + np.float32([0.125, 0.0625])) * [1, -1] + [0, 1])


def test_sparse_target(tmp_path):
    """The way Blender writes shape keys: zeros but for what moves."""
    builder = morphed([{}], [1])
    places, values = builder.view(b"\3"), builder.view(UP[3:].tobytes())
    sparse = {
        "count": 1,
        "indices": {"bufferView": places, "componentType": 5121},
        "values": {"bufferView": values},
    }
    number = builder.add("accessors", {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": sparse})
    builder.tables["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": number}]
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + UP)


def test_normalized_target(tmp_path):
    builder = morphed([{}], [1])
    builder.tables["extensionsRequired"] = ["KHR_mesh_quantization"]
    content = b"".join(row.tobytes() + b"\0\0" for row in (UP * 32767).astype(np.int16))
    view = builder.view(content, byteStride=8)
    number = builder.add(
        "accessors", {"bufferView": view, "componentType": 5122, "normalized": True, "count": 4, "type": "VEC3"}
    )
    builder.tables["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": number}]
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + UP)


PLACE = "meshes[0].primitives[0]"
BAD = [
    ([{"POSITION": UP}], [1, 1], f"{PLACE}: expected a weight for each of 1 targets, got 2 weights"),
    ([{"POSITION": UP}, {"POSITION": UP}], [1], f"{PLACE}: expected a weight for each of 2 targets, got 1 weights"),
    ([], [1], f"{PLACE}: expected a weight for each of 0 targets, got 1 weights"),
    ([{"POSITION": UP[:3]}], [1], f"{PLACE}.targets[0].POSITION: expected 4 elements, as many as the others, got 3"),
    ([{"POSITION": UP[:, :2].copy()}], [1], f"{PLACE}.targets[0].POSITION: expected VEC3 of float, got VEC2 of float"),
    ([{"POSITION": 99}], [1], f"{PLACE}.targets[0].POSITION: expected the number of one of the accessors, "
     "got 99 of 2 (they count from 0)"),
    ([{"POSITION": "a"}], [1], f'{PLACE}.targets[0].POSITION: expected a whole number, got "a"'),
    ([{"POSITION": UP}], ["1"], 'meshes[0].weights[0]: expected a number, got "1"'),
]  # fmt: skip


@pytest.mark.parametrize("targets, weights, expected", BAD, ids=range(len(BAD)))
def test_bad_targets(tmp_path, targets, weights, expected):
    builder = morphed([{}] * len(targets) if "a" in str(targets) and "array" not in str(targets) else targets, weights)
    if "array" not in str(targets) and targets:
        builder.tables["meshes"][0]["primitives"][0]["targets"] = targets
    assert refusal(builder, tmp_path) == f"{expected}{AGAIN}"
