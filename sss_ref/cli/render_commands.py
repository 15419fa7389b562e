"""`sss-ref render` and `warmup`."""

import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter
from rich.markup import escape
from rich.table import Table

from sss_ref.cli.console import announce_compilation, err, out, progress
from sss_ref.cli.options import EVERYTHING, KERNELS, NO_CHANGES, Changes, Execution, Wanted

if TYPE_CHECKING:
    import numpy as np

    from sss_ref.rendering.result import Result
    from sss_ref.scene.scene import Scene

HASH_DIGITS = 12


def render(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The result folder; replaces an earlier result.")] = Path("out"),
    changes: Changes = NO_CHANGES,
    wanted: Wanted = EVERYTHING,
    execution: Execution = KERNELS,
) -> int:
    """Render a scene into a folder of pictures, buffers and hashes."""
    from sss_ref.results.folder import checked_target, saving
    from sss_ref.results.saving import shows_all
    from sss_ref.scene.load import load_scene

    folder = checked_target(output)
    announce_compilation(execution)
    with progress("loading the scene") as show:
        loaded = load_scene(scene, **changes.overrides())
        _warn(loaded.warnings)
        with saving(folder, execution.interpreter, execution.threads) as files:
            result = _rendered(loaded, wanted, execution, lambda name: show(f"pass {name}"), files.take)
            _warn(result.notes)
            show("writing files")
            result = files.finish(result)
    out.print(_table_of_passes(result))
    out.print(f"{escape(str(folder))}: open {'image' if shows_all(result) else 'overview'}.png first")
    return 0


def warmup() -> int:
    """Compile the kernels of all stages, so that every later rendering starts at once."""
    from sss_ref.cache.compiled import cache_folder
    from sss_ref.rendering.warming import steps

    start = time.perf_counter()
    with progress("compiling kernels") as show:
        for step in steps():
            show(f"compiling kernels: {step}")
    place = cache_folder() or "nowhere: no folder can be written to, see SSS_REF_CACHE_DIR"
    out.print(f"kernels ready after {time.perf_counter() - start:.1f} s, kept in {escape(str(place))}")
    return 0


def _warn(warnings: Iterable[str]) -> None:
    """Say what may surprise, before the work goes on."""
    for warning in warnings:
        err.print(f"[yellow]warning: {escape(warning)}[/]")


def _rendered(
    scene: "Scene",
    wanted: Wanted,
    execution: Execution,
    on_pass: Callable[[str], None],
    on_buffer: "Callable[[str, np.ndarray], None]",
) -> "Result":
    """What is wanted of a scene; the image of several samples is their average."""
    from sss_ref.rendering.fold import folded, machine_of
    from sss_ref.rendering.samples import render_samples

    if wanted.samples != 1:
        return render_samples(scene, wanted.samples, execution.interpreter, execution.threads, on_pass)
    kept = scene.kept(scene.until(wanted.until) if wanted.until else wanted.keep or "all")
    with machine_of(execution.interpreter, execution.threads) as machine:
        return folded(scene, machine, kept, on_pass, on_buffer)


def _table_of_passes(result: "Result") -> Table:
    """One row a pass: its duration, its buffers and the first digits of their hashes."""
    table = Table("pass", "ms", "buffer", "sha256")
    table.columns[1].justify = "right"
    for each in result.scene.method.passes:
        kept = [name for name in each.values if name in result.hashes]
        digests = [result.hashes[name][:HASH_DIGITS] for name in kept]
        if each.name in result.timings:
            table.add_row(each.name, f"{result.timings[each.name] * 1e3:.0f}", "\n".join(kept), "\n".join(digests))
            table.add_section()
    return table
