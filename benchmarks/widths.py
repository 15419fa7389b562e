"""How wide the intervals are that `validate` accepts, stage by stage, each given the oracle's own buffers.

    python benchmarks/widths.py [SCENE ...] [--size N] [--profile NAME_OR_FILE]

Per float buffer, of high - low over all values that no choice makes one of several: the 50th, 95th and 99th percentile
in ULP of the value; the 95th in ULP of the larger of the value and 2^-8 of the buffer's largest, which a value near 0
does not blow up; the 95th of the stage alone, without the spread of the varyings and of what was not dumped. Of every
buffer the shares of fragments with an undecided condition, with an undecided texel, and without bounds.
"""

import argparse
from collections import defaultdict
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

import sss_ref
from sss_ref.interpret.arrays import in_chunks
from sss_ref.interpret.intervals.enclosing import CONDITION, WHICH_TEXEL
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language.types import components
from sss_ref.rendering.result import Result
from sss_ref.scene_file.shipped import scene_names
from sss_ref.validation.accept.acceptance import accepted
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.walk import StageRun, walk
from sss_ref.validation.profile_file import profile_of

TARGETS = ("camera", "shadow_map", "irradiance_map")
SHARES = ("p50", "p95", "p99", "of buffer", "alone", "choice", "texel", "unbounded")


class Widths(NamedTuple):
    """Some fragments of a buffer: what it holds, how much else it might, in the stage alone, and why."""

    value: np.ndarray
    width: np.ndarray
    alone: np.ndarray
    doubt: np.ndarray


def main() -> None:
    """Print one table per scene."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", default=scene_names())
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--profile", type=profile_of, default="vulkan", help="a name or a TOML file")
    given = parser.parse_args()
    for name in given.scenes:
        print(f"\n{name:24} {' '.join(f'{share:>9}' for share in SHARES)}")
        small = {f"{target}.{side}": given.size for target in TARGETS for side in ("width", "height")}
        oracle = sss_ref.render(sss_ref.load_scene(name, **small))
        for buffer, all_chunks in widths(oracle, given.profile).items():
            print(f"{buffer:24} {row(Widths(*map(np.concatenate, zip(*all_chunks, strict=True))))}", flush=True)


def widths(oracle: Result, profile: Profile) -> dict[str, list[Widths]]:
    """Of every buffer, chunk by chunk."""
    found = defaultdict(list)
    for run in runs(oracle, profile):
        count = len(next(iter(run.written.values())).doubt)
        given = {own: known.exact for own, known in run.read.items()}
        alone = accepted(run.stage, given, profile, count)
        for name, known in run.written.items():
            exact = np.broadcast_to(known.columns, (count, known.columns.shape[1]))
            found[name].append(Widths(exact, width_of(known.bounds), width_of(alone[name][0]), known.doubt))
    return found


def runs(oracle: Result, profile: Profile) -> Iterator[StageRun]:
    """Every stage of the scene on every chunk of its fragments, given what the oracle has."""
    case = Case(oracle, Drawing(oracle.buffers), profile)
    for this_pass in oracle.scene.method.passes:
        if not this_pass.on_demand and not this_pass.fed_back:
            drawn = case.drawn(this_pass)
            for at in in_chunks(drawn.work.fragments.where):
                yield from walk(drawn, at)


def width_of(value: Any) -> np.ndarray:
    """The widths of intervals, float64 (N, C)."""
    with np.errstate(invalid="ignore"):
        return np.stack([part.high.astype(np.float64) - part.low for part in components(value)], axis=-1)


def row(buffer: Widths) -> str:
    """One line of the table."""
    value, width, alone, doubt = buffer
    causes = (doubt & CONDITION > 0, doubt & WHICH_TEXEL > 0, ~np.isfinite(width).all(axis=-1))
    shares = " ".join(f"{cause.mean():9.2%}" for cause in causes)
    certain = doubt == 0
    if value.dtype != np.float32 or not certain.any():
        return f"{'':49} {shares}"
    size = np.abs(value)
    ulp, of_buffer = np.spacing(size), np.spacing(np.maximum(size, size.max() * np.float32(2**-8)))
    numbers = [*np.percentile((width / ulp)[certain], (50, 95, 99))]
    numbers += [np.percentile((one / unit)[certain], 95) for one, unit in ((width, of_buffer), (alone, ulp))]
    return " ".join([*(f"{each:9.4g}" for each in numbers), shares])


if __name__ == "__main__":
    main()
