"""One file for one buffer: which channels of it, in which order, rows up or down, and how much speaks for that."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import permutations
from typing import Any

import numpy as np

from sss_ref.capture.expected import Pixels, Reading, Sought
from sss_ref.capture.resemblance import Columns, Resemblance, resemblance
from sss_ref.capture.surfaces import Unnamed
from sss_ref.dump.mapping import Origin

ORIGINS: tuple[Origin, ...] = ("top", "bottom")
CLEARLY = 0.05  # how much better a way must be than the usual one, to be taken for it
TELLS = 0.03  # how much worse the other way must be, for the values to tell it
NONE = 1e-9
FITS = 0.85  # how close numbers must come that are stored in an unusual way


@dataclass(frozen=True)
class Habit:
    """How a renderer writes pictures, if that is known: the row it begins with, and whether channels are in order."""

    origins: tuple[Origin, ...] = ORIGINS
    in_order: bool = False


@dataclass(frozen=True)
class Candidate:
    """A surface, by its number, as a buffer.

    score: 0 to 1; close: of the numbers alone. channels: of the surface, by number, in the buffer's order.
    origin: the row that it begins with; turned, ordered: how much less speaks for the other one, and for the next best
    order of channels. keys: of the mapping file.
    """

    surface: int
    name: str
    score: float
    close: float
    channels: tuple[int, ...]
    origin: Origin
    turned: float
    ordered: float
    keys: Mapping[str, Any] = field(default_factory=dict, compare=False)

    @property
    def is_in_order(self) -> bool:
        """Whether its channels are in the order of the file."""
        return list(self.channels) == sorted(self.channels)

    @property
    def has_sure_order(self) -> bool:
        """Whether the values tell the order of the channels, or it makes no difference.

        An odd order must fit, but for BGR, which is common and need only be clear.
        """
        is_usual = self.is_in_order or self.close >= FITS or (self.is_reversed and self.ordered >= CLEARLY)
        return abs(self.ordered) < NONE or (self.ordered >= TELLS and is_usual)

    @property
    def is_reversed(self) -> bool:
        """Whether its channels are those of the file from the last to the first."""
        return list(self.channels) == sorted(self.channels, reverse=True)


UNKNOWN = Habit()


class Comparison:
    """Every surface beside every buffer, each compared once."""

    def __init__(self, surfaces: list[Unnamed], wanted: Mapping[str, Sought]) -> None:
        self.surfaces, self.wanted = surfaces, wanted
        self.held: dict[tuple[int, Pixels, str], tuple[Columns, np.ndarray]] = {}
        self.found: dict[tuple[int, Reading, str], Resemblance] = {}

    def candidate(
        self,
        surface: int,
        name: str,
        free: tuple[int, ...],
        predicted: Reading | None = None,
        habit: Habit = UNKNOWN,
    ) -> Candidate | None:
        """The surface as a buffer, in the way that fits best; None where it cannot be.

        free: the channels that are no other buffer's. predicted: what the buffer's stage makes of the dump.
        """
        buffer, picture = self.wanted[name], self.surfaces[surface]
        if picture.size != (buffer.slot.width, buffer.slot.height) or len(free) < buffer.slot.channels:
            return None
        usual, *others = buffer.readings if buffer.slot.dtype.kind != "i" else self._of_whole(buffer, picture)
        plain = [self._best((surface, name), each, free, habit) for each in (usual, predicted) if each]
        best = max(plain, key=lambda each: each.score)
        for each in (reading for reading in others if reading.fits(picture)):
            other = self._best((surface, name), each, free, habit)
            if other.close >= FITS and other.score > best.score + CLEARLY:
                best = other
        return best

    def _of_whole(self, buffer: Sought, picture: Unnamed) -> list[Reading]:
        return [next((each for each in buffer.readings if each.fits(picture)), buffer.readings[0])]

    def _best(self, pair: tuple[int, str], reading: Reading, free: tuple[int, ...], habit: Habit) -> Candidate:
        """The rows and channels that fit best; the usual ones unless others are clearly better."""
        surface, name = pair
        usual = self.surfaces[surface].usual_origin
        found = {origin: self._in_rows(pair, reading, free, (origin, habit.in_order)) for origin in ORIGINS}
        origin = max(habit.origins, key=lambda each: (round(found[each][0], 9), each == usual))
        score, close, ordered, channels = found[origin]
        turned = score - found["bottom" if origin == "top" else "top"][0]
        return Candidate(surface, name, score, close, channels, origin, turned, ordered, reading.keys)

    def _in_rows(
        self, pair: tuple[int, str], reading: Reading, free: tuple[int, ...], way: tuple[Origin, bool]
    ) -> tuple[float, float, float, tuple[int, ...]]:
        """Score, closeness, and how sure the order is, of the channels that fit best if the rows run so."""
        origin, in_order = way
        found = self._likeness(*pair, reading, origin)
        scores = {channels: _mean(found.total, channels) for channels in _selections(found.total, free)}
        orderly = [channels for channels in scores if list(channels) == sorted(channels)]
        best, usual = max(scores, key=scores.__getitem__), max(orderly, key=scores.__getitem__)
        chosen = best if scores[best] > scores[usual] + CLEARLY and not in_order else usual
        others = [scores[channels] for channels in scores if sorted(channels) == sorted(chosen) and channels != chosen]
        ordered = 1.0 if in_order else min((scores[chosen] - other for other in others), default=1.0)
        return scores[chosen], _mean(found.close, chosen), ordered, chosen

    def _likeness(self, surface: int, name: str, reading: Reading, origin: Origin) -> Resemblance:
        key = surface, reading, origin
        if key not in self.found:
            held, tolerance = self._held(surface, self.wanted[name], origin)
            self.found[key] = resemblance(held, reading.expected, tolerance, self.wanted[name].is_whole)
        return self.found[key]

    def _held(self, surface: int, buffer: Sought, origin: Origin) -> tuple[Columns, np.ndarray]:
        key = surface, buffer.pixels, origin
        if key not in self.held:
            picture, pixels = self.surfaces[surface], buffer.pixels
            upright = slice(None, None, -1 if origin == "top" else 1)
            self.held[key] = pixels.columns_of(picture.values[upright]), pixels.of(picture.tolerance[upright])
        return self.held[key]


def _selections(total: np.ndarray, free: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    """The channels that may be the buffer's: of many those that are among the two best for one of its own."""
    count = total.shape[1]
    if len(free) > 4:
        best = {free[k] for column in range(count) for k in np.argsort(-total[list(free), column])[: 2 + count]}
        free = tuple(sorted(best))
    return permutations(free, count)


def _mean(total: np.ndarray, channels: tuple[int, ...]) -> float:
    return float(sum(total[channel, k] for k, channel in enumerate(channels))) / len(channels)
