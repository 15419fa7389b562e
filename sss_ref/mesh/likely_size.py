"""How large a mesh probably is, which hardly any file says: a guess for the scene file, to be mended by who knows."""

from dataclasses import dataclass

import numpy as np

from sss_ref.mesh.triangles import Mesh

LONGEST_MM = 250.0  # a head with its neck, the usual subject of subsurface scattering
THINNEST = 0.015  # d_min as a share of the longest side: that of preset robust on the shipped bust, 2 units high


@dataclass(frozen=True)
class LikelySize:
    """What the scene of a mesh wants to say of its unit, if its longest side is LONGEST_MM."""

    longest: float  # longest side of the bounding box, in the unit of the file
    mm_per_unit: float
    d_min: float  # smallest thickness that translucency is computed from, in the unit of the file

    @classmethod
    def of(cls, mesh: Mesh) -> "LikelySize":
        """The guess for a mesh as it is loaded, before the scene's scale."""
        longest = float(np.ptp(mesh.positions.astype(np.float64), axis=0).max())
        return cls(longest, three_digits(LONGEST_MM / longest), three_digits(THINNEST * longest))


def three_digits(number: float) -> float:
    """A number as one would type it."""
    return float(f"{number:.3g}")
