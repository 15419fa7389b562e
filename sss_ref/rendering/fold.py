"""Rendering: a method's passes, folded over a dictionary of buffers."""

import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.errors import MeshError, SceneError
from sss_ref.errors.wording import told
from sss_ref.interpret import arrays
from sss_ref.interpret.finite import require_finite
from sss_ref.interpret.kernel import loops as kernel
from sss_ref.interpret.work import CHANNELS, Fragments, Work, dtype_of, shape_of
from sss_ref.language.pipeline import MeshDraw, Method, Pass, ScreenDraw
from sss_ref.passes.buffers import background
from sss_ref.raster.primitives import Primitives, assemble
from sss_ref.raster.rasterize import visibility
from sss_ref.raster.viewport import FINEST, Viewport
from sss_ref.rendering.result import Result
from sss_ref.scene.catalogue import method_of_scene
from sss_ref.scene.load import Scene
from sss_ref.scene.uniforms import uniforms
from sss_ref.scene.until import buffers_kept

OTHER_UVS = "export the mesh without UVs and set mesh.unwrap = true"
INTERPRETERS = {"kernel": kernel, "arrays": arrays}


def render(
    scene: Scene,
    interpreter: str = "kernel",
    threads: int | None = None,
    keep: str | Iterable[str] = "all",
    on_pass: Callable[[str], None] | None = None,
    subpixel_bits: int = FINEST,
) -> Result:
    """Render a scene: every stage of its method, pass by pass.

    scene: what `load_scene` gives.
    interpreter: "kernel" (compiled) or "arrays" (NumPy); the bits are the same.
    threads: how many share the work (None: as many as there are processors); the bits are the same.
    keep: what is written, a name or several (see `buffers_kept`): "all" buffers, the "final" image, "taps",
        "registers", or buffers one by one.
    on_pass: called with the name of each pass before it runs.
    subpixel_bits: of the snap (rule R2), 0 to 8; 8, the default, are the rules' bits, others for comparing with a GPU.
    Raises SceneError for an unknown interpreter or buffer or bits out of range, RenderError where a stage gives NaN
    or infinity.
    """
    if interpreter not in INTERPRETERS:
        raise SceneError(f"interpreter: expected one of {', '.join(INTERPRETERS)}, got {interpreter!r}")
    method = method_of_scene(scene)
    with _pool(threads) as pool:
        rendering = Rendering(scene, INTERPRETERS[interpreter], pool, buffers_kept(method, keep), subpixel_bits)
        needed = method.only(rendering.kept)
        for one in needed.passes:
            if on_pass:
                on_pass(one.name)
            rendering.run(one, _needed_after(needed, one))
    buffers = {name: rendering.buffers[name] for name in method.values if name in rendering.kept}
    return Result(scene, buffers, rendering.timings, notes=tuple(rendering.notes))


@contextmanager
def _pool(threads: int | None) -> Iterator[Executor | None]:
    count = threads or os.cpu_count() or 1
    if count == 1:
        yield None
        return
    with ThreadPoolExecutor(count) as pool:
        yield pool


def _needed_after(method: Method, one: Pass) -> set[str]:
    """What the passes after `one` read."""
    later = method.passes[method.passes.index(one) + 1 :]
    return {name for each in later for name in each.needs}


@dataclass
class Rendering:
    """One run through a method: what is there so far."""

    scene: Scene
    interpreter: Any
    pool: Executor | None
    kept: set[str]
    subpixel_bits: int = FINEST

    def __post_init__(self) -> None:
        self.uniforms = uniforms(self.scene)
        self.buffers: dict[str, np.ndarray] = {}
        self.timings: dict[str, float] = {}
        self.notes: list[str] = []

    def run(self, one: Pass, needed_later: set[str]) -> None:
        """Run a pass: rasterize if it draws the mesh, then its stages; keep what is wanted of its buffers."""
        start = time.perf_counter()
        wanted = [name for name in one.values if name in self.kept | needed_later]
        fragments, written = self.draw(one)
        fresh = [name for name in wanted if name not in written]
        outputs = {own: self.buffers[name] for name, own in one.feedback.items()}
        for _ in range(one.rounds if fresh else 0):
            fed = {name: outputs[own] for name, own in one.feedback.items()}
            outputs = self.shade(one, fragments, self.buffers | fed, [*outputs] if fed else fresh)
        written |= outputs
        self.buffers |= {name: written[name] for name in wanted}
        self.drop(needed_later)
        self.timings[one.name] = time.perf_counter() - start

    def shade(
        self, one: Pass, fragments: Fragments, buffers: Mapping[str, np.ndarray], names: list[str], check: bool = True
    ) -> dict[str, np.ndarray]:
        """Run the stages of a pass once; the named outputs. check: raise RenderError where one is not finite."""
        kinds, size = one.values, (fragments.width, fragments.height)
        outputs = {name: np.empty(shape_of(kinds[name], *size), dtype_of(kinds[name])) for name in names}
        backgrounds = {name: self.background(name, kinds[name]) for name in names}
        work = Work(one, fragments, self.uniforms, buffers, outputs, backgrounds)
        self.interpreter.run_fragments(work, self.pool)
        if check:
            require_finite(work, self.pool)
        return outputs

    def size(self, one: Pass) -> tuple[int, int]:
        """Width and height of a pass's target, from the scene table of that name."""
        table = getattr(self.scene.settings, one.target)
        return table.width, table.height

    def draw(self, one: Pass) -> tuple[Fragments, dict[str, np.ndarray]]:
        """The fragments of a pass's draw, and the buffers that the rasterizer itself has written."""
        width, height = self.size(one)
        if isinstance(one.draw, ScreenDraw):
            stencil = self.buffers[one.draw.stencil] if one.draw.stencil else None
            return Fragments(width, height, stencil=stencil), {}
        varyings, columns = varying_columns(one)
        clip_position, attributes = self.vertices(one, varyings, columns)
        viewport = self.viewport(one)
        primitives = assemble(clip_position, attributes, self.scene.mesh.triangles, viewport)
        piece, depth = visibility(primitives, viewport, self.pool)
        if one.draw.layout:
            piece = self.layout(primitives, viewport, piece)
        return Fragments(width, height, primitives, piece, viewport.step, varyings), {one.draw.depth: depth}

    def viewport(self, one: Pass) -> Viewport:
        """The picture that a pass draws into."""
        return Viewport(*self.size(one), self.subpixel_bits)

    def vertices(self, one: Pass, varyings: Mapping[str, int], columns: int) -> tuple[np.ndarray, np.ndarray]:
        """What the vertex stage of a pass gives: clip positions float32 (V, 4), and varyings, (V, columns)."""
        given = self.uniforms | self.buffers
        return self.interpreter.run_vertices(one, self.scene.mesh.attributes, given, varyings, columns)

    def layout(self, primitives: Primitives, viewport: Viewport, first: np.ndarray) -> np.ndarray:
        """The piece of each texel of a UV layout, by the scene's policy for texels that several triangles cover."""
        if not (first >= 0).any():
            came = "none that cover a texel"
            raise MeshError(told(self.scene.mesh.name, "UVs inside 0 to 1", came, OTHER_UVS))
        last, _ = visibility(primitives, viewport, self.pool, later_wins=True)
        overlapping = int((first != last).sum())
        policy = self.scene.settings.irradiance_map.overlap
        if overlapping and policy == "error":
            row, column = np.argwhere(first != last)[0]
            pair = primitives.triangle[[first[row, column], last[row, column]]].tolist()
            came = f"{overlapping} texels covered twice or more, triangles {pair[0]} and {pair[1]} among them"
            remedy = f'set irradiance_map.overlap = "first", or {OTHER_UVS}'
            raise MeshError(told(self.scene.mesh.name, "UVs without overlap", came, remedy))
        if overlapping:
            share = f"{overlapping} of {int((first >= 0).sum())}"
            self.notes.append(
                f"irradiance map: {share} texels are covered more than once; the {policy} triangle counts"
            )
        return last if policy == "last" else first

    def background(self, name: str, kind: Any) -> np.ndarray:
        """What a buffer holds where nothing is drawn, one value a channel."""
        return np.broadcast_to(background(name, self.uniforms), CHANNELS[kind]).astype(dtype_of(kind))

    def drop(self, needed_later: set[str]) -> None:
        """Forget what nobody asks for any more."""
        for name in set(self.buffers) - self.kept - needed_later:
            del self.buffers[name]


def varying_columns(one: Pass) -> tuple[dict[str, int], int]:
    """The varyings that the stages of a pass read -> their first attribute column, and the number of columns."""
    assert isinstance(one.draw, MeshDraw)
    read = {name for stage in one.stages for name in stage.reads.values()}
    columns, count = {}, 0
    for name, kind in one.draw.varyings.items():
        if name in read:
            columns[name] = count
            count += CHANNELS[kind]
    return columns, count
