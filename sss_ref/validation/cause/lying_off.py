"""How far off a drawn picture lies, or how much larger it is, measured on what was dumped to a part of a pixel.

To first order a picture that moved by d is got(p) = drawn(p - d) = drawn(p) - d . slope(p) (Lucas and Kanade 1981).
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.language.types import mat4
from sss_ref.validation.cause.hypothesis import INPUT, NUMBER, SETTING, STATE, Charge
from sss_ref.validation.cause.redrawn import Matrix, Redrawing, lies, seen_otherwise
from sss_ref.validation.clock import Limit

FAR, SAME_DEPTH = 1.0, 2.0**-14  # the depth where nothing is drawn, and from what on depths are others
CLOSER, FARTHEST = 6, 8.0  # how often a fit is made anew, and how many pixels it may come to
TRIMS = 4
DECIMALS, AS_GOOD_AS = 3, 0.005  # of a pixel, and pixels
NOTICED = 2.0**-9  # of a picture's size
SEARCHED = [2.0**-power for power in range(1, 8)]  # pixels: the steps of a search, where no number has a slope
AROUND = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if (x, y) != (0, 0)]


@dataclass(frozen=True)
class LyingOff:
    """What a picture's lying off is, the uniforms with which it does, and how simple an explanation that is."""

    charge: Charge
    uniforms: Mapping[str, Any]
    rank: int = STATE


@dataclass(frozen=True)
class Projected:
    """A draw through a projection, which may be moved and scaled. name: its matrix among the uniforms."""

    todo: Redrawing
    name: str

    @property
    def right(self) -> Matrix:
        """The matrix as it should be, float64."""
        return np.asarray(self.todo.case.oracle.scene.uniforms[self.name], np.float64)

    def uniforms(self, x: float, y: float, scale: float = 1.0) -> dict[str, Any]:
        """Those that draw the picture so many pixels to the right and up, and so many times as large."""
        width, height = self.todo.case.oracle.scene.size(self.todo.this_pass)
        change = np.array([[scale, 0, 0, 2 * x / width], [0, scale, 0, 2 * y / height], [0, 0, 1, 0], [0, 0, 0, 1.0]])
        return {self.name: (change @ self.right).astype(np.float32)}

    def off_by(self, x: float, y: float) -> LyingOff:
        """A picture that lies beside its place; a viewport moves it by halves of pixels, other parts a matrix does."""
        text = f"{lies(x, y)}: a viewport, or a jitter left in {self.name}"
        blames = SETTING if all((2 * each).is_integer() for each in (x, y)) else INPUT
        return LyingOff(Charge(text, blames, (self.name,)), self.uniforms(x, y))

    def with_planes(self, slope: float, offset: float) -> LyingOff:
        """A picture whose depths d (0 to 1) are slope * d + offset."""
        matrix = self.right
        ours = planes_of(matrix)
        matrix[2] = slope * matrix[2] + (slope + 2 * offset - 1) * matrix[3]
        there = planes_of(matrix)
        if ours is None or there is None:
            text = f"{self.name} has other near and far planes: depths are {slope:.4g} * d + {offset:.4g}"
        else:
            text = f"{self.name} has near {there[0]:.3g} and far {there[1]:.3g}, not {ours[0]:.3g} and {ours[1]:.3g}"
        return LyingOff(Charge(text, INPUT, (self.name,)), {self.name: matrix.astype(np.float32)})

    def larger(self, scale: float) -> LyingOff:
        """A picture of another size."""
        text = f"{self.name} is {seen_otherwise(self.right)} {1 / scale:.4g} times as large"
        return LyingOff(Charge(text, INPUT, (self.name,)), self.uniforms(0.0, 0.0, scale), NUMBER)


def lying_off(todo: Redrawing, limit: Limit) -> Iterator[LyingOff]:
    """The offset and the size that fit best, if they can be told from right ones. limit: the time for a search."""
    names = [name for name, kind in todo.this_pass.draw.reads.items() if kind is mat4 and "clip_from" in name]
    for name in names:
        draw = Projected(todo, name)
        x, y = fitted_shift(draw, limit)
        if x or y:
            yield draw.off_by(x, y)
        scale = _fitted_scale(draw)
        if abs(scale - 1) >= NOTICED:
            yield draw.larger(scale)
        slope, offset = _fitted_depths(draw)
        if slope > 0 and max(abs(slope - 1), abs(offset)) >= SAME_DEPTH:  # below 0 the far is near
            yield draw.with_planes(slope, offset)


def planes_of(clip_from_model: Matrix) -> tuple[float, float] | None:
    """The distances at which z is -w and w; None where w is the same all over, which says nothing of distances."""
    z, w = clip_from_model[2], clip_from_model[3]
    if not w[:3].any():
        return None
    slope = float(z[:3] @ w[:3] / (w[:3] @ w[:3]))  # z = slope * w + offset
    offset = float(z[3] - slope * w[3])
    with np.errstate(divide="ignore"):
        near, far = -np.divide(offset, (slope + 1, slope - 1))
    return float(near), float(far)


def fitted_shift(draw: Projected, limit: Limit) -> tuple[float, float]:
    """The pixels to the right and up by which what was dumped lies off: measured on numbers, or else searched for."""
    with_slopes = _with_slopes(draw.todo)
    if not with_slopes:
        return _searched(draw, limit)
    shift = np.zeros(2)
    for _ in range(CLOSER):
        shift += _fit(with_slopes[0], draw.uniforms(*shift), _along_both)
    x, y = np.clip(shift, -FARTHEST, FARTHEST)
    return _likely(x), _likely(y)


def _likely(offset: float) -> float:
    """The half or whole pixel that was measured, or else what was, to a thousandth."""
    half = round(2 * offset) / 2
    return half if abs(offset - half) <= AS_GOOD_AS else round(float(offset), DECIMALS)


def _with_slopes(todo: Redrawing) -> list[Redrawing]:
    """The draw of each dumped buffer of the pass that holds numbers, what the rasterizer wrote first."""
    dumped = todo.case.drawing.buffers
    names = (todo.buffer, todo.this_pass.draw.depth, *todo.this_pass.outputs)
    return [todo.of(name) for name in names if name in dumped and dumped[name].dtype == np.float32]


def _fitted_scale(draw: Projected) -> float:
    """How many times as large what was dumped is, about the middle of the picture; 1 where that cannot be measured."""
    scale = 1.0
    for todo in _with_slopes(draw.todo)[:1]:
        for _ in range(CLOSER):
            grown = _fit(todo, draw.uniforms(0.0, 0.0, scale), _from_the_middle)
            scale *= float(np.clip(1 + grown[0], 0.5, 2.0))
    return scale


def _fitted_depths(draw: Projected) -> tuple[float, float]:
    """The slope and offset that make our depths those that were dumped, where both drew; 1 and 0 where none were."""
    todo = draw.todo.of(draw.todo.this_pass.draw.depth)
    got = todo.case.drawing.buffers.get(todo.buffer)
    if got is None:
        return 1.0, 0.0
    ours = todo.draw().astype(np.float64)
    both = (ours < FAR) & (got < FAR)
    if not both.any() or np.ptp(ours[both]) == 0:
        return 1.0, 0.0
    slope, offset = np.polyfit(ours[both], got[both].astype(np.float64), 1)
    return float(slope), float(offset)


Regressors = Callable[[np.ndarray, np.ndarray], list[np.ndarray]]  # of the slopes to the right and up, (H, W, C)


def _along_both(right: np.ndarray, up: np.ndarray) -> list[np.ndarray]:
    return [right, up]


def _from_the_middle(right: np.ndarray, up: np.ndarray) -> list[np.ndarray]:
    height, width, _ = right.shape
    columns, rows = np.arange(width) - (width - 1) / 2, np.arange(height) - (height - 1) / 2
    return [right * columns[None, :, None] + up * rows[:, None, None]]


def _fit(todo: Redrawing, uniforms: Mapping[str, Any], regressors: Regressors) -> np.ndarray:
    """How far what was dumped lies from what these uniforms draw, on the smoother half."""
    got, drawn = todo.case.drawing.buffers[todo.buffer], todo.draw(uniforms)
    with np.errstate(all="ignore"):
        picture = np.atleast_3d(drawn).astype(np.float64)
        up, right = (np.asarray(np.gradient(picture, axis=axis)) for axis in (0, 1))
        bent = np.abs(np.gradient(up, axis=0)) + np.abs(np.gradient(right, axis=1))
        off = picture - np.atleast_3d(got)
        seen = np.isfinite(bent) & np.isfinite(off) & (np.abs(right) + np.abs(up) > 0)
    moves = regressors(right, up)
    if not seen.any():
        return np.zeros(len(moves))
    smooth = seen & (bent <= np.median(bent[seen]))
    return _trimmed(np.stack([each[smooth] for each in moves], axis=1), off[smooth])


def _trimmed(slopes: np.ndarray, off: np.ndarray) -> np.ndarray:
    """The solution of slopes . x = off by least squares, where several times the worse half has been left out."""
    kept, fitted = np.ones(len(off), bool), np.zeros(slopes.shape[1])
    for _ in range(TRIMS):
        fitted = np.linalg.lstsq(slopes[kept], off[kept], rcond=None)[0]
        beside = np.abs(slopes @ fitted - off)
        kept = beside <= np.median(beside)
    return fitted


def _searched(draw: Projected, limit: Limit) -> tuple[float, float]:
    """The offset with which the fewest pixels differ, in ever smaller steps; 0 where none is better than none."""
    got = draw.todo.case.drawing.buffers[draw.todo.buffer]

    def misfit(x: float, y: float) -> int:
        return int((draw.todo.draw(draw.uniforms(x, y)) != got).sum())

    best, least = (0.0, 0.0), misfit(0.0, 0.0)
    for step in limit.within("steps of a search", SEARCHED):
        around = [(best[0] + x * step, best[1] + y * step) for x, y in AROUND]
        misfits = [misfit(*each) for each in around]
        if min(misfits) < least:
            best, least = around[int(np.argmin(misfits))], min(misfits)
    return best
