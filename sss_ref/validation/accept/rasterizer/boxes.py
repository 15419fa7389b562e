"""Where a processor may put each vertex in the window: a box around the place where it really is (rules R1 and R2).

The box is as wide as the snap may move it, and as the rounding of the vertex stage, of the division by w and of the
viewport transform may. Whether that transform is fused, whether triangles are cut at the sides of the view or only at
a guard band, and which range of z is kept, all stays inside.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.enclosing import Outcome
from sss_ref.interpret.intervals.evaluate import run_intervals
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.work import uniform_value
from sss_ref.language.pipeline import CLIP_POSITION, MESH_ATTRIBUTES, Pass
from sss_ref.language.types import components
from sss_ref.raster.clip import W, X, Z
from sss_ref.raster.primitives import Primitives, drawable, place
from sss_ref.raster.viewport import Viewport
from sss_ref.rendering.draw import Machine, varying_columns, vertices
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.known import KnownBuffer

ROUNDING = 2.0**-22  # relative, of 1/w, the product with it, and the viewport transform, together
CUT = 2.0**-20  # of the largest coordinate of a triangle: the rounding of a vertex where it is cut
PLANE = 2.0**-22  # of the way from the picture's corner to a corner of the piece and to the sample
GUARD_BAND = 2.0**15  # pixels: no processor places a vertex farther outside the picture, but cuts the triangle there
NOWHERE = (np.zeros(0, int), np.zeros(0, int))  # vertices are no pixels: they read buffers as textures
EVERYWHERE = 2.0**40  # pixels: the box of a vertex that may be at the eye; finite, for it is multiplied with 0


@dataclass(frozen=True)
class Boxes:
    """The vertices of a draw as a processor may have them.

    primitives: all pieces, also those that the oracle drops. viewport: what they are drawn into.
    same: int64 (V,), one number for all vertices with the same clip position, which no processor tells apart: where UVs
        meet, the mesh has two. Those that differ in a bit may be snapped apart, as the vertices at a sphere's pole.
    centre, half: float64 (V, 2), pixels from the centre of pixel (0, 0): the box around each vertex in the window.
    off: float64 (V, 2), pixels: how far from its snapped position here a processor may have it when it interpolates.
    rounding: float64 (P, 2), pixels along x and y: as if each quantity that is interpolated on a plane had moved so
        far by itself, because the plane begins at a corner of the picture, or at one of the piece, and is rounded.
    depth_error, weight_error, attribute_error: float64 (V,), (V,) and (V, A): how much else its vertex stage may give;
        of 1/w the share.
    """

    primitives: Primitives
    viewport: Viewport
    same: np.ndarray
    centre: np.ndarray
    half: np.ndarray
    off: np.ndarray
    rounding: np.ndarray
    depth_error: np.ndarray
    weight_error: np.ndarray
    attribute_error: np.ndarray

    @property
    def drawable(self) -> np.ndarray:
        """Bool (P,): the pieces of which the oracle draws anything."""
        return drawable(self.primitives)


def boxes_of(scene: Scene, this_pass: Pass, read: Mapping[str, KnownBuffer], profile: Profile) -> Boxes:
    """The boxes of a pass that draws the mesh, on a processor of a profile. read: what is known of earlier buffers."""
    machine = Machine(subpixel_bits=profile.subpixel_bits)
    clip_position, attributes = vertices(scene, this_pass, {name: read[name].exact for name in read}, machine)
    outcomes = _vertex_outcomes(scene, this_pass, read, profile)
    clip_error, attribute_error = _vertex_errors(this_pass, outcomes, clip_position, attributes)
    viewport, triangles = machine.viewport(scene, this_pass), scene.mesh_of(this_pass).triangles
    primitives, placed = place(clip_position, attributes, triangles, viewport)
    given = triangles[primitives.triangle]
    clip_error = _with_cut_errors(clip_error, primitives, given, placed)
    attribute_error = _of_all(attribute_error, primitives, len(placed))

    ndc, ndc_error, weight_error = _divided(placed, clip_error)
    size = np.array([viewport.width, viewport.height]) / 2
    centre = ndc[:, :2] * size + size - 0.5
    error = (ndc_error[:, :2] + (np.abs(ndc[:, :2]) + 1) * ROUNDING) * size
    cut = np.arange(len(placed)) >= len(clip_position)
    error[cut] += _moves_of_cuts(primitives, centre, ndc[:, Z], ndc_error[:, Z])[cut, None]
    error = np.minimum(error, EVERYWHERE)
    step = 1 / viewport.step
    moved = np.abs(primitives.snapped * step - centre)
    if profile.snap == "any":
        half, off = error + step, moved + error + step
    else:
        elsewhere = cut[:, None] | (moved > step / 2 - error)  # it snaps there, or what it has not cut off
        half, off = error + step / 2, np.where(elsewhere, step, moved) + error
    rounding = PLANE * (2 * size + _extent(centre, placed)[given].max(axis=1))
    depth_error = ndc_error[:, Z] / 2 + ROUNDING
    same = same_places(placed)
    return Boxes(primitives, viewport, same, centre, half, off, rounding, depth_error, weight_error, attribute_error)


def same_places(clip_position: np.ndarray) -> np.ndarray:
    """One number for all vertices whose clip positions (V, 4) are the same, int64 (V,)."""
    return np.unique(clip_position, axis=0, return_inverse=True)[1].reshape(-1).astype(np.int64)


def _vertex_outcomes(
    scene: Scene, this_pass: Pass, read: Mapping[str, KnownBuffer], profile: Profile
) -> Mapping[str, Outcome]:
    """What the vertex stage of a pass may write for every vertex, by name."""
    (stage,) = this_pass.draw.vertex_stages
    mesh = scene.mesh_of(this_pass).attributes

    def value(own: str, kind: Any) -> Any:
        if own in MESH_ATTRIBUTES:
            return kind(*mesh[own].T)
        name = stage.reads[own]
        return read[name].read(kind, NOWHERE).bounds if name in read else uniform_value(kind, scene.uniforms[name])

    return run_intervals(stage, {own: value(own, kind) for own, kind in stage.parameters.items()}, profile.for_vertices)


def _vertex_errors(
    this_pass: Pass, outcomes: Mapping[str, Outcome], clip_position: np.ndarray, attributes: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """How far from ours the clip positions (V, 4) and varyings (V, A) of another processor may be, float64."""
    clip_error = _distance(outcomes[CLIP_POSITION].value, clip_position)
    attribute_error = np.zeros(attributes.shape)
    for name, first in varying_columns(this_pass)[0].items():
        parts = components(outcomes[name].value)
        columns = slice(first, first + len(parts))
        attribute_error[:, columns] = _distance(outcomes[name].value, attributes[:, columns])
    return clip_error, attribute_error


def _distance(value: Any, ours: np.ndarray) -> np.ndarray:
    """How far the ends of intervals lie from values (V, C)."""
    exact = ours.astype(np.float64)
    low, high = (
        np.stack([np.broadcast_to(getattr(part, end), len(ours)) for part in components(value)], axis=1)
        for end in ("low", "high")
    )
    with np.errstate(invalid="ignore"):
        return np.nan_to_num(np.maximum(exact - low, high - exact), nan=np.inf)


def _with_cut_errors(error: np.ndarray, primitives: Primitives, given: np.ndarray, placed: np.ndarray) -> np.ndarray:
    """The errors (V, 4) of all clip positions. A vertex that came where a triangle was cut has the largest of it.

    error: of the vertices of the mesh. given: int (P, 3), the corners of the triangles that the pieces were cut from.
    """
    cut = np.concatenate([error, np.zeros((len(placed) - len(error), 4))])
    reach = np.abs(placed.astype(np.float64)).max(axis=1)[primitives.corners].max(axis=1)
    _raise_to(cut, primitives.corners, error[given].max(axis=1) + reach[:, None] * CUT)
    return np.concatenate([error, cut[len(error) :]])


def _moves_of_cuts(primitives: Primitives, centre: np.ndarray, depth: np.ndarray, error: np.ndarray) -> np.ndarray:
    """How far in the window, pixels (V,), the near and the far plane may cut a triangle elsewhere.

    depth, error: float64 (V,), z/w and how far it may be off. It changes along the triangle by its gradient in the
    window, so that the place where it reaches -1 or 1 is off by error / gradient: far where both are nearly parallel.
    The gradient is that of a triangle's largest piece, for a sliver has none that could be trusted.
    """
    place = np.column_stack([centre, depth])[primitives.corners]
    (x1, y1, z1), (x2, y2, z2) = (place[:, 1] - place[:, 0]).T, (place[:, 2] - place[:, 0]).T
    area = np.abs(x1 * y2 - x2 * y1)
    with np.errstate(divide="ignore", invalid="ignore"):
        gradient = np.hypot(z1 * y2 - z2 * y1, z1 * x2 - z2 * x1) / area
        move = np.nan_to_num(error[primitives.corners].max(axis=1) / gradient, nan=EVERYWHERE)
    by_area, of_triangle = np.argsort(area), np.zeros(primitives.triangle.max(initial=0) + 1)
    of_triangle[primitives.triangle[by_area]] = move[by_area]  # the last of a triangle counts, its largest piece
    moves = np.zeros(len(centre))
    _raise_to(moves, primitives.corners, of_triangle[primitives.triangle])
    return np.where(np.abs(depth) >= 1 - error, moves, 0.0)


def _raise_to(largest: np.ndarray, corners: np.ndarray, of_piece: np.ndarray) -> None:
    """Raise what is known of vertices (V, ...) to what is known of each piece (P, ...) that they are corners of."""
    for k in range(3):
        np.maximum.at(largest, corners[:, k], of_piece)


def _extent(centre: np.ndarray, placed: np.ndarray) -> np.ndarray:
    """How far from the picture's corner a processor has each vertex (V, 2), or what it puts in its place."""
    z, w = placed[:, Z], placed[:, W]
    kept = (w > 0) & (np.abs(z) <= w)
    return np.where(kept[:, None], np.minimum(np.abs(centre), GUARD_BAND), GUARD_BAND)


def _of_all(error: np.ndarray, primitives: Primitives, count: int) -> np.ndarray:
    """The attributes' error at all vertices; where a triangle was cut, the largest of the draw."""
    most = error.max(axis=0, initial=0.0)
    return np.concatenate([error, np.broadcast_to(most, (count - len(error), error.shape[1]))])


def _divided(clip_position: np.ndarray, error: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """x/w, y/w, z/w float64 (V, 3), how far they may be off, and 1/w, its share (V,).

    The errors are infinite where w may be 0, and 0 where it is not above.
    """
    exact = clip_position.astype(np.float64)
    w, w_error = exact[:, W:], error[:, W:]
    with np.errstate(all="ignore"):
        ndc = np.where(w > 0, exact[:, X:W] / w, 0.0)
        off = np.column_stack([error[:, X:W] + np.abs(ndc) * w_error, w_error]) / (w - w_error)
    off = np.where(w > w_error, off, np.where(w > 0, np.inf, 0.0))
    return ndc, off[:, X:W], off[:, W]
