"""What stands in for a buffer that was not dumped: all that a right processor may have made of what was dumped.

Where the rasterizer may show one of several triangles, or one or nothing, and their numbers were not dumped, each of
these alternatives is tried: what the stages may give there is held against what was dumped beside it. What agrees may
have been drawn; if nothing does, something is wrong there, and any of it may have been.
"""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, reduce

import numpy as np

from sss_ref.language.layout import dtype_of, shape_of
from sss_ref.language.types import components
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.alternatives import Alternatives, Ends
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import Known, KnownBuffer, Pixels, pixels_of
from sss_ref.validation.accept.rasterizer.candidates import FAR
from sss_ref.validation.accept.rasterizer.visible import MUST, MUST_NOT, Visible
from sss_ref.validation.accept.walk import in_rounds, walk

MOST = 64  # pieces of one pixel that are tried; where there are more, a buffer may hold anything


def stand_ins(oracle: Result, drawn: DrawnPass, names: Collection[str]) -> dict[str, KnownBuffer]:
    """All that some buffers of a pass may hold that were not dumped.

    oracle: the rendering of the scene. drawn: the pass, reading what is known of the buffers before it. A texture with
    fewer bits than float32 may have rounded what it was given.
    """
    this_pass, where = drawn.this_pass, drawn.possible
    blank = {name: _blank(oracle, drawn, name) for name in {*names, *this_pass.fed_back}}
    start = {name: buffer for name, buffer in blank.items() if name not in this_pass.draw.outputs}
    found = {name: each.copy() for name, each in {**blank, **in_rounds(drawn, drawn.read, where, start)}.items()}
    _put_shown(drawn, found)
    for name, buffer in found.items():
        buffer.include(blank[name].exact, where & ~drawn.work.fragments.where)
    if drawn.visible:
        _Unknown(drawn, drawn.visible, blank).put(oracle, found)
    return {name: drawn.drawing.kept(name, buffer) for name, buffer in found.items()}


def _blank(oracle: Result, drawn: DrawnPass, name: str) -> KnownBuffer:
    """A buffer in which nothing was drawn."""
    kind, size = drawn.this_pass.values[name], oracle.scene.size(drawn.this_pass)
    buffer = np.empty(shape_of(kind, *size), dtype_of(kind))
    buffer[...] = oracle.scene.clear(name)
    return KnownBuffer.exactly(buffer)


def _put_shown(drawn: DrawnPass, found: Mapping[str, KnownBuffer]) -> None:
    """Put the number and the coverage where it is known which piece is shown."""
    draw, fragments = drawn.this_pass.draw, drawn.work.fragments
    if {draw.triangle, draw.coverage} & set(found):
        primitives, piece = fragments.of_mesh
        at = rows, _ = pixels_of(fragments.where)
        values = {draw.triangle: primitives.triangle[piece[at]], draw.coverage: np.ones(len(rows), np.uint8)}
        for name in set(values) & set(found):
            found[name].put(at, *3 * [values[name]])


@dataclass(frozen=True)
class _Unknown:
    """The pixels of a draw where it is not known which piece is shown, if any.

    blank: name -> where nothing was drawn, of the buffers that are sought.
    """

    drawn: DrawnPass
    visible: Visible
    blank: Mapping[str, KnownBuffer]

    @cached_property
    def where(self) -> np.ndarray:
        """Bool (H, W)."""
        return (self.visible.covered != MUST_NOT) & ~self.drawn.work.fragments.where

    @cached_property
    def dumped(self) -> set[str]:
        """What was dumped of the pass."""
        return set(self.drawn.this_pass.values) & set(self.drawn.drawing.buffers)

    def put(self, oracle: Result, found: Mapping[str, KnownBuffer]) -> None:
        """Put all that may stand there."""
        alternatives = Alternatives.none_yet(self.where, found)
        self._add_nothing(oracle, alternatives)
        for at, number in self._layers():
            self._add_pieces(at, number, alternatives)
        self._add_anything(alternatives)
        for name, buffer in found.items():
            low, high = (end.reshape(-1, *buffer.exact.shape[2:]) for end in alternatives.ends(name))
            buffer.put(pixels_of(self.where), np.clip(oracle[name][self.where], low, high), low, high)

    def _add_nothing(self, oracle: Result, alternatives: Alternatives) -> None:
        """Where nothing needs to be seen: what the buffers were cleared to."""
        at = rows, _ = pixels_of(self.where & (self.visible.covered != MUST))
        agrees = np.ones(len(rows), bool)
        for name in self.dumped:
            clear = np.broadcast_to(oracle.scene.clear(name), _channels(self.drawn.drawing.buffers[name]))
            agrees &= self._agrees(name, at, (clear, clear))
        values = {name: np.atleast_3d(buffer.exact)[at] for name, buffer in self.blank.items()}
        alternatives.add(at, agrees, {name: (value, value) for name, value in values.items()})

    def _layers(self) -> Iterator[tuple[Pixels, np.ndarray]]:
        """Pixels, each of them once, and the number of a candidate of each; together all candidates, up to MOST."""
        found = self.visible.found
        chosen = np.flatnonzero(self.where.reshape(-1)[found.pixel])
        pixel = found.pixel[chosen]
        turn = np.arange(len(pixel)) - np.searchsorted(pixel, pixel)
        for each in np.unique(turn[turn < MOST]):
            number = chosen[turn == each]
            yield divmod(found.pixel[number], self.where.shape[1]), number

    def _add_anything(self, alternatives: Alternatives) -> None:
        """Where more pieces may be seen than were tried."""
        count = np.bincount(self.visible.found.pixel, minlength=self.where.size).reshape(self.where.shape)
        rows, columns = pixels_of(self.where & (count > MOST))
        infinite = {name: np.full((len(rows), _channels(buffer.exact)), np.inf) for name, buffer in self.blank.items()}
        ends = {name: (-end, end) for name, end in infinite.items()}
        alternatives.add((rows, columns), np.ones(len(rows), bool), ends)

    def _add_pieces(self, at: Pixels, number: np.ndarray, alternatives: Alternatives) -> None:
        """What stands there if these candidates are seen."""
        found, draw = self.visible.found, self.drawn.this_pass.draw
        triangle, covered = self.visible.triangle[number], np.ones(len(number), bool)
        depth = (np.clip(end[number], 0.0, FAR) for end in (found.low, found.high))
        of_draw = {draw.triangle: (triangle, triangle), draw.coverage: (covered, covered), draw.depth: tuple(depth)}
        ends = {name: (low[:, None], high[:, None]) for name, (low, high) in of_draw.items()}
        ends |= self._written(at, found.piece[number])
        agrees = reduce(np.logical_and, [self._agrees(name, at, ends[name]) for name in self.dumped], covered)
        alternatives.add(at, agrees, {name: ends[name] for name in self.blank})

    def _written(self, at: Pixels, piece: np.ndarray) -> dict[str, Ends]:
        """What the stages may write if these pieces are seen; where one has no area for the oracle, anything."""
        wanted = {*self.blank, *self.dumped}
        with np.errstate(all="ignore"):  # of pieces without an area
            runs = [*walk(self.drawn.showing(wanted, at, piece), at)]
        flat = ~self.visible.boxes.drawable[piece]
        return {name: _ends(known, flat) for run in runs for name, known in run.written.items() if name in wanted}

    def _agrees(self, name: str, at: Pixels, ends: Ends) -> np.ndarray:
        """Bool (N,): whether what was dumped of a buffer may have come from what lies between these ends."""
        held = np.atleast_3d(self.drawn.drawing.buffers[name])[at]
        given = self.drawn.drawing.before(name, held)
        return ~((given.high < ends[0]) | (given.low > ends[1])).any(axis=1)


def _channels(buffer: np.ndarray) -> int:
    """How many numbers a pixel of a buffer (H, W) or (H, W, C) has."""
    return int(np.atleast_3d(buffer).shape[2])


def _ends(known: Known, undefined: np.ndarray) -> Ends:
    """The ends of what a stage may write."""
    parts = components(known.bounds)
    low, high = (np.stack([np.asarray(getattr(part, end), float) for part in parts], axis=1) for end in ("low", "high"))
    unknown = undefined[:, None] | np.isnan(low) | np.isnan(high)
    return np.where(unknown, -np.inf, low), np.where(unknown, np.inf, high)
