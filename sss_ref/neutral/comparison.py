"""Two drawings that must have the same bits, and where they have not."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from sss_ref.language.names import Name
from sss_ref.rendering.draw import Buffers
from sss_ref.results.diff import differing_pixels, first_difference

Window = tuple[slice, slice]  # rows, columns
EVERYWHERE: Window = (slice(None), slice(None))


@dataclass(frozen=True, eq=False)
class Pair:
    """A buffer as it was, and as it is after the change."""

    buffer: str
    before: np.ndarray
    after: np.ndarray

    @property
    def differs(self) -> bool:
        """Whether any bit does."""
        return self.before.shape != self.after.shape or bool(differing_pixels(self.before, self.after).any())

    def __str__(self) -> str:
        """The buffer and the first pixel that differs, in words."""
        return f"{self.buffer}, {first_difference(self.before, self.after, ('before', 'after'))}"


def pairs(
    before: Buffers, after: Buffers, lights: Mapping[int, int] | None = None, window: Window = EVERYWHERE
) -> Iterable[Pair]:
    """The buffers that both have, in the order of the first.

    lights: number of a light before -> after; of others the same. window: where in the picture after that before lies.
    """
    for name, buffer in before.items():
        parts = Name.of(name)
        moved = str(parts.of_light((lights or {}).get(parts.light, parts.light)))
        found = moved if moved in after else name
        if found in after:
            yield Pair(name, buffer, np.ascontiguousarray(after[found][window]))
