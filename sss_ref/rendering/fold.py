"""Rendering: a method's passes, folded over a dictionary of buffers.

Each pass is handed what the passes before it wrote, first drawn (`draw`: on which pixels are there fragments?), then
shaded (`shade`: what do its stages write there?). What comes out is added to the dictionary; what neither a later pass
reads nor the caller keeps is let go.
"""

import os
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from contextlib import contextmanager

import numpy as np

from sss_ref.errors import SceneError
from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips
from sss_ref.language.pipeline import Pass
from sss_ref.raster.viewport import FINEST
from sss_ref.rendering.crew import Crew
from sss_ref.rendering.cut_off import cut_off
from sss_ref.rendering.draw import Buffers, Machine, Sketch, draw, shade
from sss_ref.rendering.foresight import Foresight
from sss_ref.rendering.memory import check_memory
from sss_ref.rendering.nothing_shown import hidden, nothing_drawn
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene

INTERPRETERS = {"kernel": strips, "arrays": arrays}


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
    Raises SceneError for an unknown interpreter or buffer, bits out of range, or more than 4 GiB of buffers at one
    time; RenderError where a stage gives NaN or infinity.
    """
    with machine_of(interpreter, threads, subpixel_bits) as machine:
        return folded(scene, machine, scene.kept(keep), on_pass)


@contextmanager
def machine_of(interpreter: str, threads: int | None = None, subpixel_bits: int = FINEST) -> Iterator[Machine]:
    """What runs the passes, its threads waiting until the end; the arguments are those of `render`."""
    if interpreter not in INTERPRETERS:
        raise SceneError(f"interpreter: expected one of {', '.join(INTERPRETERS)}, got {interpreter!r}")
    with _pool(threads) as pool:
        yield Machine(INTERPRETERS[interpreter], pool, subpixel_bits)


def folded(
    scene: Scene,
    machine: Machine,
    kept: set[str],
    on_pass: Callable[[str], None] | None = None,
    on_buffer: Callable[[str, np.ndarray], None] | None = None,
) -> Result:
    """Render the buffers `kept` of a scene on a machine, as `render` does.

    on_buffer: handed each of them, its name first, as soon as the pass that writes it is done. The result has none of
        them then but the image: the memory of what no later pass reads is free for others.
    """
    check_memory(scene, kept)
    buffers: dict[str, np.ndarray] = {}
    timings: dict[str, float] = {}
    notes: list[str] = []
    unshown: list[str] = []
    passes = [*scene.method.only(kept).in_order()]
    foresight = Foresight(scene, (this_pass for this_pass, _ in passes), machine)
    for this_pass, read_later in passes:
        if on_pass:
            on_pass(this_pass.name)
        start, needed = time.perf_counter(), kept | read_later
        sketch = draw(scene, this_pass, buffers, machine, foresight.mesh(this_pass))
        read, buffers = buffers, {name: buffer for name, buffer in buffers.items() if name in needed}
        buffers |= sketch.written | last_round(scene, this_pass, sketch, read, needed, machine)
        del read
        if on_buffer:
            for name in sorted(kept & set(this_pass.values)):
                on_buffer(name, buffers[name])
        held = read_later | kept & {"image"} if on_buffer else needed
        buffers = {name: buffer for name, buffer in buffers.items() if name in held}
        notes += sketch.notes
        unshown += nothing_drawn(scene, this_pass, sketch)
        timings[this_pass.name] = time.perf_counter() - start
    in_stage_order = {name: buffers[name] for name in scene.method.values if name in kept & set(buffers)}
    if "image" in kept and not unshown:
        image = buffers["image"]
        unshown += [*hidden(scene, image)] or [*cut_off(scene.settings.output, image)]
    return Result(scene, in_stage_order, timings, notes=(*notes, *unshown))


def shaded(
    scene: Scene, this_pass: Pass, sketch: Sketch, buffers: Buffers, wanted: set[str], machine: Machine
) -> dict[str, np.ndarray]:
    """What the stages of a pass write of the wanted outputs, run on the fragments of a draw as often as it has rounds.

    A pass that is fed back its own outputs gives those alone, round after round.
    """
    return last_round(scene, this_pass, sketch, {**buffers}, wanted, machine)


def last_round(
    scene: Scene, this_pass: Pass, sketch: Sketch, read: dict[str, np.ndarray], wanted: set[str], machine: Machine
) -> dict[str, np.ndarray]:
    """The same, but what only the first round reads is taken out of `read` after it, so that its memory is free."""
    names = [name for name in this_pass.values if name in wanted and name not in sketch.written]
    if not names:
        return {}
    every_round = [*this_pass.fed_back] or names

    def one_round(now: Buffers) -> Buffers:
        written = shade(scene, this_pass, sketch.fragments, now, every_round, machine)
        for name in this_pass.feedback:
            read.pop(name, None)
        return written

    return dict(this_pass.folded(read, one_round))


@contextmanager
def _pool(threads: int | None) -> Iterator[Executor | None]:
    """The threads that share the work; none where one does it all."""
    count = threads or os.cpu_count() or 1
    if count == 1:
        yield None
        return
    with Crew(count) as pool:
        yield pool
