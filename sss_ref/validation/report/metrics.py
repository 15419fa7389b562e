"""What metrics of pictures say of the same buffers: SSIM and FLIP, to be read beside the verdicts. They decide nothing.

Both look at a picture as it is shown: in 8 bits, sRGB, cut off at 0 and 1.
"""

import json
import subprocess
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.pictures.channels import channel_names
from sss_ref.pictures.png_file import encoding_of
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.dumped import Buffers

PACKAGES = {"skimage": "scikit-image", "flip_evaluator": "flip-evaluator"}  # module -> its package
PROCESS = Path(__file__).with_name("flip_process.py")
TIME_LIMIT = 120  # seconds
LEAST_SIDE = 7  # pixels: the window of SSIM
Pair = tuple[np.ndarray, np.ndarray]  # the oracle's picture and the dump's, uint8 (H, W, 3)


@dataclass(frozen=True)
class Likeness:
    """A picture against that of the oracle. ssim: 1 for equal ones. flip: the mean error, 0 to 1, 0 for equal ones.

    note: why there are none, or what is left out.
    """

    buffer: str
    ssim: float | None = None
    flip: float | None = None
    note: str = ""

    def __str__(self) -> str:
        """As part of a sentence."""
        if self.ssim is None or self.flip is None:
            return f"{self.buffer}: {self.note}"
        return f"{self.buffer}: SSIM {self.ssim:.6f}, FLIP {self.flip:.6f}"


def likeness(oracle: Result, dumped: Buffers) -> Iterator[Likeness]:
    """What SSIM and FLIP say of every colour buffer. Raises DumpError where their packages are not installed.

    A picture that is not finite, or smaller than SSIM's window, is not handed to them: FLIP would end the process.
    """
    require_packages()
    pairs: dict[str, Pair] = {}
    encode = encoding_of(oracle.scene.settings)
    for name in (name for name in dumped if channel_names(name, oracle[name]) == ("R", "G", "B")):
        reason = _unfit(dumped[name])
        if reason:
            yield Likeness(name, note=reason)
        else:
            pairs[name] = encode(oracle[name]), encode(dumped[name])
    flips = _flip(pairs)
    for name, pair in pairs.items():
        yield Likeness(name, _ssim(*pair), flips[name])


def require_packages() -> None:
    """Raise DumpError unless the packages of both metrics are installed."""
    missing = [package for module, package in PACKAGES.items() if find_spec(module) is None]
    if missing:
        remedy = 'run pip install "sss_ref[metrics]"'
        raise DumpError(told("--metrics", f"the packages {', '.join(PACKAGES.values())}", "not all", remedy))


def _unfit(picture: np.ndarray) -> str:
    if not np.isfinite(picture).all():
        return "no metric takes NaN or infinity"
    small = min(picture.shape[:2]) < LEAST_SIDE
    return f"SSIM needs at least {LEAST_SIDE} x {LEAST_SIDE} pixels" if small else ""


def _ssim(ours: np.ndarray, theirs: np.ndarray) -> float:
    from skimage.metrics import structural_similarity

    return float(structural_similarity(ours, theirs, channel_axis=-1, data_range=255))


def _flip(pairs: Mapping[str, Pair]) -> dict[str, float]:
    """Name -> mean FLIP error. It runs in a process of its own, as it may end the one it runs in."""
    with TemporaryDirectory() as folder:
        pictures = Path(folder) / "pictures.npz"
        named = {f"{side}_{name}": each for name, pair in pairs.items() for side, each in zip("01", pair, strict=True)}
        np.savez(pictures, allow_pickle=False, **named)
        command = [sys.executable, "-P", str(PROCESS), str(pictures)]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT, check=True)
        except (subprocess.TimeoutExpired, subprocess.CalledProcessError) as error:
            raise DumpError(told("--metrics", "a number from FLIP", str(error), "leave --metrics out")) from None
    return json.loads(done.stdout)
