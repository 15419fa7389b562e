"""The mean radiance of each pixel with its standard error, sample by sample."""

import math
import operator
import os
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.errors.text_file import check_regular
from sss_ref.errors.whole_file import whole_file
from sss_ref.errors.wording import told
from sss_ref.numerics.random_numbers import new_stream
from sss_ref.truth.eye_rays import Sums, gather_row
from sss_ref.truth.tracing import Tracing

FloatArray = NDArray[np.float64]
FORMAT = "sss_ref radiance 1"


@dataclass(frozen=True, eq=False)
class Radiance:
    """The first `samples` samples of every pixel, added up."""

    of: Tracing
    samples: int
    sums: Sums

    @property
    def mean(self) -> FloatArray:
        """Linear RGB (H, W, 3), row 0 at the bottom; 0 where every sample was lost."""
        return np.asarray(self.sums.total / np.maximum(self.sums.counted, 1))

    @property
    def error(self) -> FloatArray:
        """The standard error of `mean`: sqrt((mean of squares - squared mean) / (n - 1)); inf for one or none."""
        count = self.sums.counted
        spread = np.maximum(self.sums.square / np.maximum(count, 1) - np.square(self.mean), 0)
        with np.errstate(divide="ignore"):
            return np.asarray(np.where(count > 1, np.sqrt(spread / np.maximum(count - 1, 1)), math.inf))

    @property
    def lost(self) -> int:
        """The samples that slipped between two triangles and count nothing."""
        return self.samples * self.sums.counted.size - int(self.sums.counted.sum())

    def more(
        self,
        samples: int,
        threads: int | None = None,
        seconds: float = math.inf,
        on_progress: Callable[[int, int], None] | None = None,
    ) -> "Radiance":
        """So many samples more of every pixel, each added in order: n and n more are the same bits as 2 * n at once.

        threads: how many share the rows (None: one per processor). seconds: begin no sample of the picture after them.
        on_progress: told the samples that are done, and those wanted.
        """
        sums = Sums(*(array.copy() for array in self.sums))
        end, done = time.monotonic() + seconds, 0
        with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
            while done < samples and (done == 0 or time.monotonic() < end):
                first = self.samples + done
                list(pool.map(partial(_gather, self.of, (first, first + 1), sums), range(self.of.eye.height)))
                done += 1
                if on_progress:
                    on_progress(done, samples)
        return Radiance(self.of, self.samples + done, sums)

    def save(self, path: Path) -> None:
        """Write the sums into an .npz file, from which `read_radiance` goes on."""
        with whole_file(path) as hidden:
            np.savez(hidden, format=FORMAT, identity=self.of.identity, samples=self.samples, **self.sums._asdict())


def nothing_gathered(of: Tracing) -> Radiance:
    """The radiance `of` a tracing, no sample of which is taken yet."""
    shape = (of.eye.height, of.eye.width, 3)
    return Radiance(of, 0, Sums(np.zeros(shape), np.zeros(shape), np.zeros(shape, np.int64)))


def read_radiance(path: Path, of: Tracing) -> Radiance:
    """The samples `of` a tracing, saved at a path. Raises SceneError for another one's, and for what is none."""
    expected = "the sums of a tracing"
    check_regular(path, expected, SceneError)
    try:
        with path.open("rb") as file, np.load(file) as content:  # given a path, NumPy leaves a damaged file open
            found = {name: content[name] for name in content.files}
        samples, sums = operator.index(found["samples"]), Sums(*(found[name] for name in Sums._fields))
        is_one = str(found["format"]) == FORMAT and samples >= 0
        identity = str(found["identity"])
    except Exception:  # whatever a broken archive makes NumPy raise, a tokenizer's error too
        is_one = False
    if is_one and identity != of.identity:
        remedy = "choose another folder, or delete it to begin again"
        raise SceneError(told(str(path), "the sums of this scene, material and seed", "those of another", remedy))
    if not is_one or not all(map(_are_like, sums, nothing_gathered(of).sums)):
        raise SceneError(told(str(path), expected, "something else", "delete it to begin again"))
    return Radiance(of, samples, sums)


def _are_like(found: object, form: NDArray[Any]) -> bool:
    """Whether sums have type and shape of such ones, and are numbers of at least 0, which no sum of light is below.

    found: bytes where NumPy met something else than an array in the archive.
    """
    if not isinstance(found, np.ndarray) or (found.dtype, found.shape) != (form.dtype, form.shape):
        return False
    return bool((np.isfinite(found) & (found >= 0)).all())


def _gather(of: Tracing, samples: tuple[int, int], sums: Sums, row: int) -> None:
    gather_row(new_stream(of.seed), of.scenery, of.volumes_per_unit, of.eye, row, samples, sums)
