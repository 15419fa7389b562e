"""How sure a place is: what it gains in all over another surface for its buffer, or another buffer for its surface."""

from collections.abc import Iterable, Iterator, Sequence

from sss_ref.capture.candidate import CLEARLY, Candidate
from sss_ref.capture.surfaces import Unnamed

WORTH = 0.15  # how much must speak for a place to be a way at all
USED = 0.6  # ... for a use of what is as good, that leaves this place


class Rivalry:
    """All that may be placed: every surface for every buffer that it might be."""

    def __init__(self, surfaces: Sequence[Unnamed], candidates: Iterable[Candidate]) -> None:
        self.surfaces, self.candidates = surfaces, surest_first(each for each in candidates if each.score >= WORTH)
        self.of_name: dict[str, list[Candidate]] = {}
        self.of_surface: dict[int, list[Candidate]] = {}
        for each in self.candidates:
            self.of_name.setdefault(each.name, []).append(each)
            self.of_surface.setdefault(each.surface, []).append(each)

    def margin(self, each: Candidate) -> float:
        """How much less speaks for the best of the other ways; all that does for this one, if there is no other."""
        return min((self._gain(each, other) for other in self.against(each)), default=each.score)

    def rivals(self, each: Candidate) -> list[Candidate]:
        """What might as well be placed in its stead."""
        return [other for other in self.against(each) if self._gain(each, other) < CLEARLY]

    def against(self, each: Candidate) -> Iterator[Candidate]:
        """Other surfaces for its buffer, and other buffers for its surface."""
        yield from (other for other in self.of_name[each.name] if other.surface != each.surface)
        yield from (
            other for other in self.of_surface[each.surface] if other.name != each.name and overlap(other, each)
        )

    def _gain(self, each: Candidate, other: Candidate) -> float:
        """What speaks for this one and the best that is left for what the other lacks, less the other way round."""
        if self._are_alike(each, other):
            return each.score
        if each.name == other.name:
            left, then = self._elsewhere(other, each), self._elsewhere(each, other)
        else:
            left, then = self._by_others(other, each), self._by_others(each, other)
        if left < USED and _is_as_good(other, each):  # nothing else is sure to take its place
            return 0.0
        return each.score + left - other.score - then

    def _elsewhere(self, who: Candidate, than: Candidate) -> float:
        """The best other place of a surface, to which no third one has a better claim."""
        own = (one for one in self.of_surface[who.surface] if one.name != than.name and overlap(one, who))
        return next((one.score for one in own if not self._is_claimed(one, than.surface)), 0.0)

    def _is_claimed(self, place: Candidate, than: int) -> bool:
        others = (one for one in self.of_name[place.name] if one.surface not in (place.surface, than))
        best = next(others, place)
        return best.score >= place.score + CLEARLY

    def _by_others(self, whose: Candidate, than: Candidate) -> float:
        """The best other surface for a buffer, which has no better place."""
        others = (one for one in self.of_name[whose.name] if one.surface != whose.surface)
        return next((one.score for one in others if not self._has_better(one, than.name)), 0.0)

    def _has_better(self, one: Candidate, than: str) -> bool:
        places = (each for each in self.of_surface[one.surface] if each.name not in (one.name, than))
        return any(place.score >= one.score + CLEARLY for place in places if overlap(place, one))

    def _are_alike(self, each: Candidate, other: Candidate) -> bool:
        """Whether surfaces that hold the same have a place each among buffers that both fit, whichever they take."""
        content = self.surfaces[each.surface].content
        alike = {number for number in self.of_surface if self.surfaces[number].content == content}
        if other.surface not in alike:
            return False
        names = {o.name for number in alike for o in self.of_surface[number] if o.score > each.score - CLEARLY}
        return len(names) <= len(alike) and other.name in names


def _is_as_good(other: Candidate, than: Candidate) -> bool:
    """Whether a place is nearly as good as another one, or the better one by its numbers alone."""
    return other.score > than.score - CLEARLY or other.close > than.close + CLEARLY


def overlap(a: Candidate, b: Candidate) -> bool:
    """Whether they share a channel of a surface."""
    return a.surface == b.surface and bool(set(a.channels) & set(b.channels))


def surest_first(candidates: Iterable[Candidate]) -> list[Candidate]:
    """By how much speaks for them."""
    return sorted(candidates, key=lambda each: -each.score)
