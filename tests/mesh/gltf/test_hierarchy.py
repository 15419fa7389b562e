"""The order of nodes and their transforms (glTF 2.0, 3.5)."""

import numpy as np
import pytest
from gltf_files import CORNERS, corners, message, refusal, tetrahedron, volume

from sss_ref.mesh.gltf import hierarchy

AGAIN = "; export the mesh again"


def placed(nodes, **top):
    """The tetrahedron seen through nodes; each has the mesh unless it says mesh = None."""
    nodes = [{key: value for key, value in {"mesh": 0, **node}.items() if value is not None} for node in nodes]
    return tetrahedron(nodes=nodes, **top)


def lefts(mesh):
    """The least x of each tetrahedron, in order."""
    return corners(mesh)[:, :, 0].min(axis=1).reshape(-1, 4).min(axis=1).tolist()


def moved(*offsets):
    return [{"translation": [x, 0, 0]} for x in offsets]


def test_triangles_come_in_the_order_of_the_scene(tmp_path):
    assert lefts(placed(moved(0, 10, 20), scenes=[{"nodes": [0, 1, 2]}]).loaded(tmp_path)) == [0, 10, 20]
    assert lefts(placed(moved(0, 10, 20), scenes=[{"nodes": [2, 0, 1]}]).loaded(tmp_path)) == [20, 0, 10]


def test_a_node_comes_before_its_children_and_they_in_their_order(tmp_path):
    nodes = moved(1, 10, 100, 1000, 10000)
    nodes[0]["children"] = [3, 1]
    nodes[3]["children"] = [2]
    loaded = placed(nodes, scenes=[{"nodes": [4, 0]}]).loaded(tmp_path)
    assert lefts(loaded) == [10000, 1, 1001, 1101, 11]


def test_nodes_outside_the_scene_are_not_read(tmp_path):
    assert lefts(placed(moved(0, 10), scenes=[{"nodes": [0]}, {"nodes": [1]}], scene=1).loaded(tmp_path)) == [10]


def test_without_a_choice_the_first_scene_is_shown(tmp_path):
    assert lefts(placed(moved(0, 10), scenes=[{"nodes": [1]}, {"nodes": [0]}], scene=None).loaded(tmp_path)) == [10]


def test_without_scenes_all_roots_are_shown(tmp_path):
    nodes = moved(5, 10, 20)
    nodes[2]["children"] = [0]
    assert lefts(placed(nodes, scenes=None, scene=None).loaded(tmp_path)) == [10, 20, 25]


def test_scene_without_nodes(tmp_path):
    expected = "expected at least one triangle, got none; export the mesh as triangles or polygons"
    assert refusal(placed([{}], scenes=[{}]), tmp_path) == expected


def test_translation_rotation_scale(tmp_path):
    """Scaled first, then a quarter turn about z, then moved; the parent last."""
    half = 0.5**0.5
    child = {"translation": [1, 2, 3], "rotation": [0, 0, half, half], "scale": [2, 3, 4]}
    nodes = [{"mesh": None, "children": [1], "translation": [0, 0, 10]}, child]
    loaded = placed(nodes).loaded(tmp_path)
    assert loaded.positions == pytest.approx(np.array([[1, 2, 13], [1, 4, 13], [-2, 2, 13], [1, 2, 17]]), abs=1e-6)
    assert volume(loaded) == pytest.approx(24 / 6)


def test_a_rotation_about_no_axis_of_the_coordinates(tmp_path):
    """By hand: 1 - 2(yy + zz) = .64, 2(xy + zw) = .6, 2(xz - yw) = -.48 is where x goes, and so on."""
    loaded = placed([{"rotation": [0.1, 0.3, 0.3, 0.9]}]).loaded(tmp_path)
    turned = np.float32([[0, 0, 0], [0.64, 0.6, -0.48], [-0.48, 0.8, 0.36], [0.6, 0, 0.8]])
    assert loaded.positions == pytest.approx(turned, abs=1e-6)


@pytest.mark.parametrize(("length", "is_one"), [(0.99, True), (1.01, True), (0.9899, False), (1.0101, False)])
def test_a_quaternion_is_one_hundredth_longer_or_shorter_than_1_at_most(tmp_path, length, is_one):
    builder = placed([{"rotation": [0, 0, length, 0]}])
    if is_one:
        turned = builder.loaded(tmp_path).positions
        assert turned == pytest.approx(np.float32([[0, 0, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1]]), abs=1e-6)
    else:
        assert "expected a quaternion of length 1, got" in refusal(builder, tmp_path)


def test_matrix_is_stored_by_columns(tmp_path):
    matrix = [0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 1, 2, 3, 1]
    loaded = placed([{"matrix": matrix}]).loaded(tmp_path)
    assert np.array_equal(loaded.positions, [[1, 2, 3], [1, 4, 3], [-2, 2, 3], [1, 2, 7]])


@pytest.mark.parametrize("place", [{"scale": [-1, 1, 1]}, {"matrix": [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}])
def test_mirrored_triangles_are_turned_right_side_out(tmp_path, place):
    """A negative determinant means that triangles run clockwise seen from outside (glTF 2.0, 3.7.4)."""
    assert volume(placed([place]).loaded(tmp_path)) == pytest.approx(1 / 6)
    twice = [{"mesh": None, "scale": [1, -1, 1], "children": [1]}, place]
    assert volume(placed(twice).loaded(tmp_path)) == pytest.approx(1 / 6)


def test_normals_follow_the_inverse_transpose(tmp_path):
    builder = placed([{"scale": [2, 1, -4]}])
    builder.tables["meshes"] = []
    normals = np.float32([[1, 0, 1]] * 4)
    builder.add("meshes", {"primitives": [builder.primitive(NORMAL=normals)]})
    assert np.array_equal(builder.loaded(tmp_path).normals, [[0.5, 0, -0.25]] * 4)


def test_a_scale_of_zero_hides_a_node(tmp_path):
    loaded = placed([{}, {"scale": [0, 0, 0]}], scenes=[{"nodes": [0, 1]}]).loaded(tmp_path)
    assert len(loaded.triangles) == 4 and loaded.notes == ("nodes[1] not read: a scale of 0 hides it",)


def test_flattened_node(tmp_path):
    assert refusal(placed([{"scale": [1, 0, 1]}]), tmp_path) == (
        "meshes[0].primitives[0] at nodes[0]: expected transforms that can be inverted, got one that cannot; "
        "apply them before exporting"
    )


def test_invisible_nodes(tmp_path):
    """KHR_node_visibility hides a node and all below it."""
    nodes = moved(0, 10, 20)
    nodes[1] |= {"extensions": {"KHR_node_visibility": {"visible": False}}, "children": [2]}
    nodes[2]["extensions"] = {"KHR_node_visibility": {"visible": True}}
    loaded = placed(nodes, scenes=[{"nodes": [0, 1]}]).loaded(tmp_path)
    assert lefts(loaded) == [0] and loaded.notes == ("1 hidden nodes not read",)


def test_deep_chain(tmp_path):
    """Deeper than Python's stack."""
    nodes = [{"mesh": None, "translation": [1, 0, 0], "children": [n + 1]} for n in range(3000)]
    assert lefts(placed([*nodes, {}]).loaded(tmp_path)) == [3000]


ONE_ROOT = {"scenes": [{"nodes": [0]}]}
BAD = {
    "a node in itself": ([{"children": [0]}], {}, "scenes[0].nodes[0]: expected a root node, once, "
                         f"got nodes[0], a child of nodes[0]{AGAIN}"),
    "a node in two": (
        [{"children": [2]}, {"children": [2]}, {}], {"scenes": [{"nodes": [0, 1]}]},
        f"nodes[2]: expected one parent, got nodes[0] and nodes[1]{AGAIN}"),
    "a child twice": (
        [{"children": [1, 1]}, {}], {},
        f"nodes[1]: expected one parent, got nodes[0] and nodes[0]{AGAIN}"),
    "a child as root": (
        [{"children": [1]}, {}], {"scenes": [{"nodes": [0, 1]}]},
        f"scenes[0].nodes[1]: expected a root node, once, got nodes[1], a child of nodes[0]{AGAIN}"),
    "a root twice": (
        [{}], {"scenes": [{"nodes": [0, 0]}]},
        f"scenes[0].nodes[1]: expected a root node, once, got nodes[0], twice{AGAIN}"),
    "no such child": ([{"children": [1]}], {}, "nodes[0].children[0]: expected the number of one of the nodes, "
                      f"got 1 of 1 (they count from 0){AGAIN}"),
    "no such root": ([{}], {"scenes": [{"nodes": [3]}]}, "scenes[0].nodes[0]: expected the number of one of the nodes, "
                     f"got 3 of 1 (they count from 0){AGAIN}"),
    "no such scene": ([{}], {"scene": 4}, "scene: expected the number of one of the scenes, "
                      f"got 4 of 1 (they count from 0){AGAIN}"),
    "no such mesh": ([{"mesh": 7}], {}, "nodes[0].mesh: expected the number of one of the meshes, "
                     f"got 7 of 1 (they count from 0){AGAIN}"),
    "both forms": ([{"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "scale": [1, 1, 1]}], {},
                   f"nodes[0]: expected a matrix, or translation, rotation and scale, got both{AGAIN}"),
    "projection": ([{"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1]}], {},
                   f"nodes[0].matrix: expected [0, 0, 0, 1] as last row, got [0.0, 0.0, 1.0, 1.0]{AGAIN}"),
    "fifteen numbers": ([{"matrix": [0] * 15}], {}, "nodes[0].matrix: expected at least 16 values, "
                        f"got [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]{AGAIN}"),
    "no unit quaternion": ([{"rotation": [0, 0, 0, 2]}], {}, "nodes[0].rotation: expected a quaternion of length 1, "
                           f"got [0.0, 0.0, 0.0, 2.0]{AGAIN}"),
    "text": ([{"translation": ["1", 0, 0]}], {}, f'nodes[0].translation[0]: expected a number, got "1"{AGAIN}'),
}  # fmt: skip


@pytest.mark.parametrize("nodes, top, expected", BAD.values(), ids=BAD)
def test_bad_nodes(tmp_path, nodes, top, expected):
    assert refusal(placed(nodes, **(ONE_ROOT | top)), tmp_path) == expected


@pytest.mark.parametrize("number", ["1e999", "-1e999", "1" + "0" * 400])
def test_number_that_is_too_large(tmp_path, number):
    path = placed([{"translation": [0.5, 0, 0]}]).written(tmp_path)
    path.write_text(path.read_text().replace("0.5", number))
    assert message(path).startswith("nodes[0].translation[0]: expected a ")


def test_many_nodes(tmp_path, monkeypatch):
    monkeypatch.setattr(hierarchy, "NODE_LIMIT", 1)
    assert len(placed([{}]).loaded(tmp_path).triangles) == 4
    assert refusal(placed([{}, {}]), tmp_path) == "nodes: expected at most 1, got 2; simplify the mesh"


def test_more_nodes_than_any_file_has(tmp_path):
    builder = placed([{}])
    builder.tables["nodes"] = [{}] * (2**17 + 1)
    assert refusal(builder, tmp_path) == "nodes: expected at most 131072, got 131073; simplify the mesh"


def test_positions_that_leave_float32(tmp_path):
    assert refusal(placed([{"scale": [1e39, 1, 1]}]), tmp_path) == (
        "meshes[0].primitives[0] at nodes[0]: expected positions that are finite in float32, "
        "got [1e+39, 0.0, 0.0] at vertex 1 (1 in all); correct them"
    )
    builder = placed([{}])
    bad = CORNERS.copy()
    bad[2, 1] = np.nan
    builder.tables["meshes"] = []
    builder.add("meshes", {"primitives": [builder.primitive(POSITION=bad)]})
    assert refusal(builder, tmp_path) == (
        "meshes[0].primitives[0] at nodes[0]: expected positions that are finite in float32, "
        "got [0.0, nan, 0.0] at vertex 2 (1 in all); correct them"
    )
