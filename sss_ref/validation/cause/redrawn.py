"""A draw of the mesh with one thing changed: its matrices, its viewport, the triangles that it keeps."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.work import Fragments
from sss_ref.language.names import Name
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import mat3, mat4
from sss_ref.raster.primitives import Primitives, drawable, only, place
from sss_ref.raster.rasterize import visibility
from sss_ref.rendering.draw import Machine, shade, varying_columns, vertices
from sss_ref.rendering.fold import folded
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.rebased import Check, checks_of
from sss_ref.validation.cause.hypothesis import INPUT, NUMBER, SETTING, STATE, Charge
from sss_ref.validation.cause.mishaps import turns

Move = Callable[[Primitives, int], Primitives]  # of pieces, and the step of a pixel
Matrix = np.ndarray
ZOOMS = (0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 1.005, 1.01, 1.02, 1.05, 1.1, 1.25, 2.0)
TURNS = (-5.0, -2.0, -1.0, -0.5, -0.25, -0.1, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0)  # degrees
SCALES = {  # of a viewport, in x and y
    "0.5": (0.5, 0.5),
    "2": (2.0, 2.0),
    "0.5 in x": (0.5, 1.0),
    "0.5 in y": (1.0, 0.5),
    "2 in x": (2.0, 1.0),
    "2 in y": (1.0, 2.0),
}
SHIFTS = (-1.0, -0.5, 0.0, 0.5, 1.0)  # pixels
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

    def of(self, buffer: str) -> "Redrawing":
        """The same of another buffer of the pass."""
        return replace(self, buffer=buffer)

    def with_vertex(self, stage: Stage) -> "Redrawing":
        """The same with another vertex stage."""
        assert isinstance(self.this_pass.draw, MeshDraw)
        return replace(self, this_pass=replace(self.this_pass, draw=replace(self.this_pass.draw, vertex=stage)))

    def scene(self, uniforms: Mapping[str, Any]) -> Scene:
        """The scene with other uniforms."""
        own = self.case.oracle.scene
        return replace(own, own_uniforms={**own.own_uniforms, **uniforms})

    def judged(self, uniforms: Mapping[str, Any], profile: Profile) -> Check:
        """The buffer beside what a processor of a profile may write with other uniforms."""
        oracle, names = self.case.oracle, {self.buffer, *self.this_pass.draw.outputs}
        scene = self.scene(uniforms)
        machine = Machine(subpixel_bits=profile.subpixel_bits, stops=False)
        there = {**oracle.buffers, **folded(scene, machine, names).buffers}
        case = Case(Result(scene, there, {}), self.case.drawing, profile)
        found = checks_of(case, self.this_pass.only(names))
        return next(check for check in found if check.buffer == self.buffer)

    def draw(self, uniforms: Mapping[str, Any] = {}, move: Move = as_they_are) -> np.ndarray:
        """The buffer (H, W) or (H, W, C) with other uniforms and with pieces moved or left out."""
        there = {**self.case.oracle.buffers, **self.case.drawing.buffers}
        scene = self.scene(uniforms)
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


def redrawings(todo: Redrawing) -> Iterator[tuple[Charge, int, Callable[[], np.ndarray]]]:
    """What may be wrong with the draw, how simple an explanation that is, and the buffer then."""
    for text, changed in _matrices(todo):
        yield Charge(text, INPUT, tuple(changed)), NUMBER, partial(todo.draw, changed)
    for rank, text, move in _moves():
        yield Charge(text, SETTING), rank, partial(todo.draw, move=move)


def _matrices(todo: Redrawing) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Every matrix of the vertex stage made another one."""
    uniforms = todo.case.oracle.scene.uniforms
    width, height = todo.case.oracle.scene.size(todo.this_pass)
    for name in (name for name, kind in todo.this_pass.draw.reads.items() if kind in (mat3, mat4)):
        for text, matrix in other_matrices(name, uniforms):
            yield text, {name: matrix}
        if "clip_from" in name and width != height:
            for text, factor in (("left out", width / height), ("turned round", (width / height) ** 2)):
                matrix = np.diag([factor, 1, 1, 1]) @ np.asarray(uniforms[name], np.float64)
                yield f"{name} is of another aspect ratio: it is {text}", {name: matrix.astype(np.float32)}


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
            changed[f"{seen_otherwise(right)} {zoom:g} times as large"] = np.diag([1 / zoom, 1 / zoom, 1, 1]) @ right
        for degrees in TURNS:
            changed[f"of another time: the scene is turned by {degrees:g} degrees about the vertical"] = right @ _turn(
                degrees
            )
    for text, matrix in changed.items():
        yield f"{name} is {text}", matrix.astype(np.float32)


def seen_otherwise(projection: Matrix) -> str:
    """What differs where a view sees more or less, by its projection."""
    is_parallel = not projection[3, :3].any()
    return "of another height: view_height is" if is_parallel else "of another field of view: tan(fov_y/2) is"


def _half_depth() -> Matrix:
    return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0.5, 0.5], [0, 0, 0, 1.0]])


def _turn(degrees: float) -> Matrix:
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[cosine, 0, sine, 0], [0, 1, 0, 0], [-sine, 0, cosine, 0], [0, 0, 0, 1.0]])


def _moves() -> Iterator[tuple[int, str, Move]]:
    """Culling, viewports of another size, and pictures that lie elsewhere."""
    yield STATE, "front faces, counter-clockwise in the window, are culled", partial(_culled, -1)
    yield STATE, "back faces, clockwise in the window, are culled", partial(_culled, 1)
    yield STATE, "the depth test keeps the farthest", lambda pieces, step: pieces._replace(depth=1 - pieces.depth)
    for told, scale in SCALES.items():
        yield NUMBER, f"its viewport is {told} times as large as its target", partial(_scaled, np.array(scale))
    for x in SHIFTS:
        for y in SHIFTS:
            if (x, y) != (0.0, 0.0):
                yield STATE, f"{lies(x, y)}: a viewport or a jitter", partial(_shifted, x, y)


def lies(x: float, y: float) -> str:
    """Where a picture lies that is so many pixels too far to the right and up, in words."""
    parts = [
        f"{abs(d):.3g} pixel{'' if abs(d) == 1 else 's'} too far {SIDES[axis][d > 0]}"
        for axis, d in (("x", x), ("y", y))
        if d
    ]
    return f"the picture lies {' and '.join(parts)}"


def _shifted(x: float, y: float, pieces: Primitives, step: int) -> Primitives:
    move = np.rint(np.array([x, y]) * step).astype(np.int32)
    return pieces._replace(snapped=np.ascontiguousarray(pieces.snapped + move))


def _scaled(scale: np.ndarray, pieces: Primitives, step: int) -> Primitives:
    half = step // 2
    return pieces._replace(snapped=np.rint((pieces.snapped + half) * scale - half).astype(np.int32))


def _culled(sign: int, pieces: Primitives, step: int) -> Primitives:
    return only(pieces, turns(pieces) * sign > 0)
