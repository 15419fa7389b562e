"""Stages as plain NumPy: every component an array with one element per fragment. The oracle's own oracle."""

from collections.abc import Iterator, Mapping
from concurrent.futures import Executor
from typing import Any

import numpy as np

from sss_ref.interpret.finite import is_finite
from sss_ref.interpret.work import Work, buffer_value, store, uniform_value
from sss_ref.language.layout import CHANNELS
from sss_ref.language.pipeline import CLIP_POSITION, MESH_ATTRIBUTES, PIXEL, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import components, ivec2
from sss_ref.raster.interpolate import interpolate_arrays

CHUNK = 1 << 16  # fragments at a time, so that the temporaries stay in the cache


def run_vertices(
    this_pass: Pass,
    mesh: Mapping[str, np.ndarray],
    uniforms: Mapping[str, Any],
    varyings: Mapping[str, int],
    columns: int,
) -> tuple[np.ndarray, np.ndarray]:
    """Run the vertex stage of a pass: clip positions float32 (V, 4) and the wanted varyings, float32 (V, columns).

    mesh: vertex attribute -> float32 (V, C). uniforms: with the textures that the stage reads, as in `Work`.
    varyings: name -> first column.
    """
    (stage,), inputs = this_pass.draw.vertex_stages, []
    for own, kind in stage.parameters.items():
        raw = mesh[own] if own in MESH_ATTRIBUTES else uniforms[stage.reads[own]]
        inputs.append(kind(*raw.T) if own in MESH_ATTRIBUTES else uniform_value(kind, raw))
    results = stage.run(inputs)
    count = len(mesh["position"])
    clip_position, attributes = np.empty((count, 4), np.float32), np.empty((count, columns), np.float32)
    for k, component in enumerate(components(results[stage.writes[CLIP_POSITION]])):
        clip_position[:, k] = component
    for name, first in varyings.items():
        for k, component in enumerate(components(results[name])):
            attributes[:, first + k] = component
    return clip_position, attributes


def run_fragments(work: Work, pool: Executor | None) -> bool:
    """Run the stages of a pass on all its fragments and fill its outputs: whether all of these are finite.

    Array code has no use for the pool.
    """
    for name, background in work.backgrounds.items():
        buffer = work.outputs[name]
        buffer[...] = background if buffer.ndim == 3 else background[0]
    for at in in_chunks(work.fragments.where):
        values = stage_values(work, *at)
        for name, buffer in work.outputs.items():
            store(buffer, *at, values[name])
    return is_finite(work)


def in_chunks(where: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """The rows and columns of the pixels of a mask, bool (H, W), at most CHUNK at a time."""
    rows, columns = np.nonzero(where)
    for start in range(0, len(rows), CHUNK):
        yield rows[start : start + CHUNK], columns[start : start + CHUNK]


def stage_values(work: Work, rows: np.ndarray, columns: np.ndarray) -> dict[str, Any]:
    """All values that the stages of a pass compute at the pixels (rows, columns), with what the draw gives them."""
    values = draw_values(work, rows, columns)
    for _ in run_stages(work, rows, columns, values):
        pass
    return values


def run_stages(
    work: Work, rows: np.ndarray, columns: np.ndarray, values: dict[str, Any]
) -> Iterator[tuple[Stage, list[Any], dict[str, Any]]]:
    """Run the stages one by one, adding to `values`; after each, the stage, its inputs in order, and what it gave."""
    for stage in work.this_pass.stages:
        kinds = stage.parameters.items()
        inputs = [stage_input(work, values, stage.reads[own], kind, (rows, columns)) for own, kind in kinds]
        results = stage.run(inputs)
        values |= results
        yield stage, inputs, results


def stage_input(work: Work, values: Mapping[str, Any], name: str, kind: Any, at: tuple[np.ndarray, np.ndarray]) -> Any:
    """What a stage reads under a name: a value of its own pass, a buffer of an earlier one, or a uniform."""
    if name in work.handed_on:
        return buffer_value(kind, work.handed_on[name], *at)
    if name in values:
        return values[name]
    if name in work.buffers:
        return buffer_value(kind, work.buffers[name], *at)
    return uniform_value(kind, work.uniforms[name])


def pixel_numbers(rows: np.ndarray, columns: np.ndarray) -> ivec2:
    """The pixels as a stage reads them, x first."""
    return ivec2(columns.astype(np.int32), rows.astype(np.int32))


def draw_values(work: Work, rows: np.ndarray, columns: np.ndarray) -> dict[str, Any]:
    """What a draw gives each fragment: its pixel, the interpolated varyings, and what the rasterizer wrote."""
    values: dict[str, Any] = {PIXEL: pixel_numbers(rows, columns)}
    draw, fragments = work.this_pass.draw, work.fragments
    if not draw.vertex_stages:
        return values
    primitives, piece = fragments.of_mesh
    pieces = piece[rows, columns]
    attributes = interpolate_arrays(primitives, pieces, columns, rows, fragments.step)
    for name, first in fragments.varyings.items():
        kind = draw.varyings[name]
        values[name] = kind(*attributes.T[first : first + CHANNELS[kind]])
    values[draw.triangle] = primitives.triangle[pieces]
    values[draw.coverage] = np.ones(len(rows), bool)
    return values
