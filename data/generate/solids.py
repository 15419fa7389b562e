"""Write the solids with flat faces: `seam_cube`, `wedge` and `two_slabs`, each face a chart of its own.

Own work, no source data; lengths in scene units. `python data/generate/solids.py` writes data/meshes/<name>.obj, small
enough to read, and prints the figures that PROVENANCE.md records.
"""

import hashlib
from pathlib import Path

import numpy as np

MESHES = Path(__file__).parents[1] / "meshes"
MARGIN = 0.04  # between a chart and the border of its cell, in cells

Face = np.ndarray  # (3 or 4 corners, 3), counter-clockwise seen from outside


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> list[Face]:
    """The six faces of a box: -X, +X, -Y, +Y, -Z, +Z."""
    unit = [
        [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)],
        [(1, 0, 1), (1, 0, 0), (1, 1, 0), (1, 1, 1)],
        [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
        [(0, 1, 1), (1, 1, 1), (1, 1, 0), (0, 1, 0)],
        [(1, 0, 0), (0, 0, 0), (0, 1, 0), (1, 1, 0)],
        [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
    ]
    return [low + np.array(face) * np.subtract(high, low) for face in unit]


def seam_cube() -> list[Face]:
    """A cube of edge 2 around the origin: every edge is a seam."""
    return box((-1, -1, -1), (1, 1, 1))


def wedge() -> list[Face]:
    """A prism 2 wide: 1.2 thick at the bottom, an edge at the top, so that thickness falls evenly with height."""
    left, right = ([(x, -1, -0.6), (x, -1, 0.6), (x, 1, 0)] for x in (-1, 1))
    ends = [left, right[::-1]]
    sides = [[left[i], right[i], right[j], left[j]] for i, j in ((0, 1), (1, 2), (2, 0))]
    return [np.array(face) for face in ends + sides]


def two_slabs() -> list[Face]:
    """Two slabs 0.3 thick and 0.6 apart, the one half behind the other: a body that is not convex (paper 2.1)."""
    return box((-1.2, -0.8, -0.6), (0.4, 0.8, -0.3)) + box((-0.4, -0.6, 0.3), (1.2, 0.6, 0.6))


def unit_normal(face: Face) -> np.ndarray:
    """The normal of a flat face."""
    normal = np.cross(face[1] - face[0], face[2] - face[0])
    return normal / np.linalg.norm(normal)


def in_its_plane(face: Face) -> np.ndarray:
    """The corners (n, 2) in the plane of the face, its first edge along +u, the box of all at the origin."""
    along = (face[1] - face[0]) / np.linalg.norm(face[1] - face[0])
    plane = (face - face[0]) @ np.stack([along, np.cross(unit_normal(face), along)], 1)
    return plane - plane.min(0)


def charts(faces: list[Face]) -> list[np.ndarray]:
    """The UVs of every face, all at one scale, in the cells of a square grid, from the bottom left, row by row."""
    columns = int(np.ceil(np.sqrt(len(faces))))
    flat = [in_its_plane(face) for face in faces]
    scale = (1 - 2 * MARGIN) / max(uv.max() for uv in flat)
    return [(uv * scale + MARGIN + (i % columns, i // columns)) / columns for i, uv in enumerate(flat)]


def obj_text(faces: list[Face]) -> str:
    """Wavefront OBJ: corners and UVs face by face, one normal a face."""
    lines, first = [], 1
    for number, (face, uvs) in enumerate(zip(faces, charts(faces), strict=True), start=1):
        lines += [f"v {x:g} {y:g} {z:g}" for x, y, z in face]
        lines += [f"vt {u:.7g} {v:.7g}" for u, v in uvs]
        lines += ["vn {:.8g} {:.8g} {:.8g}".format(*(unit_normal(face) + 0.0))]
        lines += ["f " + " ".join(f"{k}/{k}/{number}" for k in range(first, first + len(face)))]
        first += len(face)
    return "\n".join(lines) + "\n"


def main() -> None:
    """Write the three solids; print triangles, size and SHA-256."""
    for make in (seam_cube, wedge, two_slabs):
        faces = make()
        data = f"# {make.__doc__}\n{obj_text(faces)}".encode()
        (MESHES / f"{make.__name__}.obj").write_bytes(data)
        triangles = sum(len(face) - 2 for face in faces)
        print(f"{make.__name__}.obj {triangles} triangles {len(data)} bytes {hashlib.sha256(data).hexdigest()}")


if __name__ == "__main__":
    main()
