"""A draw of the mesh with one thing changed: its matrices, its viewport, the triangles that it keeps."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from sss_ref.interpret.work import Fragments
from sss_ref.language.names import Name
from sss_ref.language.pipeline import Pass
from sss_ref.language.types import mat3, mat4
from sss_ref.raster.primitives import Primitives, drawable, only, place
from sss_ref.raster.rasterize import visibility
from sss_ref.rendering.draw import Machine, shade, varying_columns, vertices
from sss_ref.validation.accept.case import Case

Move = Callable[[Primitives, int], Primitives]  # of pieces, and the step of a pixel
Matrix = np.ndarray
ZOOMS = (0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 1.005, 1.01, 1.02, 1.05, 1.1, 1.25, 2.0)
TURNS = (-5.0, -2.0, -1.0, -0.5, -0.25, -0.1, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0)  # degrees
SCALES = (0.5, 2.0)
JITTER = (-1.0, -0.5, -0.25, -0.125, 0.0, 0.125, 0.25, 0.5, 1.0)  # pixels
CLOSER, FARTHEST = 3, 8.0  # how often a shift is fitted, and how many pixels it may come to
SIDES = {"x": ("left", "right"), "y": ("down", "up")}


def as_they_are(primitives: Primitives, step: int) -> Primitives:
    """All pieces where they are."""
    return primitives


@dataclass(frozen=True)
class Redrawing:
    """A buffer of a pass that draws the mesh, to be drawn again with something changed."""

    case: Case
    this_pass: Pass
    buffer: str

    def draw(self, uniforms: Mapping[str, Any] = {}, move: Move = as_they_are) -> np.ndarray:
        """The buffer (H, W) or (H, W, C) with other uniforms and with pieces moved or left out."""
        own = self.case.oracle.scene
        there = {**self.case.oracle.buffers, **self.case.drawing.buffers}
        scene = replace(own, own_uniforms={**own.own_uniforms, **uniforms})
        machine = Machine(subpixel_bits=self.case.profile.subpixel_bits, stops=False)
        viewport, draw = machine.viewport(scene, self.this_pass), self.this_pass.draw
        triangles = scene.mesh_of(self.this_pass).triangles
        placed, _ = place(*vertices(scene, self.this_pass, there, machine), triangles, viewport)
        primitives = move(placed, viewport.step)
        primitives = only(primitives, drawable(primitives))
        piece, depth = visibility(primitives, viewport, None)
        shown = np.append(primitives.triangle, np.int32(-1))[piece]
        raster = {draw.depth: depth, draw.triangle: shown, draw.coverage: (shown >= 0).astype(np.uint8)}
        if self.buffer in raster:
            return raster[self.buffer]
        varyings, _ = varying_columns(self.this_pass)
        fragments = Fragments(*scene.size(self.this_pass), primitives, piece, viewport.step, varyings)
        return shade(scene, self.this_pass, fragments, there, [self.buffer], machine)[self.buffer]


def redrawings(todo: Redrawing) -> Iterator[tuple[str, Callable[[], np.ndarray]]]:
    """What may be wrong with the draw in words, and the buffer then."""
    yield from ((text, partial(todo.draw, changed)) for text, changed in _matrices(todo))
    for text, move in _moves():
        yield text, partial(todo.draw, move=move)
    x, y = fitted_shift(todo)
    if not {x, y} <= set(JITTER):
        yield _lies(x, y), partial(todo.draw, move=partial(_shifted, x, y))


def _matrices(todo: Redrawing) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Every matrix of the vertex stage made another one."""
    uniforms = todo.case.oracle.scene.uniforms
    for name in (name for name, kind in todo.this_pass.draw.reads.items() if kind in (mat3, mat4)):
        for text, matrix in other_matrices(name, uniforms):
            yield text, {name: matrix}


def other_matrices(name: str, uniforms: Mapping[str, Any]) -> Iterator[tuple[str, Matrix]]:
    """Another matrix in the place of one, in words."""
    right = np.asarray(uniforms[name], np.float64)
    changed: dict[str, Matrix] = {"transposed": right.T, "the identity": np.eye(len(right))}
    if len(right) == 3:
        changed["world_from_model, not its inverse transpose"] = np.asarray(uniforms["world_from_model"])[:3, :3]
    base = Name.of(name).base
    changed |= {
        other: np.asarray(uniforms[other]) for other in uniforms if other != name and Name.of(other).base == base
    }
    if "clip_from" in name:
        changed["of the other convention: z from 0 to w, not from -w to w"] = _half_depth() @ right
        for zoom in ZOOMS:
            changed[f"{_seen_otherwise(right)} {zoom:g} times as large"] = np.diag([1 / zoom, 1 / zoom, 1, 1]) @ right
        for degrees in TURNS:
            changed[f"of another time: the scene is turned by {degrees:g} degrees about the vertical"] = right @ _turn(
                degrees
            )
    for text, matrix in changed.items():
        yield f"{name} is {text}", matrix.astype(np.float32)


def _seen_otherwise(projection: Matrix) -> str:
    """What differs where a view sees more or less, by its projection."""
    is_parallel = not projection[3, :3].any()
    return "of another height: view_height is" if is_parallel else "of another field of view: tan(fov_y/2) is"


def _half_depth() -> Matrix:
    return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0.5, 0.5], [0, 0, 0, 1.0]])


def _turn(degrees: float) -> Matrix:
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[cosine, 0, sine, 0], [0, 1, 0, 0], [-sine, 0, cosine, 0], [0, 0, 0, 1.0]])


def _moves() -> Iterator[tuple[str, Move]]:
    """Culling, viewports of another size, and pictures that lie elsewhere."""
    yield "front faces, counter-clockwise in the window, are culled", partial(_culled, -1)
    yield "back faces, clockwise in the window, are culled", partial(_culled, 1)
    yield "the depth test keeps the farthest", lambda pieces, step: pieces._replace(depth=1 - pieces.depth)
    for scale in SCALES:
        yield f"its viewport is {scale:g} times as large as its target", partial(_scaled, scale)
    for x in JITTER:
        for y in JITTER:
            if (x, y) != (0.0, 0.0):
                yield _lies(x, y), partial(_shifted, x, y)


def _lies(x: float, y: float) -> str:
    parts = [f"{abs(d):g} pixels too far {SIDES[axis][d > 0]}" for axis, d in (("x", x), ("y", y)) if d]
    return f"the picture lies {' and '.join(parts)}: a viewport or a jitter"


def fitted_shift(todo: Redrawing) -> tuple[float, float]:
    """The pixels to the right and up by which a dumped buffer lies off, to a part of a pixel; 0 where none is seen."""
    got, shift = todo.case.drawing.buffers[todo.buffer], np.zeros(2)
    if got.dtype != np.float32:
        return 0.0, 0.0
    finest = 2**todo.case.profile.subpixel_bits
    for _ in range(CLOSER):
        shift += _offset(todo.draw(move=partial(_shifted, *shift)), got)
    x, y = np.rint(np.clip(shift, -FARTHEST, FARTHEST) * finest) / finest
    return float(x), float(y)


def _offset(drawn: np.ndarray, got: np.ndarray) -> np.ndarray:
    """How far `got` lies to the right of and above what was drawn, float64 (2,), by least squares on the smooth half.

    To first order got(p) = drawn(p - shift) = drawn(p) - shift . slope(p) (Lucas and Kanade 1981).
    """
    with np.errstate(all="ignore"):
        picture = np.atleast_3d(drawn).astype(np.float64)
        up, right = (np.asarray(np.gradient(picture, axis=axis)) for axis in (0, 1))
        bent = np.abs(np.gradient(up, axis=0)) + np.abs(np.gradient(right, axis=1))
        off = picture - np.atleast_3d(got)
        seen = np.isfinite(bent) & np.isfinite(off) & (np.abs(right) + np.abs(up) > 0)
    if not seen.any():
        return np.zeros(2)
    smooth = seen & (bent <= np.median(bent[seen]))
    slopes = np.stack([right[smooth], up[smooth]], axis=-1)
    fitted: np.ndarray = np.linalg.lstsq(slopes, off[smooth], rcond=None)[0]
    return fitted


def _shifted(x: float, y: float, pieces: Primitives, step: int) -> Primitives:
    move = np.rint(np.array([x, y]) * step).astype(np.int32)
    return pieces._replace(snapped=np.ascontiguousarray(pieces.snapped + move))


def _scaled(scale: float, pieces: Primitives, step: int) -> Primitives:
    half = step // 2
    return pieces._replace(snapped=np.rint((pieces.snapped + half) * scale - half).astype(np.int32))


def _culled(sign: int, pieces: Primitives, step: int) -> Primitives:
    a, b, c = (pieces.snapped[pieces.corners[:, k]].astype(np.int64).T for k in range(3))
    turn = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    return only(pieces, turn * sign > 0)
