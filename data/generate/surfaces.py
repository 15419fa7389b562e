"""Write the meshes given by a formula: `sphere`, `torus`, `stretched_plane` and the faceted `teaching`.

Each is a grid over the unit square of UVs, bent into its shape. Own work, no source data; lengths in scene units.
`python data/generate/surfaces.py` writes data/meshes/<name>.glb and prints the figures that PROVENANCE.md records.
"""

from pathlib import Path

import numpy as np
import trimesh
from export import write

MESHES = Path(__file__).parents[1] / "meshes"
SHEET_ARC = np.pi / 2  # radians that the sheet arches over
SHEET_STRETCH = 2  # its u is the square of the way along the arc: the outermost columns of quads differ 1 : 95
SHEET_TOP = 0.94  # of v; above it lie the charts of the slats
SLATS = np.linspace(-0.84, 0.84, 8)  # middles, x
SLAT_WIDTH = 0.12

# Radius and height of the mushroom's rings: foot, gills, cap.
MUSHROOM = np.array([(0, -0.95), (0.4, -0.95), (0.27, 0.06), (1, -0.1), (0.68, 0.45), (0, 0.7)])
MUSHROOM_SIDES = 6

Grid = np.ndarray  # (rows + 1, columns + 1, any)


def around(radius: np.ndarray, height: np.ndarray, turn: np.ndarray) -> Grid:
    """Points at these radii from the Y axis and heights, turned by `turn` full turns from -Z to -X, +Z and +X."""
    angle = 2 * np.pi * turn
    return np.stack(np.broadcast_arrays(-radius * np.sin(angle), height, -radius * np.cos(angle)), -1)


def unit_square(columns: int, rows: int) -> tuple[np.ndarray, np.ndarray]:
    """u (1, columns + 1) and v (rows + 1, 1) of a grid's corners."""
    return np.linspace(0, 1, columns + 1)[None], np.linspace(0, 1, rows + 1)[:, None]


def sphere() -> trimesh.Trimesh:
    """The unit sphere, 96 meridians, 48 rows; the poles are at v = 0 and 1, the seam on -Z."""
    u, v = unit_square(96, 48)
    points = around(np.sin(np.pi * v), -np.cos(np.pi * v), u)
    return smooth(points, points, u, v)


def torus() -> trimesh.Trimesh:
    """A tube of radius 0.4 around the unit circle in the XZ plane; v = 0 and 1 are its inner rim."""
    u, v = unit_square(96, 32)
    across, up = -np.cos(2 * np.pi * v), -np.sin(2 * np.pi * v)
    return smooth(around(1 + 0.4 * across, 0.4 * up, u), around(across, up, u), u, v)


def stretched_plane() -> trimesh.Trimesh:
    """A sheet 2 high, arched to +Z; its left end has hardly any room in the UV map, its right end too much.

    Even slats run to +Z above it, so that a high light draws stripes, all equally sharp, down the sheet.
    """
    u, v = unit_square(48, 24)
    angle = (u - 0.5) * SHEET_ARC
    normals = np.stack(np.broadcast_arrays(np.sin(angle), 0 * v, np.cos(angle)), -1)
    points = normals * np.sqrt(2) + np.stack(np.broadcast_arrays(0 * u, 2 * v - 1, 0 * u - 1.2), -1)
    sheet = smooth(points, normals, u**SHEET_STRETCH, v * SHEET_TOP)
    return together([sheet, *(slat(x, number / len(SLATS)) for number, x in enumerate(SLATS))])


def slat(middle: float, first_u: float) -> trimesh.Trimesh:
    """A level strip above the sheet, from its plane to +Z."""
    u, v = unit_square(1, 1)
    x, z = middle + (u - 0.5) * SLAT_WIDTH, 1.7 * (1 - v)
    points = np.stack(np.broadcast_arrays(x, 1.3, z), -1)
    up = np.broadcast_to([0.0, 1.0, 0.0], points.shape)
    return smooth(points, up, first_u + 0.02 + 0.08 * u, SHEET_TOP + 0.02 + 0.03 * v)


def together(parts: list[trimesh.Trimesh]) -> trimesh.Trimesh:
    """Several meshes as one."""
    first = np.cumsum([0, *(len(part.vertices) for part in parts)])
    return trimesh.Trimesh(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.faces + start for part, start in zip(parts, first[:-1], strict=True)]),
        vertex_normals=np.concatenate([part.vertex_normals for part in parts]),
        visual=trimesh.visual.TextureVisuals(uv=np.concatenate([part.visual.uv for part in parts])),
        process=False,
    )


def teaching() -> trimesh.Trimesh:
    """A mushroom of 48 flat triangles."""
    u, _ = unit_square(MUSHROOM_SIDES, 1)
    steps = np.linalg.norm(np.diff(MUSHROOM, axis=0), axis=1)
    v = np.concatenate([[0], np.cumsum(steps)])[:, None] / steps.sum()
    radius, height = MUSHROOM.T[..., None]
    return faceted(smooth(around(radius, height, u), around(radius, height, u), u, v))


def smooth(points: Grid, normals: Grid, u: np.ndarray, v: np.ndarray) -> trimesh.Trimesh:
    """Two triangles a cell, unless they have no area; rounded to 1e-7 so that a seam's two sides coincide."""
    rows, columns, _ = points.shape
    corner = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]
    faces = np.stack([a, b, c, a, c, d], -1).reshape(-1, 3)
    points = points.reshape(-1, 3).round(7)
    p, q, r = points[faces].swapaxes(0, 1)
    uv = np.stack(np.broadcast_arrays(u, v), -1).reshape(-1, 2)
    return trimesh.Trimesh(
        points,
        faces[np.linalg.norm(np.cross(q - p, r - p), axis=1) > 0],
        vertex_normals=normals.reshape(-1, 3),
        visual=trimesh.visual.TextureVisuals(uv=uv),
        process=False,
    )


def faceted(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """The same triangles, each with corners of its own and one normal."""
    corner = mesh.faces.reshape(-1)
    return trimesh.Trimesh(
        mesh.vertices[corner],
        np.arange(len(corner)).reshape(-1, 3),
        vertex_normals=np.repeat(mesh.face_normals, 3, axis=0),
        visual=trimesh.visual.TextureVisuals(uv=mesh.visual.uv[corner]),
        process=False,
    )


def main() -> None:
    """Write the four meshes; print their figures."""
    for make in (sphere, torus, stretched_plane, teaching):
        write(make(), MESHES / f"{make.__name__}.glb")


if __name__ == "__main__":
    main()
