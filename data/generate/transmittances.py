"""Fit the sums of Gaussians in sss_ref/scene_file/profiles.py to the media there: prints the rows.

The fit is no part of the rules: its rows are. It is to what `transmitted` says of a slab, from half a millimetre on,
where eight terms stay within two per cent; below, the diffusion approximation says nothing.
"""

import math

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from sss_ref.scene_file.kernels import HBH09
from sss_ref.scene_file.profiles import MEDIA, Medium

TERMS = 8
THICKNESSES = np.geomspace(0.5, 300.0, 300)  # mm
FLOOR = 0.01  # of T: what is darker counts less


def main() -> None:
    """Print the rows of every medium, and what its kernel and its colour should be."""
    for name, medium in MEDIA.items():
        print(f"{name}: reflects {[round(reflected(medium, k), 3) for k in range(3)]}, kernel {kernel(medium)}")
        for variance, *weights in fitted(medium):
            print(f"    ({variance:.4g}, {', '.join(f'{weight:.4f}' for weight in weights)}),")


def boundary(ior: float) -> float:
    """A = (1 + F)/(1 - F), F the diffuse Fresnel reflectance inside; by the fit that Jensen et al. (2001) use."""
    inside = -1.440 / ior**2 + 0.710 / ior + 0.668 + 0.0636 * ior
    return (1 + inside) / (1 - inside)


def lengths(medium: Medium, channel: int) -> tuple[float, float, float]:
    """In mm: where light first scatters, where its density would be 0 outside, and the length it fades by 1/e on."""
    scattering, absorption = medium.scattering[channel], medium.absorption[channel]
    extinction = scattering + absorption
    return 1 / extinction, 2 * boundary(medium.ior) / (3 * extinction), 1 / math.sqrt(3 * absorption * extinction)


def reflected(medium: Medium, channel: int) -> float:
    """The diffuse reflectance of a thick body."""
    first, outside, fading = lengths(medium, channel)
    albedo = medium.scattering[channel] * first
    return albedo / 2 * (1 + math.exp(-2 * outside / fading)) * math.exp(-first / fading)


def transmitted(medium: Medium, channel: int, thickness: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of the light that comes through a slab: a plane source between boundaries where the density is 0."""
    first, outside, fading = lengths(medium, channel)
    albedo = medium.scattering[channel] * first
    entered = math.sinh((first + outside) / fading) * math.cosh(outside / fading)
    return albedo * entered / np.sinh((thickness + 2 * outside) / fading)


def fitted(medium: Medium) -> NDArray[np.float64]:
    """Rows (variance in mm^2, red, green, blue): the geometric series of variances that fits best."""
    wanted = [transmitted(medium, channel, THICKNESSES) for channel in range(3)]
    tried = [
        (np.geomspace(least, most, TERMS), wanted)
        for least in np.geomspace(0.1, 2, 12)
        for most in np.geomspace(50, 2e4, 20)
    ]
    return min((weighted(*each) for each in tried), key=lambda found: found[0])[1]


def weighted(variances: NDArray[np.float64], wanted: list[NDArray[np.float64]]) -> tuple[float, NDArray[np.float64]]:
    """The largest relative error with these variances, and the rows."""
    terms = np.exp(-(THICKNESSES[:, None] ** 2) / variances)
    weights = [nnls(terms / (each[:, None] + FLOOR), each / (each + FLOOR), maxiter=1000)[0] for each in wanted]
    errors = [np.abs(terms @ w - each) / (each + FLOOR) for w, each in zip(weights, wanted, strict=True)]
    return float(np.max(errors)), np.column_stack([variances, *weights])


def kernel(medium: Medium) -> tuple[float, list[float]]:
    """mm_per_offset, and of each channel the share of hbh09's red: so that light goes as far as by the dipole."""
    taps = np.array(HBH09)
    radius = np.hypot(taps[:, 0], taps[:, 1])
    widest, narrowest = (float((radius * taps[:, k]).sum() / taps[:, k].sum()) for k in (2, 4))
    distances = [mean_distance(medium, channel) for channel in range(3)]
    mm = max(distances) / widest
    return round(mm, 2), [round((each / mm - narrowest) / (widest - narrowest), 2) for each in distances]


def mean_distance(medium: Medium, channel: int) -> float:
    """How far from where it entered light leaves a thick body on average, mm: the dipole of Jensen et al. (2001)."""
    first, outside, fading = lengths(medium, channel)
    radius = np.geomspace(1e-3, 1e3, 20000)
    density = np.zeros_like(radius)
    for depth in (first, first + 2 * outside):
        distance = np.hypot(radius, depth)
        density += depth * (distance / fading + 1) * np.exp(-distance / fading) / distance**3
    return float(np.trapezoid(density * radius**2, radius) / np.trapezoid(density * radius, radius))


if __name__ == "__main__":
    main()
