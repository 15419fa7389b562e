"""Items rendered by the workers of a Dask cluster that others have started. The hashes are the same."""

import logging
import threading
import warnings
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from functools import partial
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from queue import Empty, Queue
from typing import Any

from sss_ref.batch.batch_folder import BATCH
from sss_ref.batch.executors import IN_FLIGHT, ItemExecutor, killed
from sss_ref.batch.workshop import ItemOutcome, Job, work
from sss_ref.errors import DumpError, RenderError, SceneError
from sss_ref.errors.wording import told
from sss_ref.results.manifest import package_version
from sss_ref.rules import RULES_VERSION

ANSWER = 10.0  # seconds that a scheduler may take to answer
PATIENCE = 60.0  # seconds that a cluster may be without workers


@contextmanager
def on_cluster(address: str) -> Iterator[ItemExecutor]:
    """An executor for the workers of the cluster whose scheduler has that address; disconnected at the end.

    A worker that ends loses its items in flight, which others begin again. Raises SceneError where nothing answers at
    the address, or there are no workers, or one has other versions than this process.
    """
    client = _connected(address)
    try:
        _check_workers(address, _versions_of(client))
        yield lambda job, items: _outcomes(client, job, items)
    except (OSError, CancelledError):  # by the scheduler's end
        came = "none any more"
        raise RenderError(told(address, "a Dask scheduler", came, "start it and say the same again")) from None
    finally:
        client.close(timeout=ANSWER)


def versions() -> str:
    """What must be the same in all processes of a cluster."""
    return f"sss_ref {package_version()}, rules {RULES_VERSION}, distributed {metadata.version('distributed')}"


def work_alike(expected: str, packed: bytes, item: int) -> ItemOutcome:
    """Render an item of a packed job in a worker, unless it is one that has joined later, with other versions."""
    if versions() != expected:
        message = told(f"item {item}", f"a worker with {expected}", versions(), "install the same on all")
        return ItemOutcome(item, "failed", message=message)
    return work(packed, item)


def _connected(address: str) -> Any:
    """A client of a scheduler; it is made in a thread, for a stranger that says nothing is waited for without end."""
    if not find_spec("distributed"):
        remedy = "run python -m pip install 'sss_ref[cluster]'"
        raise SceneError(told("--dask", "the package distributed", "none", remedy))
    made: Queue[Any] = Queue()
    threading.Thread(target=lambda: made.put(_client(address)), daemon=True).start()
    try:
        client = made.get(timeout=2 * ANSWER)
    except Empty:
        client = None
    if client is None:
        raise SceneError(
            told(f"--dask {address}", "a Dask scheduler", "no answer", "write its address as tcp://HOST:8786")
        )
    return client


def _client(address: str) -> Any:
    """A client, or None where the address has no answer or is none."""
    from distributed import Client

    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what matters is told by us
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return Client(address, timeout=ANSWER, set_as_default=False)
        except (OSError, ValueError, ImportError):
            return None


def _versions_of(client: Any) -> dict[str, Any]:
    """Address of each worker -> its versions, or the exception it raised; some may be about to begin."""
    from distributed import TimeoutError as NoneYet

    with suppress(NoneYet):
        client.wait_for_workers(1, timeout=ANSWER)
    found: dict[str, Any] = client.run(versions, on_error="return")
    return found


def _check_workers(address: str, found: dict[str, Any]) -> None:
    """Raise SceneError unless there are workers, all with our versions. found: address -> versions, or an exception."""
    if not found:
        raise SceneError(told(f"--dask {address}", "a cluster with workers", "none", "start some by dask worker"))
    for worker, its in found.items():
        if its != versions():
            came = its if isinstance(its, str) else "one without sss_ref"
            raise SceneError(told(f"--dask {address}: {worker}", versions(), came, "install the same on all"))


def _check_folder(client: Any, folder: Path) -> None:
    """Raise DumpError unless all workers find a batch's folder where this process has it."""
    for worker, sees in client.run(_sees, folder).items():
        if not sees:
            raise DumpError(told(str(folder), f"a folder that worker {worker} sees too", "none", "choose a shared one"))


def _sees(folder: Path) -> bool:
    return (folder / BATCH).is_file()


def _outcomes(client: Any, job: Job, items: Sequence[int]) -> Iterator[ItemOutcome]:
    """The outcomes of items; one that was lost with several workers is tried once more while no other is in flight."""
    _check_folder(client, job.folder)
    packed, left, lost, in_flight = job.packed(), deque(items), deque[int](), dict[Any, int]()
    while left or lost or in_flight:
        alone = not left and not in_flight
        room = IN_FLIGHT * max(1, sum(client.nthreads().values())) - len(in_flight)
        for item in [lost.popleft()] if alone else [left.popleft() for _ in range(min(room, len(left)))]:
            in_flight[client.submit(work_alike, versions(), packed, item, pure=False)] = item
        for future in _finished(client, in_flight):
            item = in_flight.pop(future)
            outcome = _outcome_of(client, future, item)
            if outcome:
                yield outcome
            elif alone:
                yield killed(item)
            else:
                lost.append(item)


def _outcome_of(client: Any, future: Any, item: int) -> ItemOutcome | None:
    """The outcome of a future that is done; None where its workers were killed."""
    from distributed import KilledWorker

    failure = _awaited(client, future.exception)
    if failure and not isinstance(failure, KilledWorker):
        came, remedy = f"{type(failure).__name__} in a worker", "install the same packages on all"
        return ItemOutcome(item, "failed", message=told(f"item {item}", "a picture", came, remedy))
    with suppress(KilledWorker):  # also of one that has to begin again, for the worker with its outcome has ended
        outcome: ItemOutcome = _awaited(client, future.result)
        return outcome
    return None


def _finished(client: Any, in_flight: dict[Any, int]) -> list[Any]:
    """Some futures that are done."""
    from distributed import wait

    with client.as_current():
        return list(_awaited(client, partial(wait, list(in_flight), return_when="FIRST_COMPLETED")).done)


def _awaited(client: Any, answer: Callable[..., Any]) -> Any:
    """What a call that takes a timeout gives at last. Raises RenderError where there has been no worker for a while."""
    from distributed import TimeoutError as StillWorking

    while True:
        try:
            return answer(timeout=PATIENCE)
        except StillWorking:
            if not client.nthreads():
                expected = "a cluster with workers"
                remedy = "start some and say the same again"
                raise RenderError(told(client.scheduler.address, expected, "none any more", remedy)) from None
