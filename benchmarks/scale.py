"""What a million pictures cost on a thousand cores, measured here and simulated there.

    python benchmarks/scale.py --items 1000000 --cores 1000

Measured on one core: processor time, files and bytes of an item, of starting a process, of handing out an item by
processes and by Dask, and of a row of the table. Assumed of the cluster, all of whose cores are like this one: how many
changes of names (files, folders, renames) and bytes its shared file system takes a second. The simulation goes from
event to event: a core asks for an item, waits for whoever hands them out, renders, waits for the file system, and asks
again.
"""

import argparse
import heapq
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from sss_ref.batch.batch_folder import claim
from sss_ref.batch.cluster import on_cluster
from sss_ref.batch.executors import ItemExecutor, in_processes
from sss_ref.batch.plan import Plan
from sss_ref.batch.sweep_file import Sweep, checked_sweep
from sss_ref.batch.table import write_table
from sss_ref.batch.workshop import Job, Workshop

WARM = 10  # items before measuring
COUNTED = 5  # items of which names and bytes are counted
ROUNDS = 8  # how often an item that is there is handed out, to measure that alone
STARTED = "from sss_ref.batch.workshop import *; import sys, pickle; Workshop(pickle.load(sys.stdin.buffer)).outcome(0)"


@dataclass(frozen=True)
class Costs:
    """Of an item, seconds of a processor and what it leaves."""

    items: list[float]  # of each that was measured, all in all
    there: float  # of finding an item that is there
    changes: float  # of names in the file system
    written: float  # bytes


@dataclass(frozen=True)
class Cluster:
    """What renders.

    handing: seconds for handing out an item, one after the other; 0 where each core knows its own. starting: seconds
    until a core's first item. changes, bandwidth: of the file system, a second.
    """

    cores: int
    handing: float
    starting: float
    changes: float
    bandwidth: float


@dataclass(frozen=True)
class Spent:
    """Seconds until all is done, and of that the shares that the cores render, handing out and file system are busy."""

    until: float
    cores: float
    handing: float
    files: float


def simulated(items: int, costs: Costs, cluster: Cluster) -> Spent:
    """Run so many items on a cluster."""
    storing = costs.changes / cluster.changes + costs.written / cluster.bandwidth
    handed = stored = rendered = 0.0  # when handing out and the file system are free again; seconds of rendering
    events = [(cluster.starting, core, False) for core in range(cluster.cores)]
    begun = 0
    while events:
        now, core, has_rendered = heapq.heappop(events)
        if has_rendered:
            stored = max(now, stored) + storing
            heapq.heappush(events, (stored, core, False))
        elif begun < items:
            handed = max(now, handed) + cluster.handing
            took = costs.items[begun % len(costs.items)]
            rendered, begun = rendered + took, begun + 1
            heapq.heappush(events, ((handed if cluster.handing else now) + took, core, True))
    return Spent(stored, rendered / cluster.cores / stored, items * cluster.handing / stored, items * storing / stored)


def sweep_of(outputs: list[str], items: int) -> Sweep:
    """Pictures of the shipped head, 256^2, from around."""
    size = {"camera": {"width": 256, "height": 256}}
    turn = {"camera.azimuth": {"first": 0, "last": 90, "count": items + COUNTED}}
    return checked_sweep({"scene": "default", "set": size, "vary": turn, "outputs": outputs}, "sweep")


def measured(job: Job, items: int) -> Costs:
    """Costs of the items of a job, in this process, and of the names and bytes that its last items leave."""
    workshop, took = Workshop(job), list[float]()
    for item in range(WARM):
        workshop.outcome(item)
    for item in range(WARM, items):
        start = time.process_time()
        workshop.outcome(item)
        took.append(time.process_time() - start)
    start = time.process_time()
    for item in range(WARM, items):
        workshop.outcome(item)
    there = (time.process_time() - start) / len(took)
    before = size_of(job.folder)
    changes = changes_of_names(lambda: [workshop.outcome(item) for item in range(items, items + COUNTED)])
    return Costs(took, there, changes / COUNTED, (size_of(job.folder) - before) / COUNTED)


def changes_of_names(work: Callable[[], object]) -> int:
    """How many files and folders are made, renamed and removed."""
    found, counting = 0, True

    def count(event: str, arguments: tuple[object, ...]) -> None:
        nonlocal found
        if counting:
            created = event == "open" and isinstance(arguments[2], int) and arguments[2] & os.O_CREAT
            found += bool(created or event in ("os.mkdir", "os.rename", "os.remove", "os.rmdir"))

    sys.addaudithook(count)  # for good, and it takes time of its own
    work()
    counting = False
    return found


def size_of(folder: Path) -> int:
    """Bytes of all files below a folder."""
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def handing(executor: ItemExecutor, job: Job, items: int) -> float:
    """Processor seconds of this process for handing out an item that is there already."""
    numbers = list(range(items)) * ROUNDS
    outcomes = executor(job, numbers)
    next(iter(outcomes))
    start = time.process_time()
    rest = sum(1 for _ in outcomes)
    return (time.process_time() - start) / rest


def dask_handing(job: Job, items: int) -> float:
    """The same by Dask: of its client and its scheduler, which is in this process too."""
    from distributed import LocalCluster

    with (
        LocalCluster(2, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster,
        on_cluster(cluster.scheduler_address) as executor,
    ):
        return handing(executor, job, items)


def starting(job: Job) -> float:
    """Processor seconds until a new process is ready to render: kernels are compiled already, the item is there."""
    before = sum(os.times()[2:4])
    subprocess.run([sys.executable, "-c", STARTED], input=job.packed(), check=True)
    return sum(os.times()[2:4]) - before


def row_of_table(job: Job, items: int) -> float:
    """Processor seconds of a row of the table."""
    workshop = Workshop(job)
    outcomes = [workshop.outcome(item) for item in range(items)] * ROUNDS
    start = time.process_time()
    write_table(job.folder, Plan(job.sweep), outcomes)
    return (time.process_time() - start) / len(outcomes)


def lines(items: int, costs: Costs, ways: dict[str, Cluster]) -> Iterator[str]:
    """A line for each way to share the items among the cores."""
    yield "  way                                    hours   rendering   handing out   file system   core hours"
    for name, cluster in ways.items():
        spent = simulated(items, costs, cluster)
        hours = spent.until / 3600
        shares = f"{spent.cores:8.0%}     {spent.handing:8.0%}      {spent.files:8.0%}"
        yield f"  {name:37s} {hours:6.2f}    {shares}      {hours * cluster.cores:8.0f}"


def told(name: str, costs: Costs) -> str:
    """What an item costs, in one line."""
    item = sum(costs.items) / len(costs.items)
    return (
        f"  {name}: {item * 1e3:.1f} ms, {costs.changes:.1f} changes of names, {costs.written / 1e3:.0f} kB; "
        f"{costs.there * 1e3:.2f} ms to find it there"
    )


def main() -> None:
    """Measure, simulate, print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--items", type=int, default=10**6)
    parser.add_argument("--cores", type=int, default=1000)
    parser.add_argument("--measured", type=int, default=60, help="items that are rendered here")
    parser.add_argument("--changes", type=float, default=20_000, help="of names, a second, of the shared file system")
    parser.add_argument("--bandwidth", type=float, default=5e9, help="bytes a second of it")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        jobs = {
            name: Job(sweep, claim(Path(folder, name), sweep))
            for name, sweep in ((each, sweep_of([each], asked.measured)) for each in ("png", "zarr"))
        }
        starting(jobs["png"])  # compiles what is not compiled yet
        costs = {name: measured(job, asked.measured) for name, job in jobs.items()}
        job = jobs["png"]
        processes, dask = handing(in_processes(2), job, asked.measured), dask_handing(job, asked.measured)
        start, row = starting(job), row_of_table(job, asked.measured)
    print("measured, processor time on one core; 256^2, 18k triangles, shadow map 2048^2, the image kept")
    for name, cost in costs.items():
        print(told(name, cost))
    print(f"  a process: {start:.1f} s to start; a row of the table: {row * 1e6:.0f} us")
    print(f"  handing out an item: {processes * 1e3:.2f} ms by processes, {dask * 1e3:.2f} ms by Dask")
    print(f"\nsimulated: {asked.items} items, {asked.cores} cores; the file system takes {asked.changes:g} changes of")
    print(f"names and {asked.bandwidth:g} bytes a second. Shares: how much of the time each of them is busy")
    shards = Cluster(asked.cores, 0.0, start, asked.changes, asked.bandwidth)
    fast = replace(shards, changes=10 * asked.changes, bandwidth=10 * asked.bandwidth)
    ways = {
        "--shard, one a core": shards,
        "--shard, file system 10 times as fast": fast,
        "--dask, one scheduler": replace(shards, handing=dask),
    }
    for name, cost in costs.items():
        print(f"\n{name}: {asked.items * cost.written / 1e9:.0f} GB")
        for line in lines(asked.items, cost, ways):
            print(line)
    minutes = costs["png"].there * asked.items / 60
    print(f"\nthe table of all, afterwards: {minutes:.0f} core minutes to find the items, ", end="")
    print(f"{row * asked.items:.0f} s to write it")


if __name__ == "__main__":
    main()
