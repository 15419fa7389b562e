"""The [diffusion] table: how the methods beside the paper's two spread light in the body."""

from typing import Annotated

from pydantic import field_validator

from sss_ref.errors.wording import unmet
from sss_ref.scene_file.profiles import PROFILES, Gaussian, MaterialName
from sss_ref.scene_file.quantities import Positive, Table, requiring
from sss_ref.scene_file.scattering import Profile

MOST_TAPS = 255
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
