"""Many photons, counted. Counts are integers and photons have numbers, so no bit depends on threads or on pauses."""

import json
import math
import operator
import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.errors.text_file import text_of
from sss_ref.errors.whole_file import whole_file
from sss_ref.errors.wording import told
from sss_ref.numerics.random_numbers import new_stream
from sss_ref.truth.counting import ORDERS, count_photons
from sss_ref.truth.photon import ABSORBED, Setup, Volume

FORMAT = "sss_ref tally 1"
BLOCK = 1 << 14  # photons that a thread walks between two looks at the clock
Progress = Callable[[int, int], None]  # photons walked, and wanted


@dataclass(frozen=True)
class Walk:
    """What is walked: all that decides the counts besides the number of photons."""

    volume: Volume
    setup: Setup
    radii: tuple[float, ...]  # mm, rising from above 0: the outer radii of the rings that are counted apart
    seed: int = 0

    def __post_init__(self) -> None:
        _check(self.volume, self.setup)


@dataclass(frozen=True, eq=False)
class Tally:
    """How many of the first `photons` photons became what.

    counts: int64 (3, 3, R + 1): reflected, transmitted, absorbed; scattered never, once, more often; the ring in which
    it happened, the last being all that lies beyond the largest radius.
    """

    of: Walk
    photons: int
    counts: NDArray[np.int64]

    def share(self, fate: int) -> float:
        """The share of the photons that became this (REFLECTED, TRANSMITTED, ABSORBED)."""
        return float(self.counts[fate].sum()) / self.photons

    def share_error(self, fate: int) -> float:
        """The standard error of `share`: sqrt(p * (1 - p) / n)."""
        share = self.share(fate)
        return math.sqrt(share * (1 - share) / self.photons)

    def more(self, photons: int, threads: int | None = None, on_progress: Progress | None = None) -> "Tally":
        """The tally with so many photons more: n and n more are the same bits as 2 * n at once.

        threads: how many share the work (None: one per processor). on_progress: told now and then how far it is.
        """
        ranges = [
            (start, min(start + BLOCK, self.photons + photons))
            for start in range(self.photons, self.photons + photons, BLOCK)
        ]
        counts = self.counts.copy()
        with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
            for (_, last), found in zip(ranges, pool.map(partial(_counted, self.of), ranges), strict=True):
                counts += found
                if on_progress:
                    on_progress(last - self.photons, photons)
        return replace(self, photons=self.photons + photons, counts=counts)

    def save(self, path: Path) -> None:
        """Write the tally into a file, from which `read_tally` goes on."""
        content = {"format": FORMAT, **_described(self.of), "photons": self.photons, "counts": self.counts.tolist()}
        with whole_file(path) as hidden:
            hidden.write_text(json.dumps(content) + "\n", encoding="utf-8")


def nothing_walked(of: Walk) -> Tally:
    """The tally before the first photon."""
    return Tally(of, 0, np.zeros((ABSORBED + 1, ORDERS, len(of.radii) + 1), np.int64))


def read_tally(path: Path, of: Walk) -> Tally:
    """The tally `of` a walk, saved at a path. Raises SceneError for another walk's, and for what is no tally."""
    try:
        content = json.loads(text_of(path, "a tally", SceneError))
        counts, photons = np.array(content["counts"]), operator.index(content["photons"])
        described = {key: content[key] for key in _described(of)}
        is_one = content["format"] == FORMAT and _are_counts(counts, nothing_walked(of).counts)
    except (ValueError, KeyError, TypeError, RecursionError):
        is_one = False
    if not is_one or counts.sum() != photons:
        raise SceneError(told(str(path), "a tally", "something else", "delete the file to walk again"))
    if described != json.loads(json.dumps(_described(of))):
        raise SceneError(told(str(path), "the tally of this walk", "another one's", "choose another file"))
    return Tally(of, photons, counts)


def _are_counts(counts: NDArray[Any], form: NDArray[np.int64]) -> bool:
    """Whether they are whole numbers of at least 0 in the form of a tally's."""
    return counts.dtype == form.dtype and counts.shape == form.shape and bool((counts >= 0).all())


def _described(of: Walk) -> dict[str, Any]:
    """A walk as JSON has it."""
    thickness = None if math.isinf(of.setup.thickness) else of.setup.thickness
    setup = {"thickness": thickness, "diffuse": of.setup.diffuse}
    return {"volume": of.volume._asdict(), "setup": setup, "radii": list(of.radii), "seed": of.seed}


def _check(volume: Volume, setup: Setup) -> None:
    """Raise SceneError for a walk that has no meaning, or no end."""
    for name, value, expected, right in _conditions(volume, setup):
        if not right:
            raise SceneError(told(name, expected, f"{value:g}", "correct the material or the slab"))


def _conditions(volume: Volume, setup: Setup) -> Iterable[tuple[str, float, str, bool]]:
    """Name, value, what is expected of it and whether it is so."""
    scattering, absorption, g, ior = volume
    ends = absorption > 0 or not math.isinf(setup.thickness)
    return (
        ("scattering", scattering, "a number per mm, 0 or more", 0 <= scattering < math.inf),
        ("absorption", absorption, "a number per mm, 0 or more", 0 <= absorption < math.inf),
        ("absorption", absorption, "more than 0 where the body has no end, or walks have none", ends),
        ("extinction", scattering + absorption, "more than 0", scattering + absorption > 0),
        ("anisotropy", g, "a number between -1 and 1", -1 < g < 1),
        ("ior", ior, "1 or more", 1 <= ior < math.inf),
        ("thickness", setup.thickness, "more than 0 mm", setup.thickness > 0),
    )


def _counted(of: Walk, photons: tuple[int, int]) -> NDArray[np.int64]:
    """The counts of photons first ... last - 1."""
    counts = nothing_walked(of).counts
    squares = np.square(np.array(of.radii, np.float64))
    count_photons(new_stream(of.seed), of.volume, of.setup, squares, photons, counts)
    return counts
