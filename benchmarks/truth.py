"""Walks against what is known of them: published figures, and how far well-known approximations are off.

    python benchmarks/truth.py --photons 1000000

Every number of a walk has its standard error behind it.
"""

import argparse

import numpy as np

from sss_ref.truth.burley_fit import BurleyFit, burley_fit
from sss_ref.truth.chandrasekhar import half_space_reflectance
from sss_ref.truth.dipole import dipole, dipole_density, dipole_reflectance
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import Volume
from sss_ref.truth.searchlight import RadialProfile, searchlight
from sss_ref.truth.small_feature import energy_within, separable, strip_shares

CIRCLES = (2.0, 3.0, 5.0, 8.0, 12.0, 18.0, 25.0)  # mm, where a feature's energy is read
DISC = 1.5  # mm, radius of the feature
FARTHEST = 32.0  # mm: how far the study followed its photons
FINE, TAPS, EQUAL_SHARES = 300, 17, 4096


def main() -> None:
    """Walk and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--photons", type=int, default=1_000_000, help="of each walk")
    photons = parser.parse_args().photons
    print(f"{photons} photons a walk; value +- its standard error\n")
    exact(photons)
    skin(photons)
    for reflectance in (0.55, 0.85, 0.95):
        fit(reflectance, photons)


def exact(photons: int) -> None:
    """Half-spaces without a border against Chandrasekhar's solution."""
    print("isotropic half-space, beam straight down: walk, exact")
    for albedo in (0.2, 0.8, 0.98):
        profile = searchlight(Volume(albedo, 1 - albedo), photons)
        found = f"{profile.reflectance:.5f} +- {profile.reflectance_error:.5f}"
        print(f"  albedo {albedo:4}: {found}  {half_space_reflectance(albedo):.5f}", flush=True)


def skin(photons: int) -> None:
    """skin1 of Jensen et al. (2001), index 1.3: the dipole against the walk."""
    print("\nskin1, index 1.3: walk, dipole, dipole/walk - 1, dipole/walk of R(r) at .1 .15 .2 .25 mm")
    for name, volume in zip(("red", "green", "blue"), volumes("skin1"), strict=True):
        profile, source = searchlight(volume, photons), dipole(volume)
        walked, error, of_dipole = profile.reflectance, profile.reflectance_error, dipole_reflectance(source)
        near = [dipole_near(profile, radius) for radius in (0.1, 0.15, 0.2, 0.25)]
        off = f"{of_dipole / walked - 1:+7.1%} +- {error / walked:.1%}"
        print(f"  {name:5} {walked:.4f} +- {error:.4f}  {of_dipole:.4f}  {off}  {' '.join(near)}", flush=True)


def dipole_near(profile: RadialProfile, radius: float) -> str:
    """Dipole over walk in the rings between .02 mm to either side of a radius, with its standard error."""
    inside = (profile.radii[1:] > radius - 0.02) & (profile.radii[1:] <= radius + 0.02)
    rings = np.pi * np.diff(np.square(profile.radii))[inside]
    middles = ((profile.radii[1:] + profile.radii[:-1]) / 2)[inside]
    count = int(profile.counts[:-1][inside].sum())
    expected = (dipole_density(dipole(profile.tally.of.volume), middles) * rings).sum() * profile.tally.photons
    return f"{expected / count:.3f}+-{expected / count / np.sqrt(count):.3f}"


def fit(reflectance: float, photons: int) -> None:
    """Christensen and Burley's fit for a reflectance against a walk, mean free path 1 mm."""
    u = (1 - reflectance) / (1 + 2 * reflectance)  # van de Hulst: the medium that has this reflectance
    profile, fitted = searchlight(Volume(1 - u * u, u * u), photons), burley_fit(reflectance, 1.0)
    print(f"\nreflectance {reflectance} (walk {profile.reflectance:.4f} +- {profile.reflectance_error:.4f})")
    for share in (0.5, 0.75, 0.9):
        of_fit, walked, error = fitted.quantile(share), profile.quantile(share), profile.quantile_error(share)
        off = f"{walked / of_fit - 1:+.1%} +- {error / of_fit:.1%}"
        print(
            f"  {share:.0%} leave within {walked:.3f} +- {error:.3f} mm; by the fit {of_fit:.3f}: walk/fit - 1 = {off}"
        )
    support = fitted.quantile(0.995)
    print(
        f"  99.5 % support {support:.2f} mm holds {profile.within(support):.2%} +- {profile.within_error(support):.2%}"
    )
    misplaced(profile, fitted)


def misplaced(profile: RadialProfile, fitted: BurleyFit) -> None:
    """The largest share of a small disc's energy that kernels put inside or outside a circle against the walk."""
    middles = (profile.radii[1:] + profile.radii[:-1]) / 2
    shares = profile.counts[:-1] / profile.counts.sum()
    truth = energy_within(middles, shares, DISC, CIRCLES)
    near = middles < FARTHEST
    kernels = {
        "the walk's own profile, separable": separable(*fine_kernel(middles[near], shares[near])),
        "the fit, separable, 17 taps": separable(*few_taps(fitted)),
        "the fit, in rings": (radii_of(fitted), np.full(EQUAL_SHARES, 1 / EQUAL_SHARES)),
    }
    for name, (distances, weights) in kernels.items():
        worst = np.abs(energy_within(distances, weights, DISC, CIRCLES) - truth).max()
        print(f"  {name}: {worst:.4f} of a disc of {DISC} mm lies at a wrong radius", flush=True)


def radii_of(fitted: BurleyFit) -> np.ndarray:
    """The radii of rings of equal shares."""
    return np.array([fitted.quantile((k + 0.5) / EQUAL_SHARES) for k in range(EQUAL_SHARES)])


def fine_kernel(radii: np.ndarray, shares: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Offsets and weights of the profile's projection onto a line, as far as the study went; they sum to 1."""
    edges = np.linspace(0, FARTHEST, FINE + 1)
    half = np.diff(strip_shares(radii, shares, edges))
    offsets, weights = (edges[1:] + edges[:-1]) / 2, half / (2 * half.sum())
    return np.concatenate((-offsets[::-1], offsets)), np.concatenate((weights[::-1], weights))


def few_taps(fitted: BurleyFit) -> tuple[np.ndarray, np.ndarray]:
    """17 taps, denser in the middle (k^2), each with the strip's energy that is nearest to it."""
    steps = np.linspace(-1, 1, TAPS)
    offsets = np.sign(steps) * steps * steps * fitted.quantile(0.995)
    borders = np.concatenate((offsets[:1], (offsets[1:] + offsets[:-1]) / 2, offsets[-1:]))
    strips = strip_shares(radii_of(fitted), np.full(EQUAL_SHARES, 1 / EQUAL_SHARES), np.abs(borders))
    weights = np.diff(np.sign(borders) * strips)
    return offsets, weights / weights.sum()


if __name__ == "__main__":
    main()
