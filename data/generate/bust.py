"""Model, mesh and unwrap `bust`: a stylised head, neck and shoulders with thin ears. Own work, no source data.

`python data/generate/bust.py` writes data/meshes/bust.glb and prints the figures that PROVENANCE.md records.
The model is in millimetres: +Y up, the face looks along +Z, +X is the head's left; the ear canals lie near y = z = 0.
The file is in scene units: MM_PER_UNIT millimetres each, the middle of the model's box at the origin.
"""

import hashlib
from functools import reduce
from pathlib import Path

import numpy as np
import sdf
import trimesh
from atlas import packed, unwrapped
from isosurface import relaxed, thinned, zero_surface

MESH_FILE = Path(__file__).parents[1] / "meshes" / "bust.glb"
MM_PER_UNIT = 150.0
MIDDLE = (0.0, -24.0, 12.8)  # mm
BOX = ((-125.0, -185.0, -105.0), (125.0, 137.0, 131.0))  # mm
GRID_STEP = 1.25  # mm; the mesh is then thinned to TRIANGLES, which follow the curvature
TRIANGLES = 20000
EAR_ANGLE, EAR_TILT = np.radians([39.0, 12.0])  # the plate's angle with the skull; its lean to the back


def bust(points: sdf.Points) -> sdf.Field:
    """Signed distance to the whole bust, in mm."""
    head = reduce(lambda clay, detail: detail(points, clay), (brow, eyes, nose, mouth), skull(points))
    head = sdf.smooth_union(head, ear(points), 9)
    body = sdf.smooth_union(shoulders(points), head, 24)
    return sdf.smooth_intersection(body, sdf.half_space(points, (0, -178, 0), (0, -1, 0)), 8)


def skull(p: sdf.Points) -> sdf.Field:
    """Cranium, forehead, face, jaw, chin, cheekbones, muzzle and cheeks."""
    q = sdf.smooth_mirror(p, 3)
    clay = sdf.ellipsoid(p, (0, 50, -2), (75, 80, 96))
    clay = sdf.smooth_union(clay, sdf.ellipsoid(p, (0, 62, 42), (60, 50, 52)), 30)
    clay = sdf.smooth_union(clay, sdf.ellipsoid(p, (0, -22, 42), (58, 76, 50)), 30)
    clay = sdf.smooth_union(clay, sdf.rounded_cone(q, (44, -50, 14), (14, -88, 76), (17, 15)), 24)
    clay = sdf.smooth_union(clay, sdf.ellipsoid(p, (0, -90, 86), (18, 14, 15)), 14)
    clay = sdf.smooth_union(clay, sdf.ellipsoid(q, (43, -6, 62), (19, 16, 23)), 26)
    clay = sdf.smooth_union(clay, sdf.ellipsoid(p, (0, -52, 73), (29, 30, 27)), 20)
    return sdf.smooth_union(clay, sdf.ellipsoid(q, (34, -40, 52), (22, 26, 26)), 20)


def brow(p: sdf.Points, clay: sdf.Field) -> sdf.Field:
    """Add the brow ridge, which runs out into the temple."""
    knots = [(5, 34, 89, 8), (24, 40, 86.5, 8), (44, 36, 75, 8), (56, 20, 58, 7), (58, 2, 46, 7)]
    return sdf.smooth_union(clay, sdf.tube(sdf.smooth_mirror(p, 3), knots), 18)


def eyes(p: sdf.Points, clay: sdf.Field) -> sdf.Field:
    """Sink the sockets, lay the closed lids in, and draw the line between them."""
    q = sdf.smooth_mirror(p, 3)
    clay = sdf.smooth_subtraction(clay, sdf.ellipsoid(q, (32, 15, 99), (19, 12, 15)), 14)
    clay = sdf.smooth_union(clay, sdf.ellipsoid(q, (32, 13, 75), (15, 13, 13.5)), 5)
    lash_line = [(19, 11, 88, 0.8), (25, 8.5, 91, 1.6), (32, 7.5, 91.5, 1.8), (40, 8.3, 88, 1.6), (46, 10.5, 82, 0.8)]
    return sdf.smooth_subtraction(clay, sdf.tube(q, lash_line), 2.5)


def nose(p: sdf.Points, clay: sdf.Field) -> sdf.Field:
    """Add bridge and tip, wings and the strut between the nostrils; press the nostrils in."""
    q = sdf.smooth_mirror(p, 2)
    flesh = sdf.tube(p, [(0, 36, 92, 8), (0, 14, 98, 6.5), (0, -8, 110, 7.2), (0, -18, 115, 8.3)])
    flesh = sdf.smooth_union(flesh, sdf.rounded_cone(p, (0, 6, 93), (0, -21, 101), (7, 10)), 8)
    flesh = sdf.smooth_union(flesh, sdf.ellipsoid(q, (10.8, -22.5, 101), (6.8, 7, 10)), 15)
    flesh = sdf.smooth_union(flesh, sdf.rounded_cone(p, (0, -21, 113), (0, -27, 100), (5.5, 4.5)), 8)
    clay = sdf.smooth_union(clay, flesh, 14)
    return sdf.smooth_subtraction(clay, sdf.ellipsoid(q, (7.8, -30, 108), (2.2, 2.5, 3.2)), 5)


def mouth(p: sdf.Points, clay: sdf.Field) -> sdf.Field:
    """Press in the groove under the nose and the one over the chin; add two lips that meet in a crease."""
    q = sdf.smooth_mirror(p, 2)
    clay = sdf.smooth_subtraction(clay, sdf.rounded_cone(p, (0, -40, 107), (0, -47, 106), (2.5, 3.5)), 6)
    clay = sdf.smooth_subtraction(clay, sdf.tube(q, [(0, -76, 108, 8), (12, -75, 105, 7), (24, -72, 98, 5)]), 12)
    upper = sdf.tube(q, [(0, -53.2, 101.5, 4), (5, -51.8, 101.2, 4.5), (14, -53.8, 97, 4), (24, -57.6, 89, 2)])
    lower = sdf.tube(q, [(0, -63.4, 100, 5), (9, -63.1, 98.6, 4.9), (17, -61.5, 94.8, 3.9), (24, -58.7, 89, 2)])
    return sdf.smooth_union(clay, sdf.smooth_union(upper, lower, 1), 7)


def ear_space(p: sdf.Points) -> sdf.Points:
    """Return the points in the ear's frame: x along the plate to the back, y up, z out of its front; mm."""
    out, lean = (np.array([np.sin(a), np.cos(a)]) for a in (EAR_ANGLE, EAR_TILT))
    back, up, front = np.array([out[0], 0, -out[1]]), np.array([0, 1, 0]), np.array([out[1], 0, out[0]])
    offset = sdf.from_origin(sdf.smooth_mirror(p, 2), (67, 1, -4))
    axes = (lean[1] * back - lean[0] * up, lean[1] * up + lean[0] * back, front)
    return np.stack([sdf.dot(offset, axis) for axis in axes])


def ear(p: sdf.Points) -> sdf.Field:
    """Plate, lobe and the bulge behind it; helix rim, antihelix and tragus on it; the concha hollowed out."""
    e = ear_space(p)
    clay = sdf.ellipsoid(e, (17, 5, 0), (23, 33, 4.6))
    clay = sdf.smooth_union(clay, sdf.ellipsoid(e, (10, -27, 1), (12, 12, 5)), 8)
    clay = sdf.smooth_union(clay, sdf.ellipsoid(e, (4, 2, -6), (13, 32, 9)), 10)
    helix = [(10, -1, 2, 2.5), (4, 10, 4, 3.5), (3, 23, 5, 4), (12, 35, 5, 4.5), (25, 38, 5, 4.8), (36, 28, 5, 5)]
    helix += [(40, 10, 4, 4.6), (36, -7, 3, 4), (28, -21, 2, 4), (17, -31, 2, 4)]
    antihelix = [(14, -17, 4, 4), (22, -13, 4, 4), (26, 0, 5, 4), (24, 14, 4, 4), (15, 25, 1, 3)]
    clay = sdf.smooth_union(clay, sdf.tube(e, helix), 4)
    clay = sdf.smooth_union(clay, sdf.tube(e, antihelix), 6)
    clay = sdf.smooth_union(clay, sdf.ellipsoid(e, (0, -6, 5), (6, 8, 5)), 7)
    return sdf.smooth_subtraction(clay, sdf.ellipsoid(e, (13, -3, 6), (9, 12, 9)), 5)


def shoulders(p: sdf.Points) -> sdf.Field:
    """Neck with the muscles from behind the ears to the collarbones; chest and shoulders cut to a round base."""
    q = sdf.smooth_mirror(p, 4)
    clay = sdf.rounded_cone(p, (0, -30, -14), (0, -160, -30), (48, 54))
    tendon = [(46, -36, -18, 8), (42, -80, 2, 10), (24, -125, 24, 10), (11, -150, 32, 8)]
    clay = sdf.smooth_union(clay, sdf.tube(q, tendon), 18)
    chest = sdf.ellipsoid(p, (0, -225, -18), (170, 78, 84))
    chest = sdf.smooth_union(chest, sdf.rounded_cone(q, (22, -95, -52), (130, -180, -34), (18, 28)), 40)
    clay = sdf.smooth_union(clay, chest, 40)
    return sdf.smooth_intersection(clay, sdf.ellipsoid(p, (0, -80, -20), (140, 140, 104)), 24)


def sides(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return each face's chart: front 0, back 1, base 2; the seam follows the crown, the ears' rims and the neck."""
    x, y, z = vertices[faces].mean(1).T
    plate = 64 - 20 * np.maximum(1 - np.abs(y + 56) / 36, 0)  # the neck under the lobe goes to the front: no overlap
    seam = 2.0 - 1.235 * np.where(y > -100, np.maximum(np.abs(x) - plate, 0), 0)
    return np.where(y < -177.5, 2, np.where(z > seam, 0, 1))


def vertex_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the area-weighted unit normals (n, 3) of the mesh before the UV cut (rule R6)."""
    a, b, c = vertices[faces].transpose(1, 0, 2)
    total = np.zeros_like(vertices)
    np.add.at(total, faces, np.cross(b - a, c - a)[:, None])
    return total / np.linalg.norm(total, axis=1, keepdims=True)


def textured() -> trimesh.Trimesh:
    """Return the mesh as shipped: scene units, UVs from the bottom left, vertices split along the seam."""
    vertices, faces = thinned(*zero_surface(bust, BOX, GRID_STEP), TRIANGLES)
    vertices = relaxed(bust, vertices, faces)
    charts = unwrapped(vertices, faces, sides(vertices, faces), up=vertices[:, 1])
    source = np.concatenate([chart.source for chart in charts])
    starts = np.cumsum([0] + [len(chart.source) for chart in charts[:-1]])
    return trimesh.Trimesh(
        (vertices[source] - MIDDLE) / MM_PER_UNIT,
        np.concatenate([chart.faces + start for chart, start in zip(charts, starts, strict=True)]),
        vertex_normals=vertex_normals(vertices, faces)[source],
        visual=trimesh.visual.TextureVisuals(uv=np.concatenate(packed(charts))),
        process=False,
    )


def decoded(path: Path) -> dict[str, np.ndarray]:
    """Read the file back and return the arrays a loader sees, in the types the package uses."""
    (mesh,) = trimesh.load_scene(path, process=False).geometry.values()
    return {
        "positions": np.ascontiguousarray(mesh.vertices, "<f4"),
        "faces": np.ascontiguousarray(mesh.faces, "<i4"),
        "uvs": np.ascontiguousarray(mesh.visual.uv, "<f4"),
        "normals": np.ascontiguousarray(mesh.vertex_normals, "<f4"),
    }


def main() -> None:
    """Write the mesh; print its size and the SHA-256 of the file and of each decoded array."""
    textured().export(MESH_FILE, include_normals=True)
    print(f"{MESH_FILE.name} {MESH_FILE.stat().st_size} {hashlib.sha256(MESH_FILE.read_bytes()).hexdigest()}")
    for name, array in decoded(MESH_FILE).items():
        print(f"{name} {array.dtype.str} {array.shape} {hashlib.sha256(array.tobytes()).hexdigest()}")


if __name__ == "__main__":
    main()
