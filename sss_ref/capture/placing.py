"""Which surface is which buffer: the surest first, then the stages are run on those, and the others compared again.

Nothing is placed that might as well be another buffer, or another file: such are asked for.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product

import numpy as np

from sss_ref.capture.candidate import CLEARLY, ORIGINS, TELLS, Candidate, Comparison, Habit
from sss_ref.capture.expected import Reading, sought
from sss_ref.capture.following import Rerun
from sss_ref.capture.rivalry import Rivalry
from sss_ref.capture.surfaces import Unnamed
from sss_ref.dump.convert import converted
from sss_ref.dump.mapping import BufferTable, Origin
from sss_ref.dump.slots import slots_of
from sss_ref.dump.sources import Source
from sss_ref.errors import DumpError
from sss_ref.rendering.result import Result

UNSURE = 0.15  # how much wider a margin must be where nothing but the structure speaks for a place
AGREEING = 3  # pictures of several channels that tell how the others are ordered
STEPS = (0.85, 0.6, 0.45, 0.35)  # how much must speak for a place, first of the surest, then of the others
ASKED = 0.3  # how much must speak for a place to be asked for


def needed(each: Candidate) -> float:
    """The margin that a place needs: of what fits badly a wider one."""
    return CLEARLY + UNSURE * (1 - each.score)


@dataclass(frozen=True)
class Placement:
    """A surface that is placed. margin: how much less speaks for the next best way."""

    surface: Unnamed
    candidate: Candidate
    margin: float

    @property
    def channel_names(self) -> list[str]:
        """The channels that are the buffer's, in its order."""
        return [self.surface.channels[channel] for channel in self.candidate.channels]

    @property
    def table(self) -> BufferTable:
        """What a mapping file says of it."""
        own = self.surface.keys(self.candidate.channels, self.candidate.origin)
        return BufferTable.model_validate({**own, **self.candidate.keys})


@dataclass(frozen=True)
class Question:
    """A surface that may be several buffers, or several surfaces that may be one."""

    surfaces: tuple[Unnamed, ...]
    names: tuple[str, ...]


@dataclass(frozen=True)
class Arrangement:
    """What was found: buffer -> its place, in stage order; what is asked for; surfaces that nothing is like."""

    placements: Mapping[str, Placement]
    questions: tuple[Question, ...]
    unknown: tuple[Unnamed, ...]

    @property
    def usual_origin(self) -> Origin:
        """The row that most files begin with."""
        found = [each.candidate.origin for each in self.placements.values()]
        return max(ORIGINS, key=found.count)


def place(surfaces: list[Unnamed], oracle: Result) -> Arrangement:
    """Place the surfaces among the buffers of a rendering."""
    board = _Board(surfaces, oracle)
    board.follow_labels()
    for board.with_spare, least in product((False, True), STEPS):
        while board.advance(least):
            pass
    return board.result()


@dataclass(eq=False)
class _Board:
    """What is placed so far."""

    surfaces: list[Unnamed]
    oracle: Result
    places: dict[str, Candidate] = field(default_factory=dict)
    margins: dict[str, float] = field(default_factory=dict)
    drawn: dict[str, np.ndarray] = field(default_factory=dict)
    predicted: Mapping[str, Reading] = field(default_factory=dict)
    with_spare: bool = False

    def __post_init__(self) -> None:
        scene = self.oracle.scene
        self.slots = slots_of(scene)
        found = sought(self.slots, self.oracle.buffers, scene.camera)
        self.wanted = {name: each for name, each in found.items() if not each.is_blank}
        self.comparison = Comparison(self.surfaces, self.wanted)
        self.rerun = Rerun(self.oracle, self.wanted)

    def follow_labels(self) -> None:
        """Place what is called like a buffer, if it may be that; of several the one that is most like it."""
        for name in self.wanted:
            named = (
                number for number, one in enumerate(self.surfaces) if name in one.labels and not self.is_used(number)
            )
            found = [each for number in named if (each := self.candidate(number, name))]
            if found:
                self.put(max(found, key=lambda each: each.score), 1.0)
        self.predicted = self.rerun.readings(self.drawn)

    def advance(self, least: float) -> bool:
        """Place what is sure enough and for which at least so much speaks; whether there was any."""
        before = len(self.places)
        rivalry = Rivalry(self.surfaces, self.candidates())
        for each in (one for one in rivalry.candidates if one.score >= max(least, self.wanted[one.name].least)):
            if self.is_free(each) and self.is_settled(each) and (margin := rivalry.margin(each)) >= needed(each):
                self.put(each, margin)
        if len(self.places) > before:
            self.predicted = self.rerun.readings(self.drawn)
        return len(self.places) > before

    def candidates(self) -> list[Candidate]:
        """Every free surface for every free buffer."""
        surfaces = [n for n, one in enumerate(self.surfaces) if not one.is_blank and self.with_spare >= one.is_spare]
        names = [name for name in self.wanted if name not in self.places]
        found = (self.candidate(surface, name) for name in names for surface in surfaces)
        return [each for each in found if each]

    def candidate(self, surface: int, name: str) -> Candidate | None:
        """A surface as a buffer; what its values do not tell of rows and channels is as in the others."""
        free, predicted = self.free_for(surface, name), self.predicted.get(name)
        found = self.comparison.candidate(surface, name, free, predicted)
        if found is None or self.is_told(found):
            return found
        return self.comparison.candidate(surface, name, free, predicted, self.habit(found))

    def is_told(self, each: Candidate) -> bool:
        """Whether the values tell which row comes first and how the channels are ordered."""
        return self.has_sure_rows(each) and each.has_sure_order

    def has_sure_rows(self, each: Candidate) -> bool:
        """Whether the values tell which row comes first, or it makes no difference."""
        return each.turned >= TELLS or self.surfaces[each.surface].is_even

    def habit(self, each: Candidate) -> Habit:
        """How files of that kind are written, as far as those agree that tell it."""
        suffix = self.surfaces[each.surface].path.suffix
        alike = [one for one in self.places.values() if self.surfaces[one.surface].path.suffix == suffix]
        origins = {each.origin} if self.has_sure_rows(each) else {one.origin for one in alike if one.turned >= TELLS}
        in_order = [one.is_in_order for one in alike if len(one.channels) > 1 and one.has_sure_order]
        agreed = len(in_order) >= AGREEING and all(in_order)
        return Habit(tuple(origins) if len(origins) == 1 else ORIGINS, agreed)

    def is_settled(self, each: Candidate) -> bool:
        """Whether rows and channels are told by the values, or by what is placed."""
        habit = self.habit(each)
        return (self.has_sure_rows(each) or len(habit.origins) == 1) and (each.has_sure_order or habit.in_order)

    def free(self, surface: int) -> tuple[int, ...]:
        """The channels of a surface that are no buffer's yet."""
        taken = {c for each in self.places.values() if each.surface == surface for c in each.channels}
        return tuple(c for c in range(len(self.surfaces[surface].channels)) if c not in taken)

    def free_for(self, surface: int, name: str) -> tuple[int, ...]:
        """Those that may be this buffer: an opacity, which many pictures share, is a mask only where no other is."""
        opacity = self.surfaces[surface].opacity
        masked = self.wanted[name].slot.dtype.kind == "u" and not self.with_spare
        return tuple(c for c in self.free(surface) if c != opacity or not masked)

    def is_free(self, each: Candidate) -> bool:
        """Whether neither its buffer nor its channels are taken."""
        return each.name not in self.places and set(each.channels) <= set(self.free(each.surface))

    def put(self, each: Candidate, margin: float) -> None:
        """Place a candidate; its numbers are what the stages after it read, if they can be."""
        self.places[each.name], self.margins[each.name] = each, margin
        placement = self.placement(each.name)
        source = Source(each.name, placement.surface.path, placement.table, each.origin)
        try:
            parts = (placement.surface.texels,)
            self.drawn[each.name] = converted(source, self.slots[each.name], parts, self.oracle.scene.camera).data
        except DumpError:  # told when it is read to be judged
            self.drawn.pop(each.name, None)

    def placement(self, name: str) -> Placement:
        """A place that is taken."""
        each = self.places[name]
        return Placement(self.surfaces[each.surface], each, self.margins[name])

    def result(self) -> Arrangement:
        """All places, with what is left over."""
        rivalry = Rivalry(self.surfaces, (one for one in self.candidates() if one.score >= ASKED))
        left = [number for number in range(len(self.surfaces)) if not self.is_used(number)]
        asked = [self.question(number, rivalry) for number in left]
        known = {surface for question in asked if question for surface in question.surfaces}
        unknown = tuple(self.surfaces[number] for number in left if self.surfaces[number] not in known)
        places = {name: self.placement(name) for name in self.wanted if name in self.places}
        return Arrangement(places, tuple(dict.fromkeys(question for question in asked if question)), unknown)

    def is_used(self, surface: int) -> bool:
        """Whether any channel of it is placed."""
        return any(each.surface == surface for each in self.places.values())

    def question(self, surface: int, rivalry: Rivalry) -> Question | None:
        """What a surface that is not placed might be, with what stands in its way; None if it is like nothing."""
        own = rivalry.of_surface.get(surface)
        if not own:
            return None
        rivals = rivalry.rivals(own[0])
        names = {own[0].name, *(each.name for each in rivals if each.surface == surface)}
        others = {
            surface,
            *(each.surface for each in rivals if each.name == own[0].name and not self.is_used(each.surface)),
        }
        return Question(
            tuple(self.surfaces[number] for number in sorted(others)),
            tuple(name for name in self.wanted if name in names),
        )
