"""What is said of the whole: which stage is the first that is wrong, why, and how small an error would be seen."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.cause.hypothesis import TELLING, Hypothesis
from sss_ref.validation.report.metrics import Likeness
from sss_ref.validation.verdict.verdict import Verdict

if TYPE_CHECKING:  # a right dump is told without them
    from sss_ref.explanation.rows import Section
    from sss_ref.validation.cause.power import Power
    from sss_ref.validation.witness.witness import Witness

MOST_NAMED = 6  # suspects in a sentence
MOST_TO_DUMP = 4  # buffers that would narrow bounds
NEARLY_WHOLE = 0.9  # of the pixels that could be compared: below, a pass says how far it goes


@dataclass(frozen=True)
class Finding:
    """What was found out about the first stage that is wrong.

    check: its buffer beside what should be in it. hypotheses: what would explain it. section: the stage at the worst
    pixel, line by line, as it should have been and may be, then what was drawn; None for what the rasterizer wrote.
    not_tried: which explanations were not, in a sentence; empty if all were. witness: the worst pixel cut down to the
    stage; None of the rasterizer, and where no pixel of a stage is wrong.
    """

    check: Check
    hypotheses: tuple[Hypothesis, ...]
    section: "Section | None"
    witness: "Witness | None" = None
    not_tried: str = ""


@dataclass(frozen=True)
class Report:
    """The verdicts in stage order, and what else is known.

    missing: buffers that were not dumped. finding: None if all is right. power: of each judged stage, what would be
    seen. likeness: what metrics of pictures say, if asked for. profile: the processor that may have drawn the buffers,
    by name. device: the one that did, in its own words. seconds: phase -> time. only: the single stage that was judged.
    """

    verdicts: tuple[Verdict, ...]
    missing: tuple[str, ...]
    finding: Finding | None = None
    power: tuple["Power", ...] = ()
    likeness: tuple[Likeness, ...] = ()
    profile: str = ""
    device: str | None = None
    seconds: Mapping[str, float] = field(default_factory=dict)
    only: str | None = None

    @property
    def culprit(self) -> Verdict | None:
        """The first buffer that a stage got wrong although it had what it needed."""
        return next((verdict for verdict in self.verdicts if verdict.failed), None)

    @property
    def empty(self) -> tuple[str, ...]:
        """The buffers without a pixel to judge: they neither pass nor fail."""
        return tuple(verdict.buffer for verdict in self.verdicts if verdict.empty)

    @property
    def judged(self) -> bool:
        """Whether anything was."""
        return any(not verdict.empty for verdict in self.verdicts)

    @property
    def passed(self) -> bool:
        """Whether anything was judged and all that was is right."""
        return self.judged and self.culprit is None

    @property
    def explanations(self) -> list[str]:
        """What would explain the failure, in sentences."""
        found = self.finding.hypotheses if self.finding else ()
        told = [f"explained on {each.share:.1%} of the wrong pixels tried: {each.text}" for each in found]
        return [*told, self.finding.not_tried] if self.finding and self.finding.not_tried else told

    @property
    def summary(self) -> str:
        """The outcome in a sentence."""
        if not self.judged:
            return f"empty: {self.nothing}"
        wrong = self.culprit
        if wrong is None and self.only:
            return f"pass{self._so_far}: stage {self.only} gives what it should; no other stage was judged{self._loose}"
        if wrong is None:
            count = len(self.verdicts) - len(self.empty)
            return f"pass{self._so_far}: {count} buffers, every stage gives what it should{self._but}"
        at = f"stage {wrong.stage} of pass {wrong.pass_name}"
        if not wrong.failing and wrong.background:
            return f"fail: pass {wrong.pass_name} is {self._which} wrong: in {wrong.buffer}, {wrong.background}"
        return (
            f"fail: {at}{_or_before(wrong)} is {self._which} wrong: {wrong.failing / wrong.compared:.1%} of the "
            f"pixels of {wrong.buffer} are out of reach, worst {wrong.worst}"
        )

    @property
    def nothing(self) -> str:
        """Why nothing was judged, in a sentence."""
        of_stage = f" of stage {self.only}" if self.only else ""
        if not self.verdicts:
            return f"no buffer{of_stage} to judge"
        return f"no pixel{of_stage} that can be judged, of {', '.join(self.empty)}"

    @property
    def _but(self) -> str:
        """Which buffers a pass says nothing of, and of which little."""
        empty = f"; empty, without a pixel to judge: {', '.join(self.empty)}" if self.empty else ""
        return empty + self._loose

    @property
    def _loose(self) -> str:
        """Of which buffers a pass proves little, and what to give that it would prove more."""
        return "".join(map(_loosely, (each for each in self.verdicts if each.loose and not each.empty)))

    @property
    def _so_far(self) -> str:
        """How far a pass goes where little is said of some buffer of which something is."""
        least = min((each for each in self.verdicts if not each.empty), key=lambda verdict: verdict.decided)
        if least.decided >= NEARLY_WHOLE:
            return ""
        return f" as far as was judged, {least.decided:.0%} of the pixels of {least.buffer}"

    @property
    def _which(self) -> str:
        """How a wrong stage is called among those that were judged."""
        return "the only one judged, and" if self.only else "the first that is"

    @property
    def details(self) -> list[str]:
        """The first wrong pixel, how far off the worst is, and where the wrong pixels lie, in sentences."""
        wrong = self.culprit
        if wrong is None or wrong.first is None or wrong.worst is None or wrong.clusters is None:
            return []
        worst = wrong.worst
        far = [f"the worst pixel is {worst.ulps:.3g} ulp beyond its interval, {worst.widths:.3g} times its width"]
        few = ["too few pixels are wrong to say what would explain it"] if wrong.failing < TELLING else []
        besides = [f"besides, {wrong.background}"] if wrong.background else []
        told = [*(far if math.isfinite(worst.widths) else []), wrong.clusters.sentence, *besides, *few]
        return [f"first {wrong.first}", *told]

    @property
    def sensitivity(self) -> list[str]:
        """The smallest relative error in each number that would be seen, and how many mistakes would, in sentences."""
        tried, seen = (sum(getattr(each, name) for each in self.power) for name in ("mistakes", "seen"))
        if not self.power:
            return []
        unseen = "; ".join(f"{each.stage}: {text}" for each in self.power for text in each.unseen)
        missed = f"; not: {unseen}" if unseen else ""
        lines = [str(each) for each in self.power if each.numbers]
        hidden = "; ".join(f"{each.stage}: {text}" for each in self.power for text in each.hidden)
        blind = [f"no difference here, another view or scene would show it: {hidden}"] if hidden else []
        return [*lines, f"of {tried} mistakes in these stages {seen} would be seen{missed}", *blind]


def _loosely(one: Verdict) -> str:
    """How loosely a buffer was judged, and what would narrow its bounds."""
    more = [f"{len(one.narrowing) - MOST_TO_DUMP} more"] if len(one.narrowing) > MOST_TO_DUMP else []
    names = ", ".join([*one.narrowing[:MOST_TO_DUMP], *more])
    remedy = f"; dump {names} to narrow" if names else ""
    return f"; {one.buffer}: bounds so wide that {one.passing:.0%} of its range passes{remedy}"


def _or_before(wrong: Verdict) -> str:
    """The other suspects, the nearest by name; empty if there are none."""
    before = wrong.suspects[:-1]
    if not before:
        return ""
    more = [f"{len(before) - MOST_NAMED} more"] if len(before) > MOST_NAMED else []
    return f", or one before it whose output was not given ({', '.join([*more, *before[-MOST_NAMED:]])}),"
