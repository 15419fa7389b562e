"""Threads that share the many small tasks of a pass."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

T = TypeVar("T")


class Crew(ThreadPoolExecutor):
    """A pool whose `map` spreads tasks over `count` threads, of which the caller's is one.

    A task of a pass takes less than a millisecond, of which a future of its own would be a tenth. A thread that waits
    is slow to wake, so the caller works too, and waits for none that has nothing left to do.
    """

    def __init__(self, count: int) -> None:
        super().__init__(max(count - 1, 1))
        self.count = count

    def map(
        self, fn: Callable[..., T], *iterables: Iterable[Any], timeout: float | None = None, chunksize: int = 1
    ) -> Iterator[T]:
        """What a function gives of each task, in their order; all are done by then. timeout: seconds, of another.

        chunksize is that of processes. Of tasks that fail one's exception is raised, and those not begun are left out.
        """
        tasks = deque(enumerate(zip(*iterables, strict=False)))  # as the built-in map: the shortest ends it
        results: dict[int, T] = {}

        def work() -> None:
            try:
                while task := taken(tasks):
                    number, arguments = task
                    results[number] = fn(*arguments)
            finally:
                tasks.clear()

        others = [self.submit(work) for _ in range(min(self.count, len(tasks)) - 1)]
        work()
        for other in others:
            if not other.cancel():
                other.result(timeout)
        return (results[number] for number in range(len(results)))


def taken(tasks: "deque[T]") -> T | None:
    """The next of some tasks, which several threads take from; None behind the last."""
    try:
        return tasks.popleft()
    except IndexError:
        return None
