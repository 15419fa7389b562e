import io
import json
import os

import numpy as np
import pytest

from sss_ref.errors import MeshError
from sss_ref.mesh.array_folder import is_array_folder, read_arrays, write_arrays
from sss_ref.mesh.materials import Material
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.mesh.triangles import Mesh

MESH = Mesh(
    "pair.obj",
    np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.1]]),
    np.float32([[0, 0, 1]] * 4),
    np.float32([[0, 0], [1, 0], [0, 1], [1, 1]]),
    np.int32([[0, 1, 2], [1, 3, 2]]),
    np.int32([1, 0]),
    (Material("red", (0.9, 0.1, 1 / 3)), Material()),
    "computed",
    notes=("a note",),
)


@pytest.fixture
def folder(tmp_path):
    write_arrays(MESH, tmp_path)
    return tmp_path


def test_a_mesh_comes_back_bit_for_bit(folder):
    found = load_mesh(folder)
    assert found.hashes() == MESH.hashes()
    for name in ("name", "materials", "normals_source", "notes"):
        assert getattr(found, name) == getattr(MESH, name)
    assert is_array_folder(folder) and not is_array_folder(folder.parent)


def test_a_mesh_without_uvs_stays_without(tmp_path):
    write_arrays(Mesh(**{**vars(MESH), "uvs": None}), tmp_path)
    assert read_arrays(tmp_path).uvs is None and not np.load(tmp_path / "uv.npy").any()


def saved(array, cut=None):
    file = io.BytesIO()
    np.save(file, array, allow_pickle=True)
    return file.getvalue()[:cut]


@pytest.mark.parametrize(
    ("name", "data", "message"),
    [
        ("position.npy", saved(np.zeros((4, 3))), r"expected float32 \(N, 3\), got float64 \(4, 3\); write the bundle"),
        ("position.npy", saved(MESH.positions.T), r"expected float32 \(N, 3\), got float32 \(3, 4\)"),
        ("position.npy", saved(np.zeros((0, 3), np.float32)), "expected"),
        (
            "position.npy",
            saved(MESH.positions[:3]),
            "expected as many rows in position and normal and uv, got position 3",
        ),
        (
            "position.npy",
            saved(np.full((4, 3), np.inf, np.float32)),
            "expected numbers that are finite in float32, got",
        ),
        ("position.npy", saved(np.ones((4, 3), np.float32)), "expected a mesh of some size, got all vertices at one"),
        ("normal.npy", saved(MESH.normals, -1), "expected a whole NPY file, got one that is damaged or cut off"),
        ("normal.npy", saved(np.array([object()])), "expected a whole NPY file, got one that is damaged or cut off"),
        ("normal.npy", b"PK\3\4", r"expected float32 \(N, 3\), got an archive; write the bundle"),
        ("normal.npy", b"", "expected a whole NPY file, got one that is damaged or cut off"),
        ("triangles.npy", saved(np.int32([[0, 1, 4], [0, 1, 2]])), "expected vertex indices from 0 to 3, got"),
        (
            "triangles.npy",
            saved(MESH.triangles[:1]),
            "expected as many rows in triangles and material, got triangles 1",
        ),
        ("material.npy", saved(np.int32([0, 2])), "expected numbers of 2 materials, got others"),
        ("mesh.json", b"[]", "mesh.json: file: expected what a bundle says of its mesh, got something else"),
        ("mesh.json", b"\xff", "mesh.json: expected what a bundle says of its mesh in UTF-8, got"),
    ],
)
def test_files_that_are_damaged_or_do_not_fit(folder, name, data, message):
    (folder / name).write_bytes(data)
    with pytest.raises(MeshError, match=message):
        read_arrays(folder)


def test_the_error_names_the_field(folder):
    record = json.loads((folder / "mesh.json").read_text())
    (folder / "mesh.json").write_text(json.dumps(record | {"normals": "guessed"}))
    with pytest.raises(MeshError, match=r"mesh\.json: normals: expected what a bundle says of its mesh"):
        read_arrays(folder)


def test_a_pipe_is_never_waited_for(folder):
    (folder / "uv.npy").unlink()
    os.mkfifo(folder / "uv.npy")
    with pytest.raises(MeshError, match="expected an NPY file, got no regular file; copy its content to one"):
        read_arrays(folder)
