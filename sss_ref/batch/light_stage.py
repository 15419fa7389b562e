"""One light at a time, from directions all over a sphere, as a light stage takes its pictures (Debevec et al. 2000)."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from sss_ref.batch.draws import chances
from sss_ref.numerics.trigonometry import fifty_digits
from sss_ref.scene_file.quantities import NonNegative, Positive, Table, requiring

MOST = 10_000  # lights


class LightStage(Table):
    """The lights of a stage around the middle of the mesh, all white; each item has one of them."""

    count: Annotated[int, requiring(lambda n: 1 <= n <= MOST, f"a whole number from 1 to {MOST}")]
    """How many directions."""
    directions: Literal["fibonacci", "random"] = "fibonacci"
    """fibonacci: on a spiral, as evenly as can be. random: drawn by the sweep's seed, evenly over the sphere's area."""
    distance: Positive | None = None
    """From the middle of the mesh to a point light, scene units; without it the light is infinitely far away, its rays
    parallel."""
    intensity: NonNegative = 1.0
    """Of each light. It does not fade with the distance."""

    def lights(self, seed: int) -> list[list[dict[str, Any]]]:
        """What the key `lights` is in turn: an array of one table."""
        places = self._spiral() if self.directions == "fibonacci" else self._drawn(seed)
        type_of_light = {"type": "point", "distance": self.distance} if self.distance else {"type": "directional"}
        return [
            [{**type_of_light, "azimuth": azimuth, "elevation": _elevation(height), "intensity": self.intensity}]
            for azimuth, height in places
        ]

    def _spiral(self) -> Iterator[tuple[float, Any]]:
        """Azimuth, i * 180 * (3 - sqrt 5) degrees, and height, 1 - (2 i + 1) / count (Swinbank and Purser 2006)."""
        mp = fifty_digits()
        turn = 180 * (3 - mp.sqrt(5))
        for number in range(self.count):
            yield float(mp.fmod(number * turn, 360)), 1 - mp.mpf(2 * number + 1) / self.count

    def _drawn(self, seed: int) -> Iterator[tuple[float, Any]]:
        """Azimuth and height are uniform each: slices of a sphere of one thickness have one area (Archimedes)."""
        for number in range(self.count):
            draws = chances(seed, "olat", number)
            yield 360 * next(draws), 2 * next(draws) - 1


def _elevation(height: Any) -> float:
    """Degrees above the horizon of what is so high on the unit sphere, rounded once."""
    mp = fifty_digits()
    return float(mp.degrees(mp.asin(height)))
