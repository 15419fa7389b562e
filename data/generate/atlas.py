"""UV atlas of a shipped mesh: cut it into charts, flatten each, and place them on the unit square.

The layout is in the unit of the vertices until `packed` scales it. For generation only.
"""

from typing import NamedTuple

import numpy as np
import trimesh
from flatten import flatten
from scipy.ndimage import binary_dilation
from scipy.signal import fftconvolve

CELL = 3.0  # mm: raster of the placement; charts and the border stay at least one cell apart
ANGLES = np.radians(np.arange(0, 360, 15))
SAMPLES = np.array([(i, j, 24 - i - j) for i in range(25) for j in range(25 - i)]) / 24  # of a triangle, barycentric


class Chart(NamedTuple):
    """A connected piece of the mesh with its own uv."""

    source: np.ndarray  # (n,) the mesh's vertex behind each of the chart's
    faces: np.ndarray  # (m, 3) over the chart's vertices
    uv: np.ndarray  # (n, 2) in the unit of the mesh


def unwrapped(vertices: np.ndarray, faces: np.ndarray, label: np.ndarray, up: np.ndarray) -> list[Chart]:
    """Flatten the faces of each label (m,), turned so that `up` (n,), any quantity at the vertices, grows with v."""
    label = without_islands(faces, label)
    charts = []
    for number in range(label.max() + 1):
        source, local = np.unique(faces[label == number], return_inverse=True)
        local = local.reshape(-1, 3)
        charts.append(Chart(source, local, upright(flatten(vertices[source], local), up[source])))
    return charts


def without_islands(faces: np.ndarray, label: np.ndarray) -> np.ndarray:
    """Give each part of a chart that is cut off from the chart's main part to the chart around it."""
    neighbours = trimesh.graph.face_adjacency(faces)
    same = neighbours[label[neighbours[:, 0]] == label[neighbours[:, 1]]]
    part = trimesh.graph.connected_component_labels(same, node_count=len(faces))
    for island in np.argsort(np.bincount(part))[: -(label.max() + 1)]:
        border = neighbours[(part[neighbours] == island).sum(1) == 1]
        around = label[border[part[border] != island]]
        label = np.where(part == island, np.bincount(around).argmax(), label)
    return label


def upright(uv: np.ndarray, up: np.ndarray) -> np.ndarray:
    """Turn `uv` so that the direction in which `up` grows most is +v."""
    x, y = (uv - uv.mean(0)).T @ (up - up.mean())
    return turned(uv, np.pi / 2 - np.arctan2(y, x))


def turned(uv: np.ndarray, angle: float) -> np.ndarray:
    """Turn `uv` counter-clockwise and move its box to the origin."""
    cos, sin = np.cos(angle), np.sin(angle)
    uv = uv @ np.array([[cos, sin], [-sin, cos]])
    return uv - uv.min(0)


def footprint(uv: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Mark the cells a chart takes up, with a rim of one cell: bool, indexed [u, v]."""
    cells = (np.einsum("sk,fkc->sfc", SAMPLES, uv[faces]).reshape(-1, 2) / CELL).astype(int) + 1
    mask = np.zeros(cells.max(0) + 2, bool)
    mask[tuple(cells.T)] = True
    return binary_dilation(mask, np.ones((3, 3)))


def packed(charts: list[Chart]) -> list[np.ndarray]:
    """Place the charts in turn, the first upright, so that the square around all stays smallest; uv in [0, 1]."""
    extent = sum(max(np.ptp(chart.uv, axis=0)) for chart in charts)
    taken = np.zeros((int(2 * extent / CELL),) * 2, bool)
    placed: list[np.ndarray] = []
    side = 0
    for chart in charts:
        angles = ANGLES if placed else ANGLES[:1]
        fits = [(*best_cell(taken, footprint(turned(chart.uv, a), chart.faces), side), a) for a in angles]
        side, cell, angle = min(fits, key=lambda fit: fit[0])
        uv = turned(chart.uv, angle)
        mask = footprint(uv, chart.faces)
        taken[cell[0] : cell[0] + mask.shape[0], cell[1] : cell[1] + mask.shape[1]] |= mask
        placed.append(uv + (np.array(cell) + 1) * CELL)
    return [uv / (side * CELL) for uv in placed]


def best_cell(taken: np.ndarray, mask: np.ndarray, side: int) -> tuple[int, tuple[int, int]]:
    """Return the side of the square after the best placement of `mask`, and its cell; ties go to the lowest sum."""
    free = fftconvolve(taken.astype(float), mask[::-1, ::-1].astype(float), "valid") < 0.5
    u, v = np.nonzero(free)
    sides = np.maximum(side, np.maximum(u + mask.shape[0], v + mask.shape[1]))
    best = np.lexsort((u + v, sides))[0]
    return int(sides[best]), (int(u[best]), int(v[best]))
