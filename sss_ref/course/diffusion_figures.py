"""How the lessons on diffusion draw: ways of photons, profiles, kernels as stairs, and techniques in a row."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from sss_ref.course.figures import AMBER, BLUE, CHANNELS, FAINT, INK, NO_VALUE, RED, TEAL, row
from sss_ref.truth.searchlight import RadialProfile
from sss_ref.truth.transmittance_fit import TransmittanceFit

FloatArray = NDArray[np.float64]
TOGETHER = 16  # rings of a walk that are drawn as one, so that the noise does not hide the curve


def paths(axes: Axes, ways: Sequence[FloatArray], reach: float) -> int:
    """Ways of photons (N, 3) from the side, mm, z down, and the beam that they came by; how many end above the skin.

    reach: how far down and to either side is shown, mm.
    """
    axes.axhspan(0, reach, color="#f6e7df")
    for way in ways:
        leaves = way[-1, 2] < 0
        axes.plot(way[:, 0], way[:, 2], color=AMBER if leaves else FAINT, linewidth=0.8, alpha=0.8)
        if not leaves:
            axes.plot(way[-1, 0], way[-1, 2], ".", color=INK, markersize=4)
    axes.annotate("", (0, 0), (0, -reach / 4), arrowprops={"arrowstyle": "-|>", "color": BLUE, "linewidth": 2})
    axes.set(xlim=(-reach, reach), ylim=(reach, -reach / 4), aspect="equal", xlabel="mm", ylabel="mm deep")
    return sum(way[-1, 2] < 0 for way in ways)


def ringed(profile: RadialProfile) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Middles (R,), mm, of broader rings of a profile, R(r) there, per mm^2, and its standard error."""
    edges = profile.radii[::TOGETHER]
    counts = profile.counts[:-1].reshape(-1, TOGETHER).sum(axis=1)
    unit = profile.tally.photons * np.pi * np.diff(np.square(edges))
    return (edges[1:] + edges[:-1]) / 2, counts / unit, np.sqrt(counts) / unit


def profile(axes: Axes, walked: RadialProfile, color: str, name: str) -> None:
    """R(r) with a band of two standard errors to either side, over r in mm, on a scale of powers of ten."""
    radius, density, error = ringed(walked)
    axes.fill_between(radius, np.maximum(density - 2 * error, 1e-12), density + 2 * error, color=color, alpha=0.2, lw=0)
    axes.plot(radius, density, color=color, label=name)
    axes.set(yscale="log", xlabel="$r$, mm from the beam", ylabel="$R$, share per mm²")
    axes.legend()


def stairs(axes: Axes, offsets: FloatArray, weights: FloatArray, color: str) -> None:
    """The share of a kernel within each radius: it rises at the distance of every tap (T,), mm, by its weight (T,)."""
    order = np.argsort(offsets)
    radius = np.concatenate([[0.0], offsets[order], [2 * offsets.max() + 1]])
    share = np.concatenate([[0.0], np.cumsum(weights[order]) / weights.sum(), [1.0]])
    axes.step(radius, share, where="post", color=color, linewidth=1.3)


def transmittance(axes: Axes, laws: Sequence[TransmittanceFit], lines: Sequence[FloatArray], title: str) -> None:
    """What slabs let through, red, green and blue, as points with two standard errors, and a line for each channel.

    lines: a share for each of a law's thicknesses.
    """
    for color, name, law, line in zip(CHANNELS, ("red", "green", "blue"), laws, lines, strict=True):
        axes.errorbar(law.thickness, law.share, 2 * law.error, fmt=".", color=color, label=name)
        axes.plot(law.thickness, line, color=color, linewidth=1.2)
    axes.set(title=title, yscale="log", xlabel="thickness $d$, mm", ylabel="$T$")
    axes.legend()


def bars(rated: Mapping[str, float], title: str, unit: str, noise: float = 0.0) -> None:
    """A number for each name, the first on top; up to `noise` it is the truth's own."""
    _, (axes,) = row(1, 0.32 * len(rated) + 0.9, 6.6)
    axes.barh([*rated], [*rated.values()], 0.65, color=TEAL)
    axes.axvspan(0, noise, color=NO_VALUE, alpha=0.8)
    if noise:
        axes.axvline(noise, color=RED, linewidth=1, label="noise of the truth")
        axes.legend()
    axes.set(title=title, xlabel=unit)
    axes.invert_yaxis()
