"""Small meshes as text, and what a loaded one measures."""

import numpy as np

from sss_ref.errors import MeshError
from sss_ref.scene import load_mesh

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
TETRAHEDRON = {"triangles": 4, "area": 2.36603, "volume": 0.16667}  # 3/2 + sqrt(3)/2, 1/6


def rows(values):
    """One line of text for each row of numbers."""
    return "".join(" ".join(map(str, row)) + "\n" for row in values)


def loaded(folder, name, content):
    """The mesh of a file with this content."""
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return load_mesh(path)


def refusal(folder, name, content):
    """What is said of such a file, without its path."""
    try:
        loaded(folder, name, content)
    except MeshError as error:
        assert "\n" not in str(error) and str(error).startswith(f"{folder / name}: ")
        return str(error).removeprefix(f"{folder / name}: ")
    raise AssertionError("it was read")


def corners(mesh):
    """The corners of all triangles (T, 3, 3), float64."""
    return mesh.positions[mesh.triangles].astype(np.float64)


def measured(mesh):
    """How many triangles, their area and the volume they enclose, to five decimals."""
    a, b, c = np.moveaxis(corners(mesh), 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    volume = (a * np.cross(b, c)).sum() / 6
    return {"triangles": len(a), "area": round(area, 5), "volume": round(volume, 5)}


def centres(mesh):
    """The sums of each triangle's corners along x, in the mesh's order: which triangle comes when."""
    return corners(mesh)[:, :, 0].sum(axis=1).tolist()
