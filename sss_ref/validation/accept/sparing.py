"""Bounds where they decide something, and at a sample of all pixels by which the report says how wide they are.

Bounds are held as how far a right value may be off the exact one, so a value that a stage gives exactly, or that
storage may make of that, is right whatever they are. So the stages run exactly at every pixel, and on intervals only
where a buffer holds something else, and at the sample.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from sss_ref.numerics.random_numbers import one_of_each_run
from sss_ref.rendering.fold import machine_of
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import KnownBuffer, Pixels
from sss_ref.validation.accept.walk import groups, in_rounds, side_by_side, walk

SAMPLE = 4096  # pixels of a pass: of a share of a hundredth some forty

SAMPLED = np.uint8(1)  # why bounds were worked out at a pixel; bits that add up
NEEDED = np.uint8(2)


@dataclass(frozen=True, eq=False)
class Reached:
    """What a stage gives exactly in a buffer, (H, W) or (H, W, C), and what else a right processor may give.

    reach: float64 of its shape, how far off. doubt: bool (H, W), whether it is one of several values. bounded: uint8
    (H, W), `SAMPLED`, `NEEDED` or their sum where bounds were worked out; elsewhere 0, as are reach and doubt. None:
    everywhere.
    """

    exact: np.ndarray
    reach: np.ndarray
    doubt: np.ndarray
    bounded: np.ndarray | None = None


@dataclass(frozen=True)
class Sparing:
    """At which pixels bounds are worked out.

    sample: at how many of a pass, beside those where they decide something; None: at all. chosen: bool (H, W), the
    pixels that are judged of buffers of this size; None: all.
    """

    sample: int | None = None
    chosen: np.ndarray | None = None

    def judged(self, where: np.ndarray) -> np.ndarray:
        """Those of some pixels, bool (H, W), that are judged."""
        return where if self.chosen is None or self.chosen.shape != where.shape else where & self.chosen

    def filled(self, drawn: DrawnPass, where: np.ndarray, start: Mapping[str, KnownBuffer]) -> dict[str, Reached]:
        """What the stages of a pass may write; where, start: as in `walk.filled`.

        Nothing is spared where there are hardly more pixels than the sample has, nor in a pass of several rounds, for
        what lies between them nobody dumps.
        """
        judged = self.judged(where)
        if self.sample is None or drawn.this_pass.fed_back or np.count_nonzero(judged) < 2 * self.sample:
            everywhere = in_rounds(drawn, drawn.read, where, start)
            return {name: Reached(each.exact, each.reach, each.doubt) for name, each in everywhere.items()}
        exact, found = _exactly(drawn, where, start), dict[str, Reached]()
        sample = sampled(judged, self.sample) * SAMPLED
        for group in groups(drawn):
            own = [name for stage in group for name in stage.writes.values() if name in exact]
            differs = [drawn.drawing.differs(name, exact[name]) for name in own]
            needed = sample | (judged & np.logical_or.reduce(differs)) * NEEDED
            found |= _reached(drawn.running(group), {name: exact[name] for name in own}, needed) if own else {}
        return found


def sampled(where: np.ndarray, count: int) -> np.ndarray:
    """Bool (H, W): of the pixels of a mask, row by row, one of each of so many runs of them.

    The place in a run is random, the same every time, so that it keeps step with no width of a picture.
    """
    chosen = np.flatnonzero(where)
    found = np.zeros(where.shape, bool)
    found.reshape(-1)[chosen[one_of_each_run(len(chosen), count)]] = True
    return found


def _reached(drawn: DrawnPass, exact: Mapping[str, np.ndarray], bounded: np.ndarray) -> dict[str, Reached]:
    """What the stages of a group may write, by bounds at some pixels. exact: what they give."""
    found = {name: Reached(buffer, *_nowhere(buffer), bounded) for name, buffer in exact.items()}

    def fill(at: Pixels) -> None:
        for run in walk(drawn, at):
            for name in (name for name in run.written if name in found):
                written, buffer = run.written[name], found[name]
                buffer.reach[at] = written.reach.reshape(-1, *buffer.exact.shape[2:])
                buffer.doubt[at] = written.doubt != 0

    side_by_side(fill, bounded != 0)
    return found


def _nowhere(buffer: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The reach and the doubt of a buffer where bounds are worked out at no pixel."""
    return np.zeros(buffer.shape), np.zeros(buffer.shape[:2], bool)


def _exactly(drawn: DrawnPass, where: np.ndarray, start: Mapping[str, KnownBuffer]) -> dict[str, np.ndarray]:
    """What the stages write exactly at the pixels of a mask; elsewhere what was there."""
    outputs = {name: buffer.exact.copy() for name, buffer in start.items()}
    work = replace(drawn.exactly, fragments=drawn.work.fragments.among(where), outputs=outputs)
    with machine_of("kernel") as machine:
        machine.interpreter.run_fragments(work, machine.pool)
    return outputs
