"""Model, mesh and unwrap `molar_enamel`, `molar_dentine` and `incisor`. Own work, no source data.

`python data/generate/teeth.py` writes data/meshes/<name>.glb and prints the figures that PROVENANCE.md records.
The model is in tenths of a millimetre, the files are in millimetres: +Y from the roots to the chewing surface, +Z the
side of cheek and lips, +X to the back of the jaw; the cervix, where crown and root meet, lies near y = -3.5 mm.
"""

from collections.abc import Callable
from functools import reduce
from pathlib import Path
from typing import NamedTuple

import numpy as np
import sdf
import trimesh
from atlas import packed, unwrapped
from bust import vertex_normals
from export import write
from isosurface import Distance, relaxed, thinned, zero_surface

MESHES = Path(__file__).parents[1] / "meshes"
PER_MM = 10.0
ENAMEL, CEMENT = 11.0, 2.5  # how deep the dentine lies under the crown and under the roots
CERVIX, EQUATOR = -34.0, -9.0  # heights: where crown and root meet, where the crown is widest
GRID_STEP = 1.6  # the mesh is then thinned

# x, z and height of the tips: three on the cheek's side, two on the tongue's, as on a lower first molar.
CUSPS = [(-34, 27, 34), (2, 32, 34), (34, 24, 29), (-29, -29, 37), (26, -30, 36)]


class Tooth(NamedTuple):
    """A body, the grid it is sampled on, and how its surface is cut for the atlas."""

    distance: Distance
    box: tuple[tuple, tuple]
    triangles: int
    charts: Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]  # x, y, z (m,) of the faces -> chart (m,)


def molar(p: sdf.Points) -> sdf.Field:
    """Signed distance to a lower first molar."""
    crown = reduce(lambda clay, lobe: sdf.smooth_union(clay, lobe, 9), (cusp(p, *place) for place in CUSPS))
    crown = sdf.smooth_union(crown, sdf.ellipsoid(p, (0, -14, 0), (45, 34, 40)), 12)
    tooth = sdf.smooth_union(fissures(p, crown), roots(p), 9)
    return sdf.smooth_subtraction(tooth, sdf.rounded_cone(p, (0, -66, -60), (0, -66, 60), (7, 7)), 18)


def cusp(p: sdf.Points, x: float, z: float, height: float) -> sdf.Field:
    """One lobe of the crown from the cervix up, its tip, and the ridge that runs down to the fossa."""
    wall = sdf.rounded_cone(p, (0.58 * x, CERVIX, 0.58 * z), (0.82 * x, -8, 0.82 * z), (17, 24))
    tip = sdf.ellipsoid(p, (0.82 * x, -6, 0.82 * z), (21, height + 6, 20))
    ridge = sdf.rounded_cone(p, (0.72 * x, height - 14, 0.72 * z), (0.25 * x, 8, 0.25 * z), (8, 8))
    return sdf.smooth_union(sdf.smooth_union(wall, tip, 10), ridge, 9)


def fissures(p: sdf.Points, clay: sdf.Field) -> sdf.Field:
    """Press in the central fossa; draw the groove along the crown and those that part the cusps."""
    clay = sdf.smooth_subtraction(clay, sdf.ellipsoid(p, (0, 32, 0), (24, 17, 13)), 14)
    along = [(-40, 29, 0, 2.5), (-22, 16, -2, 3), (-8, 12, 1, 3), (8, 12, -2, 3), (22, 16, 0, 3), (42, 28, 1, 2.5)]
    cheek = [(-8, 12, 1, 3), (-13, 20, 16, 3), (-16, 26, 36, 3), (-16, 4, 58, 4)]
    cheek_behind = [(8, 12, -2, 3), (16, 19, 16, 3), (20, 24, 36, 3), (20, 6, 56, 4)]
    tongue = [(8, 12, -2, 3), (2, 20, -16, 3), (-1, 27, -36, 3), (-1, 6, -58, 4)]
    tubes = (sdf.tube(p, knots) for knots in (along, cheek, cheek_behind, tongue))
    return reduce(lambda crown, groove: sdf.smooth_subtraction(crown, groove, 6), tubes, clay)


def roots(p: sdf.Points) -> sdf.Field:
    """Neck and two roots, flat from front to back of the jaw and bent backward."""
    neck = sdf.ellipsoid(p, (0, -38, 0), (36, 26, 33))
    return reduce(lambda clay, x: sdf.smooth_union(clay, root(p, x), 16), (-20.0, 20.0), neck)


def root(p: sdf.Points, x: float) -> sdf.Field:
    """Two canals that start side by side at the neck, at this `x`, and the web between them; they meet at the apex."""
    canals = [canal(p, x, z, thick) for z, thick in ((-19, 1.0), (19, 1.0), (0, 0.85))]
    return reduce(lambda clay, part: sdf.smooth_union(clay, part, 12), canals)


def canal(p: sdf.Points, x: float, z: float, thick: float) -> sdf.Field:
    """A straight upper part and an apex that bends backward."""
    bend = (1.25 * x + 1, -105, 0.62 * z)
    upper = sdf.rounded_cone(p, (x, -36, z), bend, (19 * thick, 13 * thick))
    apex = sdf.rounded_cone(p, bend, (1.25 * x + 9, -165, 0.2 * z), (13 * thick, 6 * thick))
    return np.minimum(upper, apex)


def dentine(p: sdf.Points) -> sdf.Field:
    """Signed distance to the molar without its enamel: deep under the crown, hardly under the roots."""
    crown = np.clip((p[1] - CERVIX + 20) / 35, 0, 1)
    return molar(p) + CEMENT + (ENAMEL - CEMENT) * crown * crown * (3 - 2 * crown)


def incisor(p: sdf.Points) -> sdf.Field:
    """Signed distance to an upper middle incisor, its edge up."""
    crown = sdf.smooth_intersection(seen_from_lips(p), seen_from_side(p), 10)
    return sdf.smooth_union(crown, sdf.rounded_cone(p, (0, -30, -2), (4, -148, -6), (27, 9)), 18)


def seen_from_lips(p: sdf.Points) -> sdf.Field:
    """The crown's outline from the front: narrow at the cervix, widest at the edge, which falls to the back."""
    outline = sdf.half_space(p, (0, -46, 0), (0, -1, 0))
    for origin, normal, rounding in [
        ((-32, 0, 0), (-0.987, -0.158, 0), 26),
        ((32, 0, 0), (0.987, -0.158, 0), 26),
        ((0, 72, 0), (0.05, 0.9987, 0), 14),
    ]:
        outline = sdf.smooth_intersection(outline, sdf.half_space(p, origin, normal), rounding)
    return outline


def seen_from_side(p: sdf.Points) -> sdf.Field:
    """The crown as a wedge: it bulges to the lips and is hollow to the tongue, between edge and cingulum."""
    lips = sdf.ellipsoid(p, (0, -8, -42), (95, 150, 75))
    wedge = sdf.smooth_intersection(lips, sdf.half_space(p, (0, 60, 7), (0, 0.36, -0.933)), 10)
    return sdf.smooth_subtraction(wedge, sdf.ellipsoid(p, (0, 36, -29), (25, 40, 32)), 12)


def molar_charts(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """The upper crown, and what is below it in quarters, so that no chart has two legs that could overlap."""
    return np.where(y > EQUATOR, 0, 1 + 2 * (z < 0) + (x < 0))


def incisor_charts(_: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """The side of the lips and the side of the tongue, cut along the edge and down the middle of the root."""
    return np.where(z > np.maximum(0.16 * (y + 30), 0.04 * (y + 30)), 0, 1)


TEETH = {
    "molar_enamel": Tooth(molar, ((-70, -180, -66), (70, 60, 66)), 14000, molar_charts),
    "molar_dentine": Tooth(dentine, ((-70, -180, -66), (70, 60, 66)), 8000, molar_charts),
    "incisor": Tooth(incisor, ((-64, -170, -60), (64, 90, 60)), 8000, incisor_charts),
}


def textured(tooth: Tooth) -> trimesh.Trimesh:
    """The mesh as shipped: millimetres, UVs from the bottom left, vertices split along the seams."""
    vertices, faces = thinned(*zero_surface(tooth.distance, tooth.box, GRID_STEP), tooth.triangles)
    vertices = relaxed(tooth.distance, vertices, faces)
    charts = unwrapped(vertices, faces, tooth.charts(*vertices[faces].mean(1).T), up=vertices[:, 1])
    source = np.concatenate([chart.source for chart in charts])
    starts = np.cumsum([0] + [len(chart.source) for chart in charts[:-1]])
    return trimesh.Trimesh(
        vertices[source] / PER_MM,
        np.concatenate([chart.faces + start for chart, start in zip(charts, starts, strict=True)]),
        vertex_normals=vertex_normals(vertices, faces)[source],
        visual=trimesh.visual.TextureVisuals(uv=np.concatenate(packed(charts))),
        process=False,
    )


def main() -> None:
    """Write the three meshes; print their figures."""
    for name, tooth in TEETH.items():
        write(textured(tooth), MESHES / f"{name}.glb")


if __name__ == "__main__":
    main()
