"""The [diffusion] table: how the methods beside the paper's two spread light in the body."""

from typing import Annotated

from pydantic import Field, field_validator

from sss_ref.errors.wording import unmet
from sss_ref.scene_file.profiles import PROFILES, Gaussian, MaterialName
from sss_ref.scene_file.quantities import Positive, Share, Table, requiring
from sss_ref.scene_file.scattering import Profile

MOST_TAPS = 255
Samples = Annotated[int, requiring(lambda n: 1 <= n <= MOST_TAPS, f"a whole number from 1 to {MOST_TAPS}")]
ChannelShares = Annotated[tuple[Share, Share, Share], Field(strict=False)]
ChannelLengths = Annotated[tuple[Positive, Positive, Positive], Field(strict=False)]
Taps = Annotated[int, requiring(lambda n: 3 <= n <= MOST_TAPS and n % 2 == 1, f"an odd number from 3 to {MOST_TAPS}")]


class Diffusion(Table):
    """[diffusion]: what the methods beside the paper's two are told of the body, in mm."""

    profile: Profile = "skin"
    """How light spreads: the name of a material, or rows [v, red, green, blue] of a sum of Gaussians of variance v in
    mm^2; the weights of each channel are divided by their sum."""
    reach_mm: Positive = 8.0
    """Millimetres from its centre to where the kernel of method "separable" ends."""
    taps: Taps = 25
    """Taps of each of the two blurs of method "separable"."""

    albedo: ChannelShares = (0.63, 0.44, 0.34)
    """Share of red, green and blue light that leaves the body again, of method "burley"; this is skin2 of Jensen et al.
    2001. The colour of the picture is mesh.color all the same."""
    mean_free_path_mm: ChannelLengths = (0.907, 0.602, 0.517)
    """Millimetres between two events of scattering or absorption for red, green and blue, 1/(a + s), of method
    "burley"."""
    samples: Samples = 64
    """Samples around each pixel of method "burley"."""

    sharpest_curvature: Positive = 0.5
    """Curvature per mm up to which the table of method "preintegrated" goes; what is bent more counts as this."""

    @property
    def scatter_distance(self) -> tuple[float, float, float]:
        """The d of each channel in mm, l/s with s = 1.85 - A + 7*|A - .8|^3 (Christensen and Burley)."""
        red, green, blue = map(_scatter_distance, self.albedo, self.mean_free_path_mm)
        return red, green, blue

    @property
    def gaussians(self) -> tuple[Gaussian, ...]:
        """The rows (variance, red, green, blue) of the profile, as they are given."""
        return PROFILES[self.profile] if isinstance(self.profile, str) else self.profile

    @field_validator("profile")
    @classmethod
    def _spreads_light(cls, profile: MaterialName | tuple[Gaussian, ...]) -> MaterialName | tuple[Gaussian, ...]:
        for channel in zip(*(PROFILES[profile] if isinstance(profile, str) else profile), strict=True):
            if min(channel) < 0 or max(channel) == 0:
                expected = "weights that are not negative, and some above 0 in each channel"
                raise unmet(expected, "change the rows", str(list(channel)))
        return profile


def _scatter_distance(albedo: float, mean_free_path: float) -> float:
    away = abs(albedo - 0.8)
    return mean_free_path / (1.85 - albedo + 7.0 * (away * away * away))
