"""The dipole of Jensen, Marschner, Levoy and Hanrahan, "A Practical Model for Subsurface Light Transport" (2001).

Light is taken to scatter first at one depth, and to diffuse from there; a second, negative source above the face lets
the light vanish that leaves. Formulas of their section 2.1 for R, 2.4 for the reflectance.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sss_ref.truth.photon import Volume

FloatArray = NDArray[np.float64]


class Dipole(NamedTuple):
    """What the two sources of a material are."""

    albedo: float  # s' / (s' + a), with the reduced scattering s'
    fading: float  # sqrt(3 * a * (s' + a)), per mm
    border: float  # A = (1 + F) / (1 - F), 1 for a border that light does not notice
    depth: float  # of the real source, 1 / (s' + a), mm

    @property
    def height(self) -> float:
        """Of the virtual source above the face, depth * (1 + 4*A/3), mm."""
        return self.depth * (1 + 4 * self.border / 3)


def dipole(volume: Volume) -> Dipole:
    """The dipole of a volume; its anisotropy goes into the reduced scattering s * (1 - g)."""
    scattering, absorption, anisotropy, ior = volume
    reduced = scattering * (1 - anisotropy)
    extinction = reduced + absorption
    returned = internal_reflectance(ior)
    border = (1 + returned) / (1 - returned)
    return Dipole(reduced / extinction, math.sqrt(3 * absorption * extinction), border, 1 / extinction)


def internal_reflectance(ior: float) -> float:
    """F, the share of diffuse light that the face throws back: -1.44/n^2 + .71/n + .668 + .0636*n; 0 for n = 1."""
    return -1.440 / ior**2 + 0.710 / ior + 0.668 + 0.0636 * ior if ior > 1 else 0.0


def dipole_density(source: Dipole, radius: FloatArray) -> FloatArray:
    """R(r), per mm^2: b/(4 pi) * (z * (f*d + 1) * e^(-f*d)/d^3 of both sources), d the distance to a source."""

    def of(z: float) -> FloatArray:
        distance = np.sqrt(np.square(radius) + z * z)
        found: FloatArray = z * (source.fading * distance + 1) * np.exp(-source.fading * distance) / distance**3
        return found

    return source.albedo / (4 * math.pi) * (of(source.depth) + of(source.height))


def dipole_reflectance(source: Dipole) -> float:
    """All that leaves again: b/2 * (1 + e^(-4/3 * A * q)) * e^-q, q = f * depth."""
    q = source.fading * source.depth
    return source.albedo / 2 * (1 + math.exp(-4 / 3 * source.border * q)) * math.exp(-q)
