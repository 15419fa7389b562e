"""What renders the items in a process: it keeps meshes and compiled kernels from one item to the next."""

import pickle
import time
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Literal

from sss_ref.batch.item_arrays import ItemArrays
from sss_ref.batch.item_folder import RECORD, ItemRecord, item_folder, item_name, read_record, record_of
from sss_ref.batch.outputs import write_outputs
from sss_ref.batch.plan import Plan
from sss_ref.batch.sweep_file import Sweep
from sss_ref.errors import SssRefError
from sss_ref.errors.wording import told
from sss_ref.mesh.triangles import Mesh
from sss_ref.rendering.fold import render
from sss_ref.results.whole_folder import appearing
from sss_ref.scene.load import read_mesh, scene_of
from sss_ref.scene_file.reading import Document, opened

MESHES = 8  # that are kept at once
UNFINISHED = ".items"  # in a batch's folder: what is being written, so that no writer need search among all items


@dataclass(frozen=True)
class Job:
    """What is done with every item of a sweep: all that a process needs to know, besides the item's number."""

    sweep: Sweep
    folder: Path  # of the batch
    interpreter: str = "kernel"
    threads: int | None = 1  # of a rendering

    def packed(self) -> bytes:
        """The job for another process."""
        return pickle.dumps(self)


@dataclass(frozen=True)
class ItemOutcome:
    """What became of an item."""

    item: int
    state: Literal["rendered", "there", "failed"]
    name: str = ""  # of its folder; "" where it is not known
    seconds: float = 0.0  # of rendering, by this run or an earlier one
    hashes: dict[str, str] = field(default_factory=dict)  # buffer -> SHA-256
    message: str = ""  # why it failed


def work(packed: bytes, item: int) -> ItemOutcome:
    """Render an item of a packed job, if it is not there; what goes wrong is told in the outcome."""
    try:
        return _workshop(packed).outcome(item)
    except SssRefError as error:
        return ItemOutcome(item, "failed", message=str(error))
    except Exception as error:  # the other items are not to blame; a trace shows when it is rendered by itself
        came, remedy = (
            f"{type(error).__name__}, a fault of this package",
            "render it alone by sss-ref render to see more",
        )
        return ItemOutcome(item, "failed", message=told(f"item {item}", "a picture", came, remedy))


class Workshop:
    """A process's own state, for one job."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.plan = Plan(job.sweep)
        self.mesh = lru_cache(MESHES)(read_mesh)
        self.hashes = lru_cache(MESHES)(Mesh.hashes)
        self.arrays = ItemArrays(job.folder, len(self.plan)) if "zarr" in job.sweep.outputs else None

    @cached_property
    def document(self) -> Document:
        """The scene file, read once."""
        return opened(self.job.sweep.scene)

    def outcome(self, item: int) -> ItemOutcome:
        """Render an item, or find it complete. Raises SssRefError."""
        job = self.job
        scene = scene_of(self.document, self.plan.overrides(item), self.mesh)
        inputs = scene.input_hashes(self.hashes)
        name = item_name(scene, inputs)
        folder = item_folder(job.folder, name)
        found = read_record(folder)
        if found and (self.arrays is None or self.arrays.holds(item, name)):
            return _outcome(item, "there", name, found)
        start = time.perf_counter()
        result = render(scene, job.interpreter, job.threads, job.sweep.keep)
        record = record_of(result, inputs, time.perf_counter() - start)
        with appearing(folder, job.folder / UNFINISHED) as part:
            write_outputs(result, job.sweep.outputs, part)
            if self.arrays:
                self.arrays.write(item, name, result.buffers)
            (part / RECORD).write_text(record.model_dump_json(indent=2) + "\n", encoding="utf-8")
        return _outcome(item, "rendered", name, record)


@lru_cache(maxsize=1)
def _workshop(packed: bytes) -> Workshop:
    return Workshop(pickle.loads(packed))


def _outcome(item: int, state: Literal["rendered", "there"], name: str, record: ItemRecord) -> ItemOutcome:
    return ItemOutcome(item, state, name, record.seconds, dict(record.buffers))
