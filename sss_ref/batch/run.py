"""A batch from its sweep to its table."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from sss_ref.batch.batch_folder import claim
from sss_ref.batch.executors import ItemExecutor, serially
from sss_ref.batch.item_arrays import check_zarr
from sss_ref.batch.plan import WHOLE, Plan, Shard
from sss_ref.batch.sweep_file import Sweep
from sss_ref.batch.table import write_table
from sss_ref.batch.transforms import write_transforms
from sss_ref.batch.workshop import ItemOutcome, Job


@dataclass(frozen=True)
class Batch:
    """A batch that has been run."""

    folder: Path
    outcomes: tuple[ItemOutcome, ...]  # in the order of the items
    tables: tuple[Path, ...]
    cameras: Path | None = None

    def of_state(self, state: str) -> list[ItemOutcome]:
        """The items that were "rendered", "there" or "failed"."""
        return [each for each in self.outcomes if each.state == state]


@dataclass(frozen=True)
class BatchExecution:
    """How the items are rendered; the bits are the same."""

    executor: ItemExecutor = serially
    interpreter: str = "kernel"
    threads: int | None = None  # of a rendering; None: one per processor


IN_THIS_PROCESS = BatchExecution()


def run(
    sweep: Sweep,
    folder: Path,
    execution: BatchExecution = IN_THIS_PROCESS,
    shard: Shard = WHOLE,
    on_outcome: Callable[[ItemOutcome], None] = lambda outcome: None,
) -> Batch:
    """Render all items of a sweep, or of a shard of it, that are not in `folder` yet, and write its table.

    on_outcome: called with each item that is finished. Raises SceneError for a sweep that has no items, and DumpError
    for a folder that is not that of a batch with the same outputs; what is wrong with a single item is in its outcome.
    """
    plan = Plan(sweep)
    check_zarr(sweep)
    folder = claim(folder, sweep)
    job, found = Job(sweep, folder, execution.interpreter, execution.threads), []
    for outcome in execution.executor(job, shard.of(len(plan))):
        on_outcome(outcome)
        found.append(outcome)
    found.sort(key=lambda each: each.item)
    tables = write_table(folder, plan, found, shard)
    cameras = write_transforms(folder, found, shard) if sweep.cameras else None
    return Batch(folder, tuple(found), tuple(tables), cameras)
