"""Skinned meshes at rest (glTF 2.0, 3.7.3); the naive sum beside it follows the specification's formula."""

import numpy as np
import pytest
from gltf_files import CORNERS, GltfBuilder, corners, refusal, volume

from sss_ref.mesh.gltf import accessors
from sss_ref.mesh.gltf.skins import _for_normals

AGAIN = "; export the mesh again"
PLACE = "meshes[0].primitives[0]"
FIRST = np.zeros((4, 4), np.uint8)  # every vertex hangs on joint 0
WHOLE = np.float32([[1, 0, 0, 0]] * 4)
HALF = np.float32([[0.5, 0.5, 0, 0]] * 4)
BOTH = np.uint8([[0, 1, 0, 0]] * 4)


def moves(x, y, z):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def skinned(nodes, joints=FIRST, weights=WHOLE, binds=None, skin=(1,), **attributes):
    """The tetrahedron at node 0, hanging on the nodes of `skin`. binds: matrices, stored by columns."""
    builder = GltfBuilder(nodes=[{"mesh": 0, "skin": 0, **nodes[0]}, *nodes[1:]], scenes=[{"nodes": [0, 1]}])
    builder.add("meshes", {"primitives": [builder.primitive(JOINTS_0=joints, WEIGHTS_0=weights, **attributes)]})
    entry = {"joints": list(skin)}
    if binds is not None:
        rows = np.stack([np.asarray(bind, np.float32).T.reshape(16) for bind in binds])
        entry["inverseBindMatrices"] = builder.accessor(rows)
    builder.add("skins", entry)
    return builder


def test_the_joints_count_and_not_the_node(tmp_path):
    """The box from (10, 0, 0) to (11, 1, 1)."""
    builder = skinned([{"translation": [0, 5, 0]}, {"translation": [10, 0, 0]}], binds=[np.eye(4)])
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + np.float32([10, 0, 0]))


def test_without_inverse_bind_matrices_they_are_the_identity(tmp_path):
    builder = skinned([{"scale": [9, 9, 9]}, {"translation": [10, 0, 0]}])
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + np.float32([10, 0, 0]))


def test_the_bind_matrix_comes_before_the_joint(tmp_path):
    """And the joint's matrix is the product from the root."""
    nodes = [{}, {"translation": [10, 0, 0], "children": [2]}, {"scale": [2, 2, 2]}]
    builder = skinned(nodes, binds=[moves(1, 0, 0)], skin=[2])
    assert np.array_equal(
        builder.loaded(tmp_path).positions, (CORNERS + np.float32([1, 0, 0])) * 2 + np.float32([10, 0, 0])
    )


def test_each_joint_has_its_own_bind_matrix(tmp_path):
    """Half way between (1, 2, 3) + (8, 0, 0) and (5, 4, 1)."""
    binds = [moves(1, 2, 3), moves(5, 4, 1)]
    builder = skinned([{}, {"translation": [8, 0, 0]}, {}], BOTH, HALF, binds, skin=[1, 2])
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + np.float32([7, 3, 2]))


def test_what_hangs_on_joints_is_counted(tmp_path, monkeypatch):
    """A node, 4 vertices and 12 corners, a joint, and of each vertex four joints and their weights."""
    builder = skinned([{}, {"translation": [10, 0, 0]}])
    monkeypatch.setattr(accessors, "BUDGET", 1 + 4 + 12 + 1 + 8 * 4)
    assert len(builder.loaded(tmp_path).triangles) == 4
    monkeypatch.setattr(accessors, "BUDGET", accessors.BUDGET - 1)
    expected = "expected at most 49 vertices and corners over all nodes, got more; simplify the mesh"
    assert refusal(builder, tmp_path) == f"nodes: {expected}"


@pytest.mark.parametrize("dtype", [np.float32, np.uint8, np.uint16])
def test_weights(tmp_path, dtype):
    """Each vertex between two joints, in floats and in whole numbers that sum to the largest."""
    largest = 1 if dtype == np.float32 else np.iinfo(dtype).max
    first = np.array([0, 0.25, 0.5, 1]) if dtype == np.float32 else np.array([0, largest // 3, largest // 2, largest])
    weights = np.zeros((4, 4), dtype)
    weights[:, 0], weights[:, 1] = first, largest - first
    builder = skinned([{}, {"translation": [10, 0, 0]}, {"translation": [0, 20, 0]}], BOTH, weights, skin=[1, 2])
    if dtype != np.float32:
        builder.tables["accessors"][2]["normalized"] = True
    share = (first / largest)[:, np.newaxis]
    naive = CORNERS + share * [10, 0, 0] + (1 - share) * [0, 20, 0]
    assert builder.loaded(tmp_path).positions == pytest.approx(naive, abs=1e-6)


def test_eight_joints_a_vertex(tmp_path):
    quarter = np.float32([[0.125] * 4] * 4)
    builder = skinned([{}, {"translation": [8, 0, 0]}, {"translation": [0, 8, 0]}], FIRST, quarter, skin=[1, 2],
                      JOINTS_1=np.ones((4, 4), np.uint16), WEIGHTS_1=quarter)  # fmt: skip
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + np.float32([4, 4, 0]))


def test_normals(tmp_path):
    """By the inverse transpose of the sum of matrices."""
    normals = np.float32([[1, 0, 1]] * 4)
    builder = skinned([{}, {"scale": [2, 1, 4]}, {"scale": [6, 1, 4]}], BOTH, HALF, skin=[1, 2], NORMAL=normals)
    loaded = builder.loaded(tmp_path)
    assert np.array_equal(loaded.normals, [[0.25, 0, 0.25]] * 4)
    assert np.array_equal(loaded.positions, CORNERS * np.float32([4, 1, 4]))


def test_joints_that_mirror(tmp_path):
    """A negative determinant of the joints turns the triangles; that of the node has no part in it."""
    assert volume(skinned([{}, {"scale": [-1, 1, 1]}]).loaded(tmp_path)) == pytest.approx(1 / 6)
    assert volume(skinned([{"scale": [-1, 1, 1]}, {}]).loaded(tmp_path)) == pytest.approx(1 / 6)
    joints = np.uint8([[0] * 4, [0] * 4, [1] * 4, [1] * 4])
    third = {"rotation": [0.5, 0.5, 0.5, 0.5]}  # of a turn: x becomes y, y z and z x
    assert volume(skinned([{}, third]).loaded(tmp_path)) == pytest.approx(1 / 6)
    mixed = skinned([{}, {"scale": [-1, 1, 1]}, {}], joints, skin=[1, 2])
    assert refusal(mixed, tmp_path) == f"{PLACE}: expected joints that all mirror or none, got both{AGAIN}"


def test_joint_of_scale_zero_leaves_no_normals(tmp_path):
    joints = np.uint8([[0] * 4, [0] * 4, [1] * 4, [1] * 4])
    normals = np.float32([[0, 0, 1]] * 4)
    loaded = skinned([{}, {"scale": [0, 0, 0]}, {}], joints, skin=[1, 2], NORMAL=normals).loaded(tmp_path)
    assert np.array_equal(loaded.positions, [[0, 0, 0], [0, 0, 0], CORNERS[2], CORNERS[3]])
    assert loaded.notes == ("normals computed: 2 of the file's 4 are zero or not finite",)


def test_a_mesh_at_a_node_without_skin_is_placed_by_the_node(tmp_path):
    builder = skinned([{"translation": [0, 5, 0]}, {"translation": [10, 0, 0]}])
    del builder.tables["nodes"][0]["skin"]
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + np.float32([0, 5, 0]))


def test_one_mesh_in_two_poses(tmp_path):
    builder = skinned([{}, {"translation": [10, 0, 0]}, {"translation": [0, 0, 30]}, {"mesh": 0, "skin": 1}])
    builder.tables["scenes"] = [{"nodes": [3, 0, 1, 2]}]
    builder.add("skins", {"joints": [2]})
    loaded = corners(builder.loaded(tmp_path)).reshape(2, 12, 3).min(axis=1)
    assert np.array_equal(loaded, [[0, 0, 30], [10, 0, 0]])


def test_weights_that_do_not_matter(tmp_path):
    """A joint that is not there, at weight 0; a sum that is off by rounding, which is divided out."""
    joints, weights = np.uint8([[0, 200, 0, 0]] * 4), np.float32([[0.9990234375, 0, 0, 0]] * 4)
    builder = skinned([{}, {"translation": [10, 0, 0]}], joints, weights)
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + np.float32([10, 0, 0]))


def without(name):
    builder = skinned([{}, {}])
    del builder.tables["meshes"][0]["primitives"][0]["attributes"][name]
    return builder


NOT_AFFINE = np.eye(4)
NOT_AFFINE[3] = 0, 0, 1, 1
BAD = {
    "no joints": (without("JOINTS_0"), f"{PLACE}: expected JOINTS_0, as its node has a skin, got none"),
    "no weights": (without("WEIGHTS_0"), f"{PLACE}: expected WEIGHTS_0 for its JOINTS_0, got none"),
    "no such joint": (
        skinned([{}, {}], np.uint8([[0] * 4] * 3 + [[1] * 4])),
        f"{PLACE}.attributes.JOINTS_0: expected joints from 0 to 0, got 1 at vertex 3",
    ),
    "weights that sum to 2": (
        skinned([{}, {}], weights=np.float32([[1, 0, 0, 0]] * 2 + [[1, 1, 0, 0]] * 2)),
        f"{PLACE}.attributes: expected weights that sum to 1, got 2 at vertex 2",
    ),
    "no weight at all": (
        skinned([{}, {}], weights=np.zeros((4, 4), np.float32)),
        f"{PLACE}.attributes: expected weights that sum to 1, got 0 at vertex 0",
    ),
    "negative weights": (
        skinned([{}, {}], weights=np.float32([[2, -1, 0, 0]] * 4)),
        f"{PLACE}.attributes.WEIGHTS_0: expected finite weights >= 0, got others",
    ),
    "weights without number": (
        skinned([{}, {}], weights=np.float32([[np.nan, 0, 0, 0]] * 4)),
        f"{PLACE}.attributes.WEIGHTS_0: expected finite weights >= 0, got others",
    ),
    "joints as floats": (
        skinned([{}, {}], joints=np.zeros((4, 4), np.float32)),
        f"{PLACE}.attributes.JOINTS_0: expected VEC4 of unsigned byte or unsigned short, got VEC4 of float",
    ),
    "too few bind matrices": (
        skinned([{}, {}, {}], binds=[np.eye(4)], skin=[1, 2]),
        "skins[0].inverseBindMatrices: expected a matrix for each of 2 joints, got 1",
    ),
    "projecting bind matrices": (
        skinned([{}, {}], binds=[NOT_AFFINE]),
        "skins[0].inverseBindMatrices: expected finite matrices with the last row [0, 0, 0, 1], got another",
    ),
    "no such node": (skinned([{}, {}], skin=[5]), "skins[0].joints[0]: expected the number of one of the nodes, got 5"),
    "the node behind the last": (
        skinned([{}, {}], skin=[2]),
        "skins[0].joints[0]: expected the number of one of the nodes, got 2",
    ),
    "no joint": (skinned([{}, {}], skin=[]), "skins[0].joints: expected at least 1 values, got []"),
}


@pytest.mark.parametrize("builder, expected", BAD.values(), ids=BAD)
def test_bad_skin(tmp_path, builder, expected):
    assert refusal(builder, tmp_path) == f"{expected}{AGAIN}"


def test_joint_inside_itself(tmp_path):
    builder = skinned([{}, {}, {"children": [3]}, {"children": [2]}], skin=[2])
    assert refusal(builder, tmp_path) == f"nodes[2]: expected a node below a root, got one inside itself{AGAIN}"


def test_normals_of_a_place_without_volume_are_missing_and_of_any_other_turned_by_the_inverse():
    """Scaled by 1, 2 and 4: by the inverse transpose 1, 1/2 and 1/4; flat in z: none."""
    flat, scaled, turned = np.diag([1.0, 2, 0]), np.diag([1.0, 2, 4]), np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    places = np.stack([np.column_stack([each, [5.0, 6, 7]]) for each in (flat, scaled, turned)])
    found = _for_normals(places)
    assert found.shape == (3, 3, 4) and not found[..., 3].any()
    assert found[:, :, :3].tolist() == [np.zeros((3, 3)).tolist(), np.diag([1, 0.5, 0.25]).tolist(), turned.tolist()]
