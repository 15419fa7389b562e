"""Which items a sweep has: the overrides of the scene that each of them is, found by its number alone."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sss_ref.batch.draws import Random, Spaced, chances
from sss_ref.batch.sweep_file import Sweep
from sss_ref.errors import SceneError
from sss_ref.errors.wording import told


@dataclass(frozen=True)
class Shard:
    """A part of the items, for many machines: every count-th, from `number` on (1 to count)."""

    number: int
    count: int

    @classmethod
    def parsed(cls, text: str) -> "Shard":
        """The shard of a text such as 3/10. Raises SceneError."""
        parts = re.fullmatch(r"(\d{1,9})/(\d{1,9})", text)
        number, count = (int(part) for part in parts.groups()) if parts else (0, 0)
        if not 1 <= number <= count:
            raise SceneError(
                f"--shard: expected NUMBER/COUNT, NUMBER from 1 to COUNT, got {text[:60]!r}; write it as 3/10"
            )
        return cls(number, count)

    @property
    def suffix(self) -> str:
        """What the names of files of this part alone end in."""
        return "" if self.count == 1 else f"-{self.number}-of-{self.count}"

    def of(self, items: int) -> range:
        """The numbers of its items, of so many in all."""
        return range(self.number - 1, items, self.count)


WHOLE = Shard(1, 1)


@dataclass(frozen=True)
class Plan:
    """A sweep as a sequence of items, numbered from 0."""

    sweep: Sweep

    def __post_init__(self) -> None:
        lengths = {key: len(values) for key, values in self.listed.items()}
        if self.sweep.combine == "zip" and len(set(lengths.values())) > 1:
            first, *others = lengths
            other = next(key for key in others if lengths[key] != lengths[first])
            expected = f"{lengths[first]} values, as vary.{first} has"
            raise SceneError(told(f"vary.{other}", expected, str(lengths[other]), "zip takes one of each"))
        if self.sweep.repeat > 1 and not self.random:
            raise SceneError("repeat: expected a key drawn at random, got none; all rounds would be the same")

    @cached_property
    def listed(self) -> Mapping[str, Sequence[Any]]:
        """Key -> its values in turn, of those that are not drawn."""
        given = {key: each.values if isinstance(each, Spaced) else each for key, each in self.sweep.vary.items()}
        return {key: values for key, values in given.items() if isinstance(values, list | tuple)}

    @cached_property
    def random(self) -> Mapping[str, Random]:
        """Key -> what is drawn for it."""
        return {key: values for key, values in self.sweep.vary.items() if not isinstance(values, list | Spaced)}

    @cached_property
    def round(self) -> int:
        """How many items the values in turn give."""
        lengths = [len(values) for values in self.listed.values()]
        return math.prod(lengths) if self.sweep.combine == "grid" else next(iter(lengths), 1)

    def __len__(self) -> int:
        return self.round * self.sweep.repeat

    def __getitem__(self, item: int) -> dict[str, Any]:
        """Dotted key -> value of an item, in the order of the file; without what is set for all."""
        drawn = {key: each.drawn(chances(self.sweep.seed, key, item)) for key, each in self.random.items()}
        chosen = self._chosen(item % self.round) | drawn
        return {key: chosen[key] for key in self.sweep.vary}

    def overrides(self, item: int) -> dict[str, Any]:
        """What is laid on the scene for an item."""
        return {**self.sweep.set, **self[item]}

    def _chosen(self, place: int) -> dict[str, Any]:
        """The values at a place of the grid or the zip; of a grid the last key is the fastest."""
        if self.sweep.combine == "zip":
            return {key: values[place] for key, values in self.listed.items()}
        found: dict[str, Any] = {}
        for key, values in reversed(list(self.listed.items())):
            place, digit = divmod(place, len(values))
            found[key] = values[digit]
        return found
