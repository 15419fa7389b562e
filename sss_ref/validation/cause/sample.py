"""A stage at some pixels that it got wrong and some that it got right, on which explanations are tried."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.language import Stage
from sss_ref.language.types import Vector
from sss_ref.numerics.random_numbers import one_of_each_run
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import Pixels, stacked
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.walk import exact_run
from sss_ref.validation.cause.chain import Chain, chain_of

SAMPLE = 600  # pixels on which explanations are tried
EVERY = 15  # of these the ones on which a mutant is tried first

Fit = tuple[float, float]  # shares of the wrong pixels brought within reach, and of the right ones that stay there


@dataclass(frozen=True)
class Sample:
    """A stage, or a chain of them, at some pixels of a buffer that it got wrong.

    inputs: what the stage reads, one value for each parameter. at: the pixels. got: (N, C). reach: float64 (N, C).
    wrong: bool (N,).
    """

    stage: Stage | Chain
    inputs: list[Any]
    name: str
    at: Pixels
    got: np.ndarray
    reach: np.ndarray
    wrong: np.ndarray

    def fit(self, values: Any) -> Fit:
        """The shares of the wrong and of the right pixels on which these values (N, C) are what was got."""
        with np.errstate(all="ignore"):
            apart = np.abs(np.asarray(values, np.float64) - self.got)
        return fit_of((apart <= self.reach).all(axis=1), self.wrong)

    @property
    def given(self) -> dict[str, Any]:
        """The inputs by the stage's own names."""
        return dict(zip(self.stage.parameters, self.inputs, strict=True))

    def with_inputs(self, changed: Mapping[str, Any], stage: Stage | Chain | None = None) -> np.ndarray:
        """What the stage, or another one, gives when inputs, by its own names, are others."""
        given, stage = {**self.given, **changed}, stage or self.stage
        results = stage.run([given[own] for own in stage.parameters])
        return stacked(results[stage.writes[self.own_name]])

    def thinned(self) -> "Sample":
        """Fewer of the pixels."""
        return self._each(lambda array: array[::EVERY])

    def repeated(self, times: int) -> "Sample":
        """All pixels, so many times one after the other."""
        return self._each(lambda array: np.concatenate([array] * times))

    def _each(self, change: Callable[[np.ndarray], np.ndarray]) -> "Sample":
        inputs = [_of_pixels(change, value) for value in self.inputs]
        at = change(self.at[0]), change(self.at[1])
        return Sample(self.stage, inputs, self.name, at, change(self.got), change(self.reach), change(self.wrong))

    @property
    def own_name(self) -> str:
        """The stage's own name for the buffer."""
        return next(own for own, name in self.stage.writes.items() if name == self.name)


def _of_pixels(change: Callable[[np.ndarray], np.ndarray], value: Any) -> Any:
    """An input whose arrays of pixels are changed; what all pixels share stays as it is."""
    if isinstance(value, Vector):
        return type(value)(*(_of_pixels(change, part) for part in value))
    return change(value) if isinstance(value, np.ndarray) else value


def fit_of(holds: np.ndarray, wrong: np.ndarray) -> Fit:
    """The shares of two kinds of pixels, bool (N,), at which something holds; 1 of the right ones where none is."""
    share = float(holds[wrong].mean()) if wrong.any() else 0.0
    return share, float(holds[~wrong].mean()) if not wrong.all() else 1.0


def sample_of(check: Check, drawn: DrawnPass, wrong: np.ndarray) -> Sample | None:
    """Half of the sample from the wrong pixels, half from the right ones, as far as there are any."""
    if check.stage not in {stage.name for stage in drawn.this_pass.stages}:
        return None
    at = _chosen(check, wrong)
    return _sampled(check, *exact_run(drawn, at, check.buffer), at, wrong)


def chain_sample_of(check: Check, drawn: DrawnPass, wrong: np.ndarray) -> Sample | None:
    """The same of the stage with those before it whose results were not dumped; None where there are none."""
    if sum(check.buffer in stage.writes.values() for stage in drawn.this_pass.stages) == 0:
        return None
    at = _chosen(check, wrong)
    chain, inputs = chain_of(drawn, check.buffer, at)
    return _sampled(check, chain, inputs, at, wrong) if chain.before else None


def _chosen(check: Check, wrong: np.ndarray) -> Pixels:
    """Row by row, of the wrong pixels and of the right ones a half each: all as often, or of many some."""
    sorts = [pixels for pixels in (np.argwhere(wrong), np.argwhere(check.where & ~wrong)) if len(pixels)]
    rows, columns = np.concatenate([pixels[one_of_each_run(len(pixels), SAMPLE // 2)] for pixels in sorts]).T
    return rows, columns


def _sampled(check: Check, stage: Stage | Chain, inputs: list[Any], at: Pixels, wrong: np.ndarray) -> Sample:
    got, reach = (np.atleast_3d(array)[at].astype(np.float64) for array in (check.got, check.reach))
    return Sample(stage, inputs, check.buffer, at, got, reach, wrong[at])
