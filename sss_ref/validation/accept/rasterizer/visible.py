"""What a right processor may show at each pixel, and whether what was drawn is among it (rules R3 and R4)."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language.pipeline import Draw
from sss_ref.numerics.interval import Interval, each_end
from sss_ref.validation.accept.rasterizer.boxes import Boxes
from sss_ref.validation.accept.rasterizer.candidates import FAR, Candidates, candidates
from sss_ref.validation.accept.rasterizer.shared_edges import certain_ends
from sss_ref.validation.accept.storage import depth_storage, step_of

Buffers = Mapping[str, np.ndarray]
MUST_NOT, MAY, MUST = 0, 1, 2  # be covered


@dataclass(frozen=True)
class Visible:
    """The pieces that may be seen.

    draw, boxes: what is drawn, and its vertices. found: the candidates. covered: uint8 (H, W), MUST_NOT, MAY or MUST.
    """

    draw: Draw
    boxes: Boxes
    found: Candidates
    covered: np.ndarray

    @cached_property
    def triangle(self) -> np.ndarray:
        """The scene triangle of each candidate, int32 (M,)."""
        return self.boxes.primitives.triangle[self.found.piece]

    @cached_property
    def several(self) -> np.ndarray:
        """Bool (H, W): pixels that may show one of several triangles, or one or nothing."""
        some = np.zeros(self.covered.size, np.int32)
        some[self.found.pixel] = self.triangle
        return self._any(self.triangle != some[self.found.pixel]) | (self.covered == MAY)

    def _any(self, holds: np.ndarray) -> np.ndarray:
        """Bool (H, W): the pixels where something holds for a candidate."""
        count = np.bincount(self.found.pixel[holds], minlength=self.covered.size)
        return (count > 0).reshape(self.covered.shape)

    def reach(self, expected: Buffers, dumped: Buffers, depth: Interval | None) -> dict[str, np.ndarray]:
        """Buffer -> how far from the expected values (H, W) those that were dumped may be, float64 (H, W).

        A number or a coverage may be another one where that is right, else not. A depth must be that of the triangle
        beside it, if that was dumped. depth: all that the dumped depths (H, W) may have been before they were stored.
        """
        right, reach = self.accepted(dumped, depth), {}
        for name, holds in right.items():
            ours, theirs = expected[name], dumped[name]
            own = self._depth_reach(ours) if name == self.draw.depth else np.zeros(ours.shape)
            other = ~holds | (ours != theirs)
            with np.errstate(invalid="ignore"):
                apart = np.abs(theirs[other].astype(np.float64) - ours[other])
            near = own[other]
            own[other] = np.where(holds[other], np.fmax(near, apart), np.fmin(near, np.nextafter(apart, -1)))
            reach[name] = own
        return reach

    def accepted(self, dumped: Buffers, depth: Interval | None) -> dict[str, np.ndarray]:
        """Buffer -> bool (H, W), where what was dumped is right; of the rasterizer's buffers that were dumped.

        depth: as in `reach`; None if no depth was dumped.
        """
        draw, results, same = self.draw, {}, np.ones(len(self.found.pixel), bool)
        empty = self.covered != MUST
        if draw.triangle in dumped:
            drawn = dumped[draw.triangle]
            same = drawn.reshape(-1)[self.found.pixel] == self.triangle
            results[draw.triangle] = self._any(same) | (empty & (drawn < 0))
            empty = empty & (drawn < 0)
        if depth is not None:
            there = each_end(lambda end: end.reshape(-1)[self.found.pixel], depth)
            within = (there.high >= self.found.low) & (there.low <= self.found.high)
            results[draw.depth] = self._any(same & within) | (empty & (dumped[draw.depth] == np.float32(FAR)))
        if draw.coverage in dumped:
            drawn = dumped[draw.coverage] != 0
            possible = np.where(drawn, self.covered != MUST_NOT, self.covered != MUST)
            results[draw.coverage] = possible & self._is_beside(draw.triangle, dumped, drawn)
        return results

    def _is_beside(self, triangle: str, dumped: Buffers, drawn: np.ndarray) -> np.ndarray:
        """Bool (H, W): whether a coverage says what the triangle beside it does, where a pixel may be either."""
        if triangle not in dumped:
            return np.ones(drawn.shape, bool)
        return (self.covered != MAY) | (drawn == (dumped[triangle] >= 0))

    def _depth_reach(self, expected: np.ndarray) -> np.ndarray:
        """How far from the oracle's depths those of the triangle that it shows may be."""
        reach, at = np.zeros(expected.size), self.found.pixel
        there = expected.reshape(-1)[at].astype(np.float64)
        own = (self.found.low <= there) & (there <= self.found.high) & self.found.inside
        reach[at[own]] = np.maximum(there - self.found.low, self.found.high - there)[own]
        return reach.reshape(expected.shape)

    def shown(self, dumped: Buffers) -> np.ndarray:
        """The piece that each pixel of a dump shows, int32 (H, W): -1 where none, or where that cannot be told."""
        piece = np.full(self.covered.size, -1, np.int32)
        if self.draw.triangle in dumped:
            chosen = dumped[self.draw.triangle].reshape(-1)[self.found.pixel] == self.triangle
        else:
            chosen = ~self.several.reshape(-1)[self.found.pixel]
            if self.draw.coverage in dumped:
                chosen &= dumped[self.draw.coverage].reshape(-1)[self.found.pixel] != 0
        for better in (chosen & self._has_area, chosen & self._has_area & self.found.inside):
            piece[self.found.pixel[better]] = self.found.piece[better]
        return piece.reshape(self.covered.shape)

    @cached_property
    def _has_area(self) -> np.ndarray:
        """Bool (M,): the candidates that have an area where the oracle has their corners."""
        return self.boxes.drawable[self.found.piece]


def visible(boxes: Boxes, draw: Draw, overlap: str, profile: Profile) -> Visible:
    """What may be seen of a draw. overlap: the scene's policy for a layout, "first" or "last"."""
    turn = {"last": -1}.get(overlap, 1) if draw.layout else 0
    height, width = boxes.viewport.height, boxes.viewport.width
    found = candidates(boxes, turn, float(step_of(depth_storage(profile), np.ones(()))))
    ends = certain_ends(boxes, found, turn, height * width)
    in_front = found.low <= ends[found.pixel]
    found = Candidates(*(column[in_front] for column in found))
    covered = np.full(height * width, MUST_NOT, np.uint8)
    covered[found.pixel] = MAY
    covered[np.isfinite(ends)] = MUST
    return Visible(draw, boxes, found, covered.reshape(height, width))
