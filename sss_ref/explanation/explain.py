"""Collects what made one pixel, from the triangle it shows to its final colour."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from sss_ref.errors import SceneError
from sss_ref.explanation.places import Place, place_of
from sss_ref.interpret import arrays
from sss_ref.interpret.arrays import draw_values, stage_input
from sss_ref.interpret.trace import Bounds, Step, scalar, trace
from sss_ref.interpret.work import Fragments, Work, uniform_value
from sss_ref.language.pipeline import MESH_ATTRIBUTES, MeshDraw, Pass
from sss_ref.language.stage import Stage
from sss_ref.raster.interpolate import weights_arrays
from sss_ref.rendering.fold import Rendering, render
from sss_ref.rendering.result import Result
from sss_ref.scene.catalogue import method_of_scene
from sss_ref.scene.load import Scene
from sss_ref.scene_file.viewpoints import Camera


@dataclass(frozen=True)
class StageTrace:
    """A stage at one fragment or vertex.

    reads: name -> value, textures and uniform arrays included. writes: name -> value. at: which vertex, or "".
    bounds: name -> what a value that is read may be at least and at most on another processor, if that was asked for.
    """

    stage: Stage
    reads: Mapping[str, Any]
    steps: tuple[Step, ...]
    writes: Mapping[str, Any]
    at: str = ""
    bounds: Mapping[str, Bounds | None] = field(default_factory=dict)


@dataclass(frozen=True)
class Corner:
    """A corner of the piece that a fragment lies on: its weight, exact in float32 (rule R5), and its 1/w."""

    vertex: int
    weight: np.float32
    inverse_w: np.float32


@dataclass(frozen=True)
class Drawn:
    """What a draw of the mesh gives a fragment; clipped: the corners are cut vertices and not the triangle's own."""

    triangle: int
    corners: tuple[Corner, ...]
    clipped: bool
    vertices: tuple[StageTrace, ...]  # the vertex stage at the corners of the triangle
    values: Mapping[str, Any]  # varyings, interpolated


@dataclass(frozen=True)
class PassTrace:
    """A pass at one pixel of its target. drawn: None for a rectangle. stages: empty where nothing is drawn."""

    name: str
    place: Place
    drawn: Drawn | None
    stages: tuple[StageTrace, ...]


@dataclass(frozen=True)
class Explanation:
    """All passes that led to a pixel, in order. result: the whole rendering, with every buffer."""

    result: Result
    pixel: tuple[int, int]
    passes: tuple[PassTrace, ...]

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        from sss_ref.explanation.page import html
        from sss_ref.explanation.rows import sections

        return html(sections(self))


def explain(
    scene: Scene | Result, pixel: tuple[int, int], interpreter: str = "kernel", threads: int | None = None
) -> Explanation:
    """Trace every stage that made one pixel of a scene's image.

    scene: a scene, which is rendered first, or a rendering of one with all its buffers. pixel: (column, row), row 0 at
    the bottom. interpreter, threads: as in `render`.
    Raises SceneError for a pixel outside the image or a rendering without all buffers, and as `render` does.
    """
    seen = scene.scene if isinstance(scene, Result) else scene
    _check_pixel(pixel, seen.settings.camera)
    result = scene if isinstance(scene, Result) else render(scene, interpreter, threads)
    method = method_of_scene(seen)
    for missing in (name for name in method.outputs if name not in result.buffers):
        raise SceneError(f'scene: expected all buffers in the rendering, got no {missing}; render with keep="all"')
    rendering = Rendering(result.scene, arrays, None, set(result.buffers))
    rendering.buffers.update(result.buffers)
    passes = [one for one in method.passes if not one.on_demand]
    traced = [_traced(rendering, one, place_of(one, rendering.size(one), result.buffers, pixel)) for one in passes]
    return Explanation(result, pixel, tuple(traced))


def _check_pixel(pixel: tuple[int, int], camera: Camera) -> None:
    column, row = pixel
    if not (0 <= column < camera.width and 0 <= row < camera.height):
        raise SceneError(
            f"pixel: expected column 0 to {camera.width - 1} and row 0 to {camera.height - 1}, got {column},{row}; "
            "row 0 is at the bottom"
        )


def _traced(rendering: Rendering, one: Pass, place: Place) -> PassTrace:
    """One pass at one place of its target."""
    if not one.rounds:
        place = Place(None, "no round: what it reads is what it gives")
    if place.pixel is None:
        return PassTrace(one.name, place, None, ())
    fragments, _ = rendering.draw(one)
    column, row = place.pixel
    if not fragments.where[row, column]:
        return PassTrace(one.name, replace(place, reason=f"{place.reason}; nothing is drawn there"), None, ())
    work = Work(one, fragments, rendering.uniforms, _inputs(rendering, one, fragments), {}, {})
    at = np.array([row]), np.array([column])
    values = {name: scalar(value) for name, value in draw_values(work, *at).items()}
    drawn = _drawn(rendering, work, place.pixel, values) if isinstance(one.draw, MeshDraw) else None
    return PassTrace(one.name, place, drawn, tuple(_stages(work, at, values)))


def _inputs(rendering: Rendering, one: Pass, fragments: Fragments) -> Mapping[str, np.ndarray]:
    """The buffers that the last round of a pass reads."""
    buffers = rendering.buffers
    for _ in range(one.rounds - 1):
        outputs = rendering.shade(one, fragments, buffers, list(one.outputs))
        buffers = buffers | {name: outputs[own] for name, own in one.feedback.items()}
    return buffers


def _stages(work: Work, at: tuple[np.ndarray, np.ndarray], values: dict[str, Any]) -> Iterator[StageTrace]:
    """Trace the stages one after the other; `values` gets what they write."""
    for stage in work.this_pass.stages:
        kinds = stage.parameters.items()
        inputs = [scalar(stage_input(work, values, stage.reads[own], kind, at)) for own, kind in kinds]
        steps, writes = trace(stage, inputs)
        values |= writes
        yield StageTrace(stage, dict(zip(stage.reads.values(), inputs, strict=True)), steps, writes)


def _drawn(rendering: Rendering, work: Work, pixel: tuple[int, int], values: Mapping[str, Any]) -> Drawn:
    """The triangle under a pixel, its corners, and what is interpolated between them."""
    draw, fragments = work.this_pass.draw, work.fragments
    assert isinstance(draw, MeshDraw) and fragments.piece is not None and fragments.primitives is not None
    (column, row), primitives = pixel, fragments.primitives
    piece = fragments.piece[row, column]
    weights = weights_arrays(primitives, np.array([piece]), np.array([column]), np.array([row]), fragments.step)[:, 0]
    triangle = int(primitives.triangle[piece])
    own = rendering.scene.mesh.triangles[triangle]
    corners = primitives.corners[piece]
    return Drawn(
        triangle,
        tuple(Corner(int(v), w, primitives.inverse_w[v]) for v, w in zip(corners, weights, strict=True)),
        not np.array_equal(own, corners),
        tuple(_vertex(rendering, draw.vertex, int(vertex)) for vertex in own),
        {name: values[name] for name in fragments.varyings},
    )


def _vertex(rendering: Rendering, stage: Stage, vertex: int) -> StageTrace:
    """The vertex stage at one vertex of the mesh."""
    given = {name: attribute[vertex] for name, attribute in rendering.scene.mesh.attributes.items()}
    uniforms = rendering.uniforms | rendering.buffers
    inputs = [
        uniform_value(kind, given[own] if own in MESH_ATTRIBUTES else uniforms[stage.reads[own]])
        for own, kind in stage.parameters.items()
    ]
    steps, writes = trace(stage, inputs)
    return StageTrace(stage, dict(zip(stage.reads.values(), inputs, strict=True)), steps, writes, f"vertex {vertex}")
