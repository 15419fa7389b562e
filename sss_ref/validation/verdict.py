"""What is said of each buffer, and of the whole: which stage is the first that is wrong."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.explanation.rows import Section
from sss_ref.io.diff import ULP_CLASSES, bits, ulp_class
from sss_ref.validation.hypotheses import Hypothesis
from sss_ref.validation.rebased import Check

SHARE, FEW = (
    1e-4,
    2,
)  # of the compared pixels, and as many besides, that may be out of reach: the reach of interpolation
# is an estimate, and on slivers of triangles it can be too small


@dataclass(frozen=True)
class Verdict:
    """One buffer.

    ulps: values in each of ULP_CLASSES. worst, worst_pixel: what lies farthest beyond its reach, if anything does, in
    words and as (column, row).
    """

    pass_name: str
    stage: str
    buffer: str
    compared: int  # pixels
    equal: int  # pixels with the same bits
    within: int  # pixels within reach
    ulps: tuple[int, ...]
    worst: str | None
    worst_pixel: tuple[int, int] | None
    ambiguous: int  # pixels where a processor may take one of several texels or sides
    unbounded: int  # pixels about which nothing can be said; they count as within
    chained: int | None = None  # pixels within what the whole may give without any of the dump (see `chained`)

    @property
    def inherits(self) -> bool:
        """Whether the stage is right and its buffer is wrong all the same."""
        return self.passed and self.chained is not None and not self._nearly_all(self.chained)

    @property
    def passed(self) -> bool:
        """Whether enough pixels are within reach, and there are any."""
        return self.compared > 0 and self._nearly_all(self.within)

    def _nearly_all(self, pixels: int) -> bool:
        return self.compared - pixels <= SHARE * self.compared + FEW


@dataclass(frozen=True)
class Finding:
    """What was found out about the first stage that is wrong.

    check: its buffer beside what should be in it. hypotheses: what would explain it. section: the stage at the worst
    pixel, line by line, as it should have been; None for what the rasterizer wrote.
    """

    check: Check
    hypotheses: tuple[Hypothesis, ...]
    section: Section | None


@dataclass(frozen=True)
class Report:
    """The verdicts in stage order. missing: buffers that were not dumped. finding: None if all is right."""

    verdicts: tuple[Verdict, ...]
    missing: tuple[str, ...]
    finding: Finding | None = None

    @property
    def culprit(self) -> Verdict | None:
        """The first buffer that a stage got wrong although it had what it needed."""
        return next((verdict for verdict in self.verdicts if not verdict.passed), None)

    @property
    def passed(self) -> bool:
        """Whether there are verdicts and all are good."""
        return bool(self.verdicts) and self.culprit is None

    @property
    def explanations(self) -> list[str]:
        """What would explain the failure, in sentences."""
        found = self.finding.hypotheses if self.finding else ()
        return [f"explained on {each.share:.1%} of the pixels tried: {each.text}" for each in found]

    @property
    def summary(self) -> str:
        """The outcome in a sentence."""
        if not self.verdicts:
            return "fail: there is no buffer to judge"
        wrong = self.culprit
        if wrong is None:
            return (
                f"pass: {len(self.verdicts)} buffers, every stage gives what it should"
                if self.passed
                else "nothing to judge"
            )
        if not wrong.compared:
            return f"fail: stage {wrong.stage} of pass {wrong.pass_name}: no pixel of {wrong.buffer} can be compared"
        outside = 1 - wrong.within / wrong.compared
        return (
            f"fail: stage {wrong.stage} of pass {wrong.pass_name} is the first that is wrong: {outside:.1%} of the "
            f"pixels of {wrong.buffer} are out of reach, {wrong.worst}"
        )


def judged(check: Check) -> Verdict:
    """The verdict on one buffer. A NaN is never within reach."""
    expected, got, reach = (np.atleast_3d(array)[check.where] for array in (check.expected, check.got, check.reach))
    with np.errstate(invalid="ignore"):  # two infinities have no distance
        apart = np.abs(got.astype(np.float64) - expected.astype(np.float64))
    within = (apart <= reach).all(axis=-1)
    classes = np.bincount(ulp_class(expected, got).reshape(-1), minlength=len(ULP_CLASSES))
    equal = ~(bits(expected) != bits(got)).any(axis=-1)
    return Verdict(
        check.pass_name,
        check.stage,
        check.buffer,
        len(within),
        int(equal.sum()),
        int(within.sum()),
        tuple(classes.tolist()),
        *_worst(check, apart, reach, within),
        0 if check.undecided is None else int(check.undecided[check.where].sum()),
        int(np.isinf(reach).any(axis=-1).sum()),
    )


def _worst(check: Check, apart: np.ndarray, reach: np.ndarray, within: np.ndarray) -> tuple[Any, Any]:
    """The pixel that lies farthest beyond its reach, in words and as (column, row); None, None if none does."""
    if within.all():
        return None, None
    beyond = np.where(np.isfinite(apart), apart - reach, np.inf)
    index = int(np.argmax(np.where(within, -np.inf, beyond.max(axis=-1))))
    row, column = np.argwhere(check.where)[index].tolist()
    expected, got = (_shown(array[row, column]) for array in (check.expected, check.got))
    return f"worst at pixel {column},{row} (row 0 at the bottom): {got}, expected {expected}", (column, row)


def _shown(pixel: np.ndarray) -> str:
    parts = [str(part) for part in np.atleast_1d(pixel)]
    return parts[0] if len(parts) == 1 else f"({', '.join(parts)})"
