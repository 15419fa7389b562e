"""What is said of each buffer: how many pixels are right, how much was let pass, and where it is wrong."""

from dataclasses import dataclass, replace

import numpy as np

from sss_ref.results.diff import ULP_CLASSES, ulp_class
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.verdict.background import Background, background_of
from sss_ref.validation.verdict.clusters import Clusters, Whereabouts
from sss_ref.validation.verdict.outcomes import (
    AMBIGUOUS,
    FAIL,
    OUTCOMES,
    UNBOUNDED,
    UNDEFINED,
    Compared,
    compared,
    distance,
)
from sss_ref.validation.verdict.pixel_text import pixel_text
from sss_ref.validation.verdict.widths import Widths, in_ulps, share_let_pass, widths_of

ESTIMATED = ("certain", "ambiguous", "unbounded")  # outcomes that a sample tells of pixels whose value is the exact one
LOOSE = 0.1  # of what a buffer holds, on average: 0.01 at most where all is given and profile vulkan or gl


@dataclass(frozen=True)
class WrongPixel:
    """A pixel that is out of reach.

    at: (column, row), row 0 at the bottom. got, expected: its values as text. triangles: the one that the oracle shows
    there, and the dump's if it is another; -1 is none. ulps, widths: how far beyond the interval its worst channel
    lies, in ULP and in widths of the interval; infinite for NaN, and widths of an exact value.
    """

    at: tuple[int, int]
    got: str
    expected: str
    triangles: tuple[int, ...]
    ulps: float
    widths: float

    def __str__(self) -> str:
        """As part of a sentence."""
        ids = " or ".join("no triangle" if each < 0 else f"triangle {each}" for each in self.triangles)
        return f"at pixel {self.at[0]},{self.at[1]} ({ids}): {self.got}, expected {self.expected}"


@dataclass(frozen=True)
class Verdict:
    """One buffer.

    ulps: values in each of ULP_CLASSES. first, worst: the first wrong pixel, row by row from the bottom, and the one
    that lies farthest beyond its reach; None without any, as are the clusters. suspects: of a buffer that is wrong, the
    stages one of which is, as PASS/STAGE in stage order: its own as the last, and those before it whose results were
    not given. background: what stands where nothing is drawn, if that is wrong. comparable: how many pixels a whole
    judgement compares. passing: how much of what the buffer holds is let pass on average, 0 to 1. narrowing: of one
    that is judged loosely, the buffers that were not given and would narrow its bounds. bounded: of how many pixels
    bounds were worked out; ambiguous and unbounded are estimates where that is fewer than were compared.
    """

    pass_name: str
    stage: str
    buffer: str
    compared: int  # pixels
    equal: int  # pixels with the same bits
    within: int  # pixels within reach
    ambiguous: int  # of these, pixels where a processor may take one of several texels or sides
    unbounded: int  # of these, pixels about which nothing can be said
    undefined: int  # pixels computed from what is not finite; neither right nor wrong
    ulps: tuple[int, ...]
    widths: Widths
    first: WrongPixel | None = None
    worst: WrongPixel | None = None
    clusters: Clusters | None = None
    chained: int | None = None  # pixels within what the whole may give without any of the dump (see `chained`)
    suspects: tuple[str, ...] = ()
    background: Background | None = None
    comparable: int = 0
    passing: float = 0.0
    narrowing: tuple[str, ...] = ()
    bounded: int = 0

    @property
    def decided(self) -> float:
        """The share of the pixels that a whole judgement compares about which something is said."""
        told = self.compared - self.undefined - self.unbounded
        return told / max(self.comparable, self.compared, 1)

    @property
    def certain(self) -> int:
        """Pixels within reach beyond doubt."""
        return self.within - self.ambiguous - self.unbounded

    @property
    def failing(self) -> int:
        """Pixels out of reach."""
        return self.compared - self.within - self.undefined

    @property
    def outcomes(self) -> tuple[int, ...]:
        """Pixels with each of OUTCOMES."""
        return self.certain, self.ambiguous, self.failing, self.undefined, self.unbounded

    @property
    def estimated(self) -> tuple[bool, ...]:
        """Whether each of `outcomes` is an estimate; where none seems ambiguous or unbounded, not so."""
        seen = self.bounded < self.compared and bool(self.ambiguous or self.unbounded)
        return tuple(seen and each in ESTIMATED for each in OUTCOMES)

    @property
    def inherits(self) -> bool:
        """Whether the stage is right and its buffer is wrong all the same."""
        return self.passed and self.chained is not None and self.chained < self.compared

    @property
    def failed(self) -> bool:
        """Whether a pixel is out of reach, or the background."""
        return bool(self.failing) or self.background is not None

    @property
    def loose(self) -> bool:
        """Whether so much of what the buffer holds is let pass that a pass proves little."""
        return self.passing >= LOOSE

    @property
    def empty(self) -> bool:
        """Whether there is nothing to judge: no pixel of which anything can be said, and no wrong background."""
        return not self.failed and self.compared == self.undefined + self.unbounded

    @property
    def passed(self) -> bool:
        """Whether there are pixels of which something can be said, and all is right that can be."""
        return not self.failed and not self.empty


def judged(check: Check, whereabouts: Whereabouts) -> Verdict:
    """The verdict on one buffer."""
    pixels = compared(check)
    defined, wrong, sample = pixels.outcome != UNDEFINED, pixels.outcome == FAIL, pixels.sample
    held = [each if sample.all() else each[sample] for each in (pixels.expected, pixels.reach)]
    verdict = Verdict(
        check.pass_name,
        check.stage,
        check.buffer,
        compared=len(wrong),
        equal=int((~pixels.differs).sum()),
        within=int((defined & ~wrong).sum()),
        ambiguous=pixels.count(AMBIGUOUS),
        unbounded=pixels.count(UNBOUNDED),
        undefined=pixels.count(UNDEFINED),
        ulps=_ulps_off(pixels),
        widths=widths_of(*held),
        background=background_of(check),
        comparable=int(check.comparable.sum()),
        passing=share_let_pass(*held),
        bounded=len(wrong) if pixels.bounded is None else int(np.count_nonzero(pixels.bounded)),
    )
    return _with_wrong_pixels(verdict, check, pixels, whereabouts) if wrong.any() else verdict


def _ulps_off(pixels: Compared) -> tuple[int, ...]:
    """How many values lie in each of ULP_CLASSES."""
    differing = ulp_class(pixels.expected[pixels.differs], pixels.got[pixels.differs])
    counts = np.bincount(differing.reshape(-1), minlength=len(ULP_CLASSES))
    counts[0] += pixels.got.size - differing.size
    return tuple(counts.tolist())


def _with_wrong_pixels(verdict: Verdict, check: Check, pixels: Compared, whereabouts: Whereabouts) -> Verdict:
    """The verdict with its first and worst wrong pixels, and where all of them lie."""
    wrong = np.flatnonzero(pixels.outcome == FAIL)
    beyond = _beyond(pixels, wrong).max(axis=1)
    first, worst = (_wrong_pixel(check, pixels, index, whereabouts) for index in (wrong[0], wrong[beyond.argmax()]))
    where = np.zeros(check.where.shape, bool)
    where[check.where] = pixels.outcome == FAIL
    clusters = whereabouts.clusters(check.pass_name, check.where, where)
    return replace(verdict, first=first, worst=worst, clusters=clusters)


def _wrong_pixel(check: Check, pixels: Compared, index: int, whereabouts: Whereabouts) -> WrongPixel:
    """One of the compared pixels."""
    row, column = np.argwhere(check.where)[index].tolist()
    at = np.array([index])
    beyond = _beyond(pixels, at)
    ulps = in_ulps(beyond, pixels.expected[at], pixels.reach[at])
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        widths = np.where(beyond > 0, beyond / (2 * pixels.reach[at]), 0.0)
    values = pixel_text(pixels.got[index]), pixel_text(pixels.expected[index])
    return WrongPixel(
        (column, row), *values, whereabouts.at(check.pass_name, (column, row)), float(ulps.max()), float(widths.max())
    )


def _beyond(pixels: Compared, at: np.ndarray) -> np.ndarray:
    """How far beyond their reach the channels of some pixels lie; infinitely far where they are not finite."""
    with np.errstate(invalid="ignore"):
        beyond = np.maximum(distance(pixels.expected[at], pixels.got[at]) - pixels.reach[at], 0.0)
    return np.where(np.isfinite(pixels.got[at]), beyond, np.inf)
