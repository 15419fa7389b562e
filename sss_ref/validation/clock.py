"""What validating spends its time on, told while it runs and kept for the report."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field


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
