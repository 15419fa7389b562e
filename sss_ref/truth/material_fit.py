"""All that is fitted to a material, and the keys of a scene file that say so."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

from sss_ref.truth.gaussian_fit import GaussianFit, fitted_gaussians
from sss_ref.truth.kernel_fit import KernelFit, fitted_kernel
from sss_ref.truth.media import Volumes
from sss_ref.truth.searchlight import RadialProfile, searchlight
from sss_ref.truth.transmittance_fit import BASE, TransmittanceFit, fitted_transmittance

COLORS = ("red", "green", "blue")
FARTHEST = 0.99  # share of the light: where the kernel of method "separable" ends
DARKEST = 1e-9  # a colour that is divided by
FROM_BEHIND = {"combine": "transmit_wrapped", "wrap": 0.0}
"""How a slab's T joins the light: where the surface faces away, also for techniques that call it lit there. What goes
round the terminator the blur moves there; with a wrap it would be there twice."""
Law = Literal["ratio", "beer"]


@dataclass(frozen=True, eq=False)
class MaterialFit:
    """The walks through a material (red, green, blue), and what comes nearest to them."""

    volumes: Volumes  # per mm
    profiles: tuple[RadialProfile, ...]
    laws: tuple[TransmittanceFit, ...]
    kernel: KernelFit
    gaussians: GaussianFit

    @property
    def color(self) -> list[float]:
        """The reflectance of each channel."""
        return [profile.reflectance for profile in self.profiles]

    @property
    def nearer_law(self) -> Law:
        """The form of T whose worst channel is less wrong."""
        power, fading = (max(getattr(law, name) for law in self.laws) for name in ("worst", "fading_worst"))
        return "ratio" if power < fading else "beer"

    def keys(self, mm_per_unit: float, law: Law = "ratio") -> dict[str, Any]:
        """The tables of a scene file. law: the form of T."""
        return {
            "mm_per_unit": mm_per_unit,
            "mesh": {"color": self.color},
            "blur": {"unit": "mm", "mm_per_offset": self.kernel.mm_per_offset, "kernel": self.kernel.taps},
            "translucency": self.power_law(mm_per_unit) if law == "ratio" else self.fading_law(mm_per_unit),
            "diffusion": {
                "profile": self.gaussians.rows,
                "reach_mm": max(profile.quantile(FARTHEST) for profile in self.profiles),
                "albedo": self.color,
                "mean_free_path_mm": [1 / (volume.scattering + volume.absorption) for volume in self.volumes],
            },
        }

    def power_law(self, mm_per_unit: float) -> dict[str, Any]:
        """T holds the colour already, so scale is 1/color: the surface multiplies by it again."""
        return {
            "form": "ratio",
            **FROM_BEHIND,
            "x": BASE,
            "y": [law.y(mm_per_unit) for law in self.laws],
            "exponent": [law.exponent for law in self.laws],
            "d_min": [law.d_min / mm_per_unit for law in self.laws],
            "scale": [1 / max(color, DARKEST) for color in self.color],
        }

    def fading_law(self, mm_per_unit: float) -> dict[str, Any]:
        """The exponential beside it; its amplitude is in scale too."""
        return {
            "form": "beer",
            **FROM_BEHIND,
            "x": [law.fading * mm_per_unit for law in self.laws],
            "scale": [law.amplitude / max(color, DARKEST) for law, color in zip(self.laws, self.color, strict=True)],
        }


def fitted_material(
    volumes: Volumes,
    photons: int,
    threads: int | None = None,
    diffuse: bool = False,
    on_step: Callable[[str], None] | None = None,
) -> MaterialFit:
    """Walk through a half-space and slabs of each channel's volume, and fit to that.

    volumes: red, green and blue, per mm. photons: of each walk. threads: all processors where it is None.
    diffuse: whether light enters the half-space from all sides, as through the border of a traced scene, or straight
    down. on_step: told what is being done. Raises SceneError for what is no material.
    """
    tell = on_step or str
    profiles, laws = [], []
    for color, volume in zip(COLORS, volumes, strict=True):
        tell(f"walking: {color}")
        profiles.append(searchlight(volume, photons, threads=threads, diffuse=diffuse))
        laws.append(fitted_transmittance(volume, photons, threads))
    tell("fitting")
    return MaterialFit(volumes, tuple(profiles), tuple(laws), fitted_kernel(profiles), fitted_gaussians(profiles))
