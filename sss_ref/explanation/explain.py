"""Collects what made one pixel, from the triangle it shows to its final colour."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sss_ref.errors import SceneError
from sss_ref.explanation.page import html
from sss_ref.explanation.places import Place, place_of
from sss_ref.explanation.rows import sections
from sss_ref.explanation.traces import Corner, PassTrace, StageTrace, TriangleTrace
from sss_ref.interpret.arrays import draw_values, stage_input
from sss_ref.interpret.trace import scalar, trace
from sss_ref.interpret.work import Fragments, Work, uniform_value
from sss_ref.language.pipeline import MESH_ATTRIBUTES, Pass
from sss_ref.language.stage import Stage
from sss_ref.mesh.triangles import Mesh
from sss_ref.raster.interpolate import weights_arrays
from sss_ref.rendering.draw import Machine, draw, shade
from sss_ref.rendering.fold import render
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.viewpoints import Camera


@dataclass(frozen=True)
class Explanation:
    """All passes that led to a pixel, in order. result: the whole rendering, with every buffer."""

    result: Result
    pixel: tuple[int, int]
    passes: tuple[PassTrace, ...]

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return html(sections(self.passes))


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
    for missing in (name for name in seen.method.outputs if name not in result.buffers):
        raise SceneError(f'scene: expected all buffers in the rendering, got no {missing}; render with keep="all"')
    passes = [each for each in seen.method.passes if not each.on_demand]
    traced = [_traced(result, each, place_of(each, seen.size(each), result.buffers, pixel)) for each in passes]
    return Explanation(result, pixel, tuple(traced))


def _check_pixel(pixel: tuple[int, int], camera: Camera) -> None:
    column, row = pixel
    if not (0 <= column < camera.width and 0 <= row < camera.height):
        raise SceneError(
            f"pixel: expected column 0 to {camera.width - 1} and row 0 to {camera.height - 1}, got {column},{row}; "
            "row 0 is at the bottom"
        )


def _traced(result: Result, this_pass: Pass, place: Place) -> PassTrace:
    """One pass at one place of its target."""
    if place.pixel is None:
        return PassTrace(this_pass.name, place, None, ())
    fragments = draw(result.scene, this_pass, result.buffers, Machine()).fragments
    column, row = place.pixel
    if not fragments.where[row, column]:
        return PassTrace(this_pass.name, replace(place, reason=f"{place.reason}; nothing is drawn there"), None, ())
    inputs = _inputs(result, this_pass, fragments)
    if inputs is None:
        return PassTrace(this_pass.name, Place(None, "no round: what it reads is what it gives"), None, ())
    work = Work(this_pass, fragments, result.scene.uniforms, inputs, {}, {})
    at = np.array([row]), np.array([column])
    values = {name: scalar(value) for name, value in draw_values(work, *at).items()}
    drawn = _under(result, work, place.pixel, values) if this_pass.draw.vertex_stages else None
    return PassTrace(this_pass.name, place, drawn, tuple(_stages(work, at, values)))


def _inputs(result: Result, this_pass: Pass, fragments: Fragments) -> Mapping[str, np.ndarray] | None:
    """The buffers that the last round of a pass reads; None where it runs no round."""
    if not this_pass.fed_back:
        return result.buffers
    read: list[Mapping[str, np.ndarray]] = []

    def shaded(buffers: Mapping[str, np.ndarray]) -> Mapping[str, np.ndarray]:
        read.append(buffers)
        return shade(result.scene, this_pass, fragments, buffers, [*this_pass.fed_back], Machine())

    this_pass.folded(result.buffers, shaded)
    return read[-1] if read else None


def _stages(work: Work, at: tuple[np.ndarray, np.ndarray], values: dict[str, Any]) -> Iterator[StageTrace]:
    """Trace the stages one after the other; `values` gets what they write."""
    for stage in work.this_pass.stages:
        kinds = stage.parameters.items()
        inputs = [scalar(stage_input(work, values, stage.reads[own], kind, at)) for own, kind in kinds]
        steps, writes = trace(stage, inputs)
        values |= writes
        yield StageTrace(stage, dict(zip(stage.reads.values(), inputs, strict=True)), steps, writes)


def _under(result: Result, work: Work, pixel: tuple[int, int], values: Mapping[str, Any]) -> TriangleTrace:
    """The triangle under a pixel that the mesh covers, its corners, and what is interpolated between them."""
    (column, row), fragments, mesh = pixel, work.fragments, result.scene.mesh_of(work.this_pass)
    primitives, pieces = fragments.of_mesh
    piece = pieces[row, column]
    weights = weights_arrays(primitives, np.array([piece]), np.array([column]), np.array([row]), fragments.step)[:, 0]
    triangle = int(primitives.triangle[piece])
    corners, own = primitives.corners[piece], mesh.triangles[triangle]
    return TriangleTrace(
        triangle,
        tuple(Corner(int(v), w, primitives.inverse_w[v]) for v, w in zip(corners, weights, strict=True)),
        not np.array_equal(own, corners),
        tuple(_vertex(result, mesh, stage, int(v)) for stage in work.this_pass.draw.vertex_stages for v in own),
        {name: values[name] for name in fragments.varyings},
    )


def _vertex(result: Result, mesh: Mesh, stage: Stage, vertex: int) -> StageTrace:
    """The vertex stage at one vertex of the mesh."""
    given = {name: attribute[vertex] for name, attribute in mesh.attributes.items()}
    uniforms = {**result.scene.uniforms, **result.buffers}
    inputs = [
        uniform_value(kind, given[own] if own in MESH_ATTRIBUTES else uniforms[stage.reads[own]])
        for own, kind in stage.parameters.items()
    ]
    steps, writes = trace(stage, inputs)
    return StageTrace(stage, dict(zip(stage.reads.values(), inputs, strict=True)), steps, writes, f"vertex {vertex}")
