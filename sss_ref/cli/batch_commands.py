"""`sss-ref batch` and `turntable`."""

import os
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import announce_compilation, err, out
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes, Execution
from sss_ref.errors import SceneError

if TYPE_CHECKING:
    from sss_ref.batch.executors import ItemExecutor
    from sss_ref.batch.plan import Shard
    from sss_ref.batch.run import Batch
    from sss_ref.batch.sweep_file import Sweep
    from sss_ref.batch.workshop import ItemOutcome

SOME_FAILED = 1  # exit code
FASTEST = 100  # pictures per second: a GIF counts hundredths
SHOWN_ITEMS = 5  # numbers of items that are told of one failure
TENTHS = 10  # how often progress is told where there is no terminal


def batch(
    sweep: Annotated[Path, Parameter(help="A sweep file.")],
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The batch's folder; an earlier batch there goes on.")] = Path(
        "batch"
    ),
    jobs: Annotated[
        int | None, Parameter(show_default=False, help="How many items are rendered at once; one per processor.")
    ] = None,
    shard: Annotated[
        str | None, Parameter(show_default=False, help="Render this part of the items alone, such as 3/10.")
    ] = None,
    olat: Annotated[
        int | None, Parameter(show_default=False, help="Light it by one light at a time, from so many directions.")
    ] = None,
    dask: Annotated[
        str | None, Parameter(show_default=False, help="Render by the workers of the Dask cluster at this address.")
    ] = None,
    video: Annotated[
        int | None, Parameter(show_default=False, help="Make films of the pictures in order, so many a second.")
    ] = None,
    execution: Execution = KERNELS,
) -> int:
    """Render a scene with many values of its keys, item by item; what is there already is not rendered again.

    Exit code 1 if an item failed; the others are rendered all the same.
    """
    from sss_ref.batch.plan import WHOLE, Shard
    from sss_ref.batch.sweep_file import read_sweep

    wanted = read_sweep(sweep, olat)
    if video is not None:
        _check_film(video, wanted.outputs)
    if dask is not None and jobs is not None:
        raise SceneError("--dask: expected without --jobs, got both; the cluster knows how many workers it has")
    part = Shard.parsed(shard) if shard else WHOLE
    done = (
        _run_on_cluster(wanted, output, part, dask, execution) if dask else _run(wanted, output, part, jobs, execution)
    )
    code = _told(done)
    if video is not None:
        _film(wanted, done, "batch", video)
    return code


def turntable(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The folder; an earlier turn there goes on.")] = Path(
        "turntable"
    ),
    frames: Annotated[int, Parameter(help="Pictures in a turn.")] = 72,
    rate: Annotated[int, Parameter(name="--fps", help="Pictures per second of the films.")] = 24,
    jobs: Annotated[
        int | None, Parameter(show_default=False, help="How many pictures are rendered at once; one per processor.")
    ] = None,
    changes: Changes = NO_CHANGES,
    execution: Execution = KERNELS,
) -> int:
    """Go around a scene once: pictures, a contact sheet, a GIF and, with the extra `video`, an MP4."""
    from sss_ref.batch.plan import WHOLE
    from sss_ref.batch.turntable import turntable as turn

    wanted = turn(scene, frames, changes.overrides())
    _check_film(rate, wanted.outputs)
    done = _run(wanted, output, WHOLE, jobs, execution)
    code = _told(done)
    _film(wanted, done, "turntable", rate)
    return code


def _run(wanted: "Sweep", output: Path, part: "Shard", jobs: int | None, execution: Execution) -> "Batch":
    """Render the items of a sweep's part, and tell how far it is."""
    from sss_ref.batch.plan import Plan
    from sss_ref.batch.run import BatchExecution, run

    items = len(part.of(len(Plan(wanted))))
    announce_compilation(execution)
    executor, threads = _executor(jobs, items, execution.threads)
    with _progress(items) as tell:
        return run(wanted, output, BatchExecution(executor, execution.interpreter, threads), part, tell)


def _run_on_cluster(wanted: "Sweep", output: Path, part: "Shard", address: str, execution: Execution) -> "Batch":
    """The same by the workers of a cluster, of one thread each unless told otherwise."""
    from sss_ref.batch.cluster import on_cluster
    from sss_ref.batch.plan import Plan
    from sss_ref.batch.run import BatchExecution, run

    with on_cluster(address) as executor, _progress(len(part.of(len(Plan(wanted))))) as tell:
        threads = execution.threads or 1
        return run(wanted, output, BatchExecution(executor, execution.interpreter, threads), part, tell)


def _check_film(rate: int, outputs: tuple[str, ...]) -> None:
    if not 1 <= rate <= FASTEST:
        raise SceneError(f"pictures per second: expected 1 to {FASTEST}, got {rate}; 24 looks smooth")
    if "png" not in outputs:
        raise SceneError(f'--video: expected the output "png", got {", ".join(outputs)}; add it to the sweep file')


def _film(wanted: "Sweep", done: "Batch", stem: str, rate: int) -> None:
    """Make films and a contact sheet of the items that did not fail."""
    from sss_ref.batch.contact_sheet import write_contact_sheet
    from sss_ref.batch.film import has_encoder, write_films
    from sss_ref.batch.item_folder import item_folder
    from sss_ref.batch.plan import Plan

    plan = Plan(wanted)
    shown = [each for each in done.outcomes if each.state != "failed"]
    pictures = [item_folder(done.folder, each.name) / "image.png" for each in shown]
    files = write_films(done.folder, stem, pictures, rate)
    sheet = done.folder / "contact_sheet.png"
    write_contact_sheet(sheet, pictures, [", ".join(map(_short, plan[each.item].values())) for each in shown])
    out.print(escape(", ".join(map(str, (*files, sheet)))))
    if not has_encoder():
        err.print("no MP4, which needs the extra: python -m pip install 'sss_ref[video]'", markup=False)


def _short(value: object) -> str:
    """A value as a caption has it; of a table its numbers."""
    if isinstance(value, dict):
        value = [each for each in value.values() if isinstance(each, int | float)]
    if isinstance(value, list):
        return _short(value[0]) if len(value) == 1 else f"[{', '.join(map(_short, value))}]"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _executor(jobs: int | None, items: int, threads: int | None) -> "tuple[ItemExecutor, int | None]":
    """The executor for so many jobs, and the threads of each: of several jobs one, unless told otherwise."""
    from sss_ref.batch.executors import in_processes, serially

    if jobs is not None and jobs < 1:
        raise SceneError(f"--jobs: expected at least 1, got {jobs}; leave it out for one per processor")
    count = min(jobs or os.cpu_count() or 1, items)
    return (in_processes(count), threads or 1) if count > 1 else (serially, threads)


@contextmanager
def _progress(items: int) -> "Iterator[Callable[[ItemOutcome], None]]":
    """Tell how far it is and how long it will take: on a terminal by a bar, elsewhere by a line at every tenth."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (
        TextColumn("items"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        TextColumn("{task.fields[failed]}"),
    )
    with Progress(*columns, console=err, disable=not err.is_terminal) as shown:
        task, failed = shown.add_task("items", total=items, failed=""), 0

        def tell(outcome: "ItemOutcome") -> None:
            nonlocal failed
            failed += outcome.state == "failed"
            shown.update(task, advance=1, failed=f"{failed} failed" if failed else "")
            done, left = int(shown.tasks[0].completed), shown.tasks[0].time_remaining
            if shown.disable and done * TENTHS // items > (done - 1) * TENTHS // items:
                err.print(f"{done} of {items} items, {failed} failed" + (f", about {left:.0f} s left" if left else ""))

        yield tell


def _told(done: "Batch") -> int:
    """Print what failed, each message once, and what there is; the exit code."""
    failed = done.of_state("failed")
    said = {each.item: each.message.removeprefix(f"item {each.item}: ") for each in failed}
    for message, count in Counter(said.values()).items():
        items = [str(item) for item, own in said.items() if own == message]
        more = f" and {count - SHOWN_ITEMS} more" if count > SHOWN_ITEMS else ""
        err.print(f"[red]failed: item {', '.join(items[:SHOWN_ITEMS])}{more}:[/] {escape(message)}")
    states = ", ".join(f"{len(done.of_state(state))} {said}" for state, said in STATES.items())
    files = ", ".join(str(path) for path in (done.tables[0], done.cameras) if path)
    out.print(f"{states}: {escape(files)}")
    return SOME_FAILED if failed else 0


STATES = {"rendered": "rendered", "there": "were there", "failed": "failed"}
