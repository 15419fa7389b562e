"""What validating spends its time on, told while it runs and kept for the report, and what it does not spend."""

import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TypeVar

T = TypeVar("T")


def _silent(text: str) -> None:
    """Tell nobody."""


@dataclass
class Clock:
    """The phases so far. tell: called with what is being done. seconds: phase -> wall time, in order."""

    tell: Callable[[str], None] = _silent
    seconds: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def phase(self, name: str) -> Iterator[None]:
        """Measure a phase; one that comes several times is added up."""
        self.tell(name)
        start = time.perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + time.perf_counter() - start


@dataclass
class Limit:
    """A span of wall time for tries, the likely ones first. skipped: kind of tries -> how many were not made."""

    seconds: float
    skipped: dict[str, int] = field(default_factory=dict)
    start: float = field(default_factory=lambda: time.perf_counter())

    def within(self, kind: str, tries: Iterable[T]) -> Iterator[T]:
        """The tries that end in time if none takes longer than those before it; the others are counted."""
        longest = 0.0
        for each in tries:
            begun = time.perf_counter()
            if begun - self.start + longest < self.seconds:
                yield each
                longest = max(longest, time.perf_counter() - begun)
            else:
                self.skipped[kind] = self.skipped.get(kind, 0) + 1

    @property
    def told(self) -> str:
        """What was not tried, as a sentence; empty if all was."""
        kinds = ", ".join(f"{count} {kind}" for kind, count in self.skipped.items())
        return f"not tried within {self.seconds:g} s: {kinds}" if kinds else ""
