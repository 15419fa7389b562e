"""Numbers of accessors; the right values are those of the specification's formulas (glTF 2.0, 3.6 and 3.11)."""

import numpy as np
import pytest
from gltf_files import CORNERS, FACES, GltfBuilder, area, refusal, tetrahedron, volume

from sss_ref.mesh.gltf import accessors

QUANTIZED = {"extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"]}


def padded(array):
    """Bytes of a view whose elements start at multiples of 4."""
    rows = [row.tobytes() for row in np.asarray(array)]
    stride = -(-len(rows[0]) // 4) * 4
    return b"".join(row.ljust(stride, b"\0") for row in rows), stride


def with_attribute(name, array, normalized, **top):
    """A tetrahedron with an attribute in elements that start at multiples of 4."""
    builder = GltfBuilder(**top)
    content, stride = padded(array)
    number = builder.accessor(array, normalized=normalized)
    builder.tables["accessors"][number]["bufferView"] = builder.view(content, byteStride=stride)
    builder.add("meshes", {"primitives": [builder.primitive(**{name: number})]})
    return builder


INTEGERS = [  # stored, divisor
    (np.array([[0, 255], [255, 0], [1, 128], [254, 77]], np.uint8), 255),
    (np.array([[0, 65535], [65535, 0], [1, 32768], [16384, 77]], np.uint16), 65535),
]


@pytest.mark.parametrize("stored, largest", INTEGERS, ids=["byte", "short"])
def test_normalized_uvs(tmp_path, stored, largest):
    u, v = stored.astype(np.float64).T / largest
    loaded = with_attribute("TEXCOORD_0", stored, True).loaded(tmp_path)
    assert np.array_equal(loaded.uvs, np.stack([u, 1 - v], axis=1).astype(np.float32))
    assert loaded.shifted == 0 and loaded.notes == ()


SIGNED = [
    (np.int8, 127, True),
    (np.uint8, 255, True),
    (np.int16, 32767, True),
    (np.uint16, 65535, True),
    (np.int8, 127, False),
    (np.uint8, 255, False),
    (np.int16, 32767, False),
    (np.uint16, 65535, False),
]


@pytest.mark.parametrize("dtype, largest, normalized", SIGNED)
def test_quantized_positions(tmp_path, dtype, largest, normalized):
    low = np.iinfo(dtype).min
    stored = np.array([[0, 0, 0], [largest, 0, 0], [0, largest // 2, 0], [low, 1, largest]], dtype)
    loaded = with_attribute("POSITION", stored, normalized, **QUANTIZED).loaded(tmp_path)
    wanted = np.maximum(stored / largest, -1) if normalized else stored
    assert np.array_equal(loaded.positions, wanted.astype(np.float32))


@pytest.mark.parametrize("dtype, largest", [(np.int8, 127), (np.int16, 32767)])
def test_quantized_normals(tmp_path, dtype, largest):
    stored = np.array([[0, 0, largest], [-largest, 0, 0], [1, 2, 3], [-largest - 1, 0, 5]], dtype)
    loaded = with_attribute("NORMAL", stored, True, **QUANTIZED).loaded(tmp_path)
    assert loaded.normals_source == "file"
    assert np.array_equal(loaded.normals, np.maximum(stored / largest, -1).astype(np.float32))


def test_quantized_positions_under_the_scale_of_their_node(tmp_path):
    """gltfpack's way: whole numbers, and a node that scales and moves them back."""
    stored = (CORNERS * 16383).astype(np.uint16)
    builder = with_attribute("POSITION", stored, False, **QUANTIZED)
    builder.tables["nodes"] = [{"mesh": 0, "scale": [1 / 16383] * 3, "translation": [5, 0, 0]}]
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS + np.float32([5, 0, 0]))


def test_whole_numbers_need_the_extension(tmp_path):
    stored = (CORNERS * 255).astype(np.uint8)
    assert refusal(with_attribute("POSITION", stored, False), tmp_path) == (
        "meshes[0].primitives[0].attributes.POSITION: expected VEC3 of float, got VEC3 of unsigned byte; "
        "name KHR_mesh_quantization in extensionsRequired, or export floats"
    )
    assert refusal(with_attribute("TEXCOORD_0", stored[:, :2], False), tmp_path) == (
        "meshes[0].primitives[0].attributes.TEXCOORD_0: expected VEC2 of float or unsigned byte normalized or "
        "unsigned short normalized, got VEC2 of unsigned byte; "
        "name KHR_mesh_quantization in extensionsRequired, or export floats"
    )


def test_interleaved(tmp_path):
    """Position, normal and UV of a vertex side by side."""
    normals, uvs = (
        np.float32([[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, -1]]),
        np.float32([[0, 0], [1, 0], [0, 1], [1, 1]]),
    )
    rows = np.concatenate([CORNERS, normals, uvs], axis=1)
    builder = GltfBuilder()
    view = builder.view(rows.tobytes(), byteStride=32)
    places = [("POSITION", 0, "VEC3"), ("NORMAL", 12, "VEC3"), ("TEXCOORD_0", 24, "VEC2")]
    numbers = {
        name: builder.add(
            "accessors", {"bufferView": view, "byteOffset": offset, "componentType": 5126, "count": 4, "type": kind}
        )
        for name, offset, kind in places
    }
    builder.add("meshes", {"primitives": [builder.primitive(**numbers)]})
    loaded = builder.loaded(tmp_path)
    assert np.array_equal(loaded.positions, CORNERS) and np.array_equal(loaded.normals, normals)
    assert np.array_equal(loaded.uvs, uvs * [1, -1] + [0, 1])


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.uint32])
def test_indices(tmp_path, dtype):
    builder = GltfBuilder()
    builder.add("meshes", {"primitives": [builder.primitive(FACES.astype(dtype))]})
    assert np.array_equal(builder.loaded(tmp_path).triangles, FACES.reshape(-1, 3))


def test_no_indices(tmp_path):
    builder = GltfBuilder()
    builder.add("meshes", {"primitives": [builder.primitive(None, POSITION=CORNERS[FACES])]})
    loaded = builder.loaded(tmp_path)
    assert np.array_equal(loaded.triangles, np.arange(12).reshape(4, 3)) and volume(loaded) == pytest.approx(1 / 6)


def sparse(builder, count, indices, values, **base):
    """A sparse accessor of vectors. base: its view, or none."""
    changed = {
        "count": len(indices),
        "indices": {"bufferView": builder.view(indices.tobytes()), "componentType": 5121 + 2 * (indices.itemsize // 2)},
        "values": {"bufferView": builder.view(values.tobytes())},
    }
    entry = {"componentType": 5126, "count": count, "type": "VEC3", "sparse": changed, **base}
    return builder.add("accessors", entry)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.uint32])
def test_sparse_positions(tmp_path, dtype):
    """The apex of the tetrahedron at height 2: area 4, volume 1/3."""
    builder = GltfBuilder()
    view = builder.view(CORNERS.tobytes())
    number = sparse(builder, 4, np.array([3], dtype), np.float32([[0, 0, 2]]), bufferView=view)
    builder.add("meshes", {"primitives": [builder.primitive(POSITION=number)]})
    loaded = builder.loaded(tmp_path)
    assert area(loaded) == pytest.approx(4) and volume(loaded) == pytest.approx(1 / 3)
    assert np.array_equal(loaded.positions, [*CORNERS[:3], [0, 0, 2]])


def test_sparse_without_a_view_starts_at_zero(tmp_path):
    builder = GltfBuilder()
    number = sparse(builder, 4, np.array([1, 2, 3], np.uint16), CORNERS[1:])
    builder.add("meshes", {"primitives": [builder.primitive(POSITION=number)]})
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS)


def test_sparse_values_may_be_normalized(tmp_path):
    """The divisor is that of the base's component type."""
    builder = GltfBuilder()
    number = builder.accessor(np.uint16([[0, 65535]] * 4), normalized=True)
    places, values = builder.view(b"\2"), builder.view(np.uint16([[65535, 0]]).tobytes())
    builder.tables["accessors"][number]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": places, "componentType": 5121},
        "values": {"bufferView": values},
    }
    builder.add("meshes", {"primitives": [builder.primitive(TEXCOORD_0=number)]})
    assert np.array_equal(builder.loaded(tmp_path).uvs, [[0, 0], [0, 0], [1, 1], [0, 0]])


@pytest.mark.parametrize("indices", [[2, 1], [1, 1], [1, 4]])
def test_sparse_indices_that_do_not_rise(tmp_path, indices):
    builder = GltfBuilder()
    number = sparse(builder, 4, np.array(indices, np.uint8), CORNERS[:2])
    builder.add("meshes", {"primitives": [builder.primitive(POSITION=number)]})
    assert refusal(builder, tmp_path) == (
        "meshes[0].primitives[0].attributes.POSITION: expected sparse indices that rise, below 4, got others; "
        "export the mesh again"
    )


def test_more_sparse_elements_than_there_are(tmp_path):
    builder = GltfBuilder()
    number = sparse(builder, 4, np.array([1], np.uint8), CORNERS[:1])
    builder.tables["accessors"][number]["sparse"]["count"] = 5
    builder.add("meshes", {"primitives": [builder.primitive(POSITION=number)]})
    assert "expected 5 bytes in bufferViews[0], got 1" in refusal(builder, tmp_path)


def test_accessor_without_a_view_is_zero(tmp_path):
    builder = GltfBuilder()
    zeros = builder.add("accessors", {"componentType": 5126, "count": 4, "type": "VEC3"})
    builder.add("meshes", {"primitives": [builder.primitive(NORMAL=zeros)]})
    assert builder.loaded(tmp_path).notes == ("normals computed: 4 of the file's 4 are zero or not finite",)


POSITION = "meshes[0].primitives[0].attributes.POSITION: "
AGAIN = "; export the mesh again"
BAD_ACCESSORS = {
    "beyond its view": ({"count": 5}, POSITION + f"expected 60 bytes in bufferViews[0], got 48{AGAIN}"),
    "offset beyond its view": (
        {"byteOffset": 4},
        POSITION + f"expected 52 bytes in bufferViews[0], got 48{AGAIN}",
    ),
    "not aligned": (
        {"byteOffset": 2, "count": 3},
        POSITION + "expected components that are aligned to 4 bytes, got byteOffset 2 in bufferViews[0], "
        f"which starts at 0, stride 12{AGAIN}",
    ),
    "no such view": (
        {"bufferView": 9},
        POSITION + f"expected the number of one of the bufferViews, got 9 of 2 (they count from 0){AGAIN}",
    ),
    "no vector": ({"type": "VEC2"}, POSITION + f"expected VEC3 of float, got VEC2 of float{AGAIN}"),
    "normalized floats": (
        {"normalized": True},
        POSITION + f"expected VEC3 of float, got VEC3 of float normalized{AGAIN}",
    ),
    "double": (
        {"componentType": 5130},
        f"accessors[0].componentType: expected 5120, 5121, 5122, 5123, 5125 or 5126, got 5130{AGAIN}",
    ),
    "none": ({"count": 0}, f"accessors[0].count: expected at least 1, got 0{AGAIN}"),
    "less than none": ({"count": -1}, f"accessors[0].count: expected at least 0, got -1{AGAIN}"),
    "a count of text": ({"count": "4"}, f'accessors[0].count: expected a whole number, got "4"{AGAIN}'),
    "a broken count": ({"count": 3.5}, f"accessors[0].count: expected a whole number, got 3.5{AGAIN}"),
    "too many": (
        {"count": 10**9, "bufferView": None},
        POSITION + "expected at most 16777216 elements, got 1000000000; simplify the mesh",
    ),
}


@pytest.mark.parametrize("changes, expected", BAD_ACCESSORS.values(), ids=BAD_ACCESSORS)
def test_bad_accessor(tmp_path, changes, expected):
    builder = tetrahedron()
    builder.tables["accessors"][0] |= changes
    assert refusal(builder, tmp_path) == expected


def test_view_that_is_not_aligned(tmp_path):
    builder = tetrahedron()
    builder.tables["bufferViews"][0] |= {"byteOffset": 2}
    assert refusal(builder, tmp_path) == (
        POSITION + "expected components that are aligned to 4 bytes, got byteOffset 0 in bufferViews[0], "
        f"which starts at 2, stride 12{AGAIN}"
    )


def test_count_may_be_written_with_a_point(tmp_path):
    builder = tetrahedron()
    builder.tables["accessors"][0]["count"] = 4.0
    assert len(builder.loaded(tmp_path).positions) == 4


BAD_STRIDES = [
    (0, 8, POSITION + f"expected a byteStride of at least 12 in bufferViews[0], got 8{AGAIN}"),
    (0, 14, POSITION + "expected components that are aligned to 4 bytes, got byteOffset 0 in bufferViews[0], "
     f"which starts at 0, stride 14{AGAIN}"),
    (0, 16, POSITION + f"expected 60 bytes in bufferViews[0], got 48{AGAIN}"),
    (0, 0, f"bufferViews[0].byteStride: expected at least 4, got 0{AGAIN}"),
    (0, 256, f"bufferViews[0].byteStride: expected at most 252, got 256{AGAIN}"),
    (1, 4, f"meshes[0].primitives[0].indices: expected a byteStride of 2 in bufferViews[1], got 4{AGAIN}"),
]  # fmt: skip


@pytest.mark.parametrize("view, stride, expected", BAD_STRIDES)
def test_bad_stride(tmp_path, view, stride, expected):
    builder = tetrahedron()
    builder.tables["bufferViews"][view]["byteStride"] = stride
    assert refusal(builder, tmp_path) == expected


def test_attributes_of_different_lengths(tmp_path):
    builder = GltfBuilder()
    builder.add("meshes", {"primitives": [builder.primitive(TEXCOORD_0=np.zeros((3, 2), np.float32))]})
    assert refusal(builder, tmp_path) == (
        f"meshes[0].primitives[0].attributes.TEXCOORD_0: expected 4 elements, as many as the others, got 3{AGAIN}"
    )


def test_work_is_bounded(tmp_path, monkeypatch):
    """4 vertices and 12 corners are read at each of 3 nodes, and each primitive counts 1."""
    builder = tetrahedron(nodes=[{"mesh": 0}] * 3, scenes=[{"nodes": [0, 1, 2]}])
    monkeypatch.setattr(accessors, "BUDGET", 3 * 17 - 1)
    expected = "expected at most 50 vertices and corners over all nodes, got more; simplify the mesh"
    assert refusal(builder, tmp_path) == f"nodes: {expected}"
    monkeypatch.setattr(accessors, "BUDGET", 3 * 17)
    assert len(builder.loaded(tmp_path).triangles) == 12


def test_an_accessor_has_no_more_elements_than_may_be_read_in_all(tmp_path, monkeypatch):
    """Of a tetrahedron that is drawn nowhere else: 12 corners, 4 vertices."""
    monkeypatch.setattr(accessors, "BUDGET", 11)
    assert refusal(tetrahedron(), tmp_path) == (
        "meshes[0].primitives[0].indices: expected at most 11 elements, got 12; simplify the mesh"
    )
    monkeypatch.setattr(accessors, "BUDGET", 12)
    expected = "expected at most 12 vertices and corners over all nodes, got more; simplify the mesh"
    assert refusal(tetrahedron(), tmp_path) == f"nodes: {expected}"
