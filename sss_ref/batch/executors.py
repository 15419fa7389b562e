"""Who renders the items: this process, or several that it starts. The hashes are the same."""

import multiprocessing
import os
import signal
import sys
import threading
from collections import Counter, deque
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.connection import wait as wait_for_end

from sss_ref.batch.workshop import ItemOutcome, Job, work
from sss_ref.errors.wording import told

ATTEMPTS = 3  # at an item whose process ends while it is in flight
IN_FLIGHT = 2  # items per process: one being rendered, one waiting

ItemExecutor = Callable[[Job, Sequence[int]], Iterator[ItemOutcome]]
"""Gives the outcome of each of some items, in whatever order they are finished."""


def serially(job: Job, items: Sequence[int]) -> Iterator[ItemOutcome]:
    """One item after the other, in this process."""
    packed = job.packed()
    return (work(packed, item) for item in items)


def in_processes(count: int) -> ItemExecutor:
    """Several items at once, each in one of `count` processes.

    Where one of them is killed, new ones take their place, and the items in flight are begun again: an item that was
    lost twice is rendered while no other is, so that only one that itself ends its process is told as failed.
    """

    def outcomes(job: Job, items: Sequence[int]) -> Iterator[ItemOutcome]:
        packed, left, losses = job.packed(), deque(items), Counter[int]()
        while left:
            lost = yield from _until_broken(count, packed, left)
            losses.update(lost)
            left.extendleft(item for item in lost if losses[item] < ATTEMPTS - 1)
            for item in lost:
                if losses[item] >= ATTEMPTS - 1:
                    yield from _alone(packed, item)

    return outcomes


def killed(item: int) -> ItemOutcome:
    """The outcome of an item whose process ended each time."""
    remedy = "render it alone, or give it more memory"
    message = told(f"item {item}", "a picture", f"a process that was killed {ATTEMPTS} times", remedy)
    return ItemOutcome(item, "failed", message=message)


def _alone(packed: bytes, item: int) -> Iterator[ItemOutcome]:
    if (yield from _until_broken(1, packed, deque([item]))):
        yield killed(item)


def _until_broken(count: int, packed: bytes, left: deque[int]) -> Generator[ItemOutcome, None, list[int]]:
    """The outcomes of the items in `left`, which are taken from it; returns those lost with a process that ended."""
    in_flight: dict[Future[ItemOutcome], int] = {}
    context = multiprocessing.get_context("spawn")  # a fork of a process with threads may wait for ever
    pool = ProcessPoolExecutor(count, context, _begin)
    try:
        while left or in_flight:
            while left and len(in_flight) < IN_FLIGHT * count:
                with _interrupted_alone():
                    in_flight[pool.submit(work, packed, left[0])] = left[0]
                left.popleft()
            for future in wait(in_flight, return_when=FIRST_COMPLETED).done:
                outcome = future.result()
                del in_flight[future]
                yield outcome
    except BrokenProcessPool:
        finished = [future for future in in_flight if future.done() and not future.exception()]
        yield from (future.result() for future in finished)
        return [item for future, item in in_flight.items() if future not in finished]
    finally:
        pool.shutdown(cancel_futures=True)
    return []


@contextmanager
def _interrupted_alone() -> Iterator[None]:
    """Keep Ctrl-C from processes that are started meanwhile, which would print what they import.

    What is blocked here stays blocked in them, from before they can ignore it. This one gets it all the same.
    """
    if sys.platform == "win32":
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin() -> None:
    """Set up a process that renders: it ends with the one that has started it, however that ends."""
    from sss_ref.cache.left_out import leave_out

    leave_out()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that was asked stops this one
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent:
        wait_for_end([parent.sentinel])
        os._exit(1)
