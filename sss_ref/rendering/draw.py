"""One pass of a scene, drawn: from scene, pass and buffers to fragments, and from fragments to buffers."""

from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, field
from types import ModuleType

import numpy as np

from sss_ref.cache.spare_memory import SPARE
from sss_ref.errors import MeshError
from sss_ref.errors.wording import told
from sss_ref.interpret import arrays
from sss_ref.interpret.not_finite import not_finite
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language.layout import CHANNELS, dtype_of, shape_of
from sss_ref.language.pipeline import Pass
from sss_ref.raster.primitives import Primitives, assemble
from sss_ref.raster.rasterize import Bins, bin_pieces, first_and_last, visibility
from sss_ref.raster.viewport import FINEST, Viewport
from sss_ref.scene.scene import Scene

Buffers = Mapping[str, np.ndarray]
OTHER_UVS = "export the mesh without UVs and set mesh.unwrap = true"


@dataclass(frozen=True)
class Machine:
    """What runs a pass.

    interpreter: a module with run_vertices and run_fragments. pool: of threads; None: one. subpixel_bits: of the snap
    (rule R2). stops: whether a value that is not finite ends the rendering (rule A6).
    """

    interpreter: ModuleType = arrays
    pool: Executor | None = None
    subpixel_bits: int = FINEST
    stops: bool = True

    def viewport(self, scene: Scene, this_pass: Pass) -> Viewport:
        """The picture that a pass draws into."""
        return Viewport(*scene.size(this_pass), self.subpixel_bits)


@dataclass(frozen=True)
class ReadyMesh:
    """The mesh as a pass draws it: its pieces, and which bands of the picture each touches."""

    primitives: Primitives
    bins: Bins


@dataclass(frozen=True)
class Sketch:
    """A pass before its stages run.

    fragments: where they will run. written: what the rasterizer itself wrote. notes: what may surprise.
    """

    fragments: Fragments
    written: dict[str, np.ndarray] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


def draw(scene: Scene, this_pass: Pass, buffers: Buffers, machine: Machine, ready: ReadyMesh | None = None) -> Sketch:
    """Rasterize the mesh if the pass draws it, or else take its rectangle.

    buffers: those of earlier passes by name. ready: what `made_ready` gives, if that is done.
    Raises MeshError where a UV layout is empty, or overlaps and must not.
    """
    if not this_pass.draw.vertex_stages:
        stencil = buffers[this_pass.draw.stencil] if this_pass.draw.stencil else None
        return Sketch(Fragments(*scene.size(this_pass), stencil=stencil))
    viewport = machine.viewport(scene, this_pass)
    varyings, _ = varying_columns(this_pass)
    ready = ready or made_ready(scene, this_pass, buffers, machine)
    primitives, bins = ready.primitives, ready.bins
    notes: tuple[str, ...] = ()
    if this_pass.draw.layout:
        first, last, depth = first_and_last(primitives, viewport, machine.pool, bins)
        piece, notes = _laid_out(scene, primitives, first, last)
    else:
        piece, depth = visibility(primitives, viewport, machine.pool, bins)
    fragments = Fragments(viewport.width, viewport.height, primitives, piece, viewport.step, varyings)
    return Sketch(fragments, {this_pass.draw.depth: depth}, notes)


def made_ready(scene: Scene, this_pass: Pass, buffers: Buffers, machine: Machine) -> ReadyMesh:
    """The mesh before a pass draws it; one thread does it."""
    viewport = machine.viewport(scene, this_pass)
    primitives = assemble(*vertices(scene, this_pass, buffers, machine), scene.mesh_of(this_pass).triangles, viewport)
    return ReadyMesh(primitives, bin_pieces(primitives, viewport))


def vertices(scene: Scene, this_pass: Pass, buffers: Buffers, machine: Machine) -> tuple[np.ndarray, np.ndarray]:
    """What the vertex stage of a pass gives: clip positions float32 (V, 4), and the varyings that are read, (V, C)."""
    given = {**scene.uniforms, **buffers}
    clip_position, varyings = machine.interpreter.run_vertices(
        this_pass, scene.mesh_of(this_pass).attributes, given, *varying_columns(this_pass)
    )
    return clip_position, varyings


def varying_columns(this_pass: Pass) -> tuple[dict[str, int], int]:
    """The varyings that the stages of a pass read -> their first attribute column, and the number of columns."""
    read = {name for stage in this_pass.stages for name in stage.reads.values()}
    columns, count = {}, 0
    for name, kind in this_pass.draw.varyings.items():
        if name in read:
            columns[name] = count
            count += CHANNELS[kind]
    return columns, count


def shade(
    scene: Scene, this_pass: Pass, fragments: Fragments, buffers: Buffers, names: list[str], machine: Machine
) -> dict[str, np.ndarray]:
    """Run the stages of a pass once; the named outputs. Raises RenderError where one is not finite (rule A6)."""
    kinds, size = this_pass.values, (fragments.width, fragments.height)
    outputs = {name: SPARE.empty(shape_of(kinds[name], *size), dtype_of(kinds[name])) for name in names}
    backgrounds = {name: np.full(CHANNELS[kinds[name]], scene.clear(name), dtype_of(kinds[name])) for name in names}
    work = Work(this_pass, fragments, scene.uniforms, buffers, outputs, backgrounds)
    finite = machine.interpreter.run_fragments(work, machine.pool)
    if machine.stops and not finite:
        raise not_finite(work)
    return outputs


def _laid_out(
    scene: Scene, primitives: Primitives, first: np.ndarray, last: np.ndarray
) -> tuple[np.ndarray, tuple[str, ...]]:
    """The piece of each texel of a UV layout, by the scene's policy for texels that several triangles cover.

    first, last: of these triangles the first and the last.
    """
    if not (first >= 0).any():
        raise MeshError(told(scene.mesh.name, "UVs inside 0 to 1", "none that cover a texel", OTHER_UVS))
    overlapping = np.count_nonzero(first != last)
    if not overlapping:
        return first, ()
    policy = scene.settings.irradiance_map.overlap
    if policy == "error":
        row, column = np.argwhere(first != last)[0]
        pair = primitives.triangle[[first[row, column], last[row, column]]].tolist()
        came = f"{overlapping} texels covered twice or more, triangles {pair[0]} and {pair[1]} among them"
        remedy = f'set irradiance_map.overlap = "first", or {OTHER_UVS}'
        raise MeshError(told(scene.mesh.name, "UVs without overlap", came, remedy))
    share = f"{overlapping} of {int((first >= 0).sum())}"
    note = f"irradiance map: {share} texels are covered more than once; the {policy} triangle counts"
    return (last if policy == "last" else first), (note,)
