"""How light goes through the body: the [translucency] table, from behind, and the [blur] table, sideways."""

import math
from typing import Annotated, Literal

from pydantic import Discriminator, Field, Tag, ValidationInfo, field_validator

from sss_ref.errors.wording import unmet
from sss_ref.scene_file.kernels import KERNELS, Tap, channel_sums, normalized
from sss_ref.scene_file.profiles import PROFILES, Gaussian, MaterialName
from sss_ref.scene_file.quantities import (
    LARGEST_SIZE,
    GaussianRow,
    NonNegative,
    Number,
    OneOrThree,
    Positive,
    PositiveOrZero,
    Share,
    Table,
    TapRow,
    requiring,
)

LONGEST_PROFILE = 64  # rows
KernelName = Annotated[Literal["table1", "hbh09", "schoenberger"], Tag("name")]
KernelTable = Annotated[tuple[TapRow, ...], Field(strict=False), requiring(len, "at least one row"), Tag("table")]
Kernel = Annotated[KernelName | KernelTable, Discriminator(lambda value: "name" if isinstance(value, str) else "table")]
Profile = Annotated[
    Annotated[MaterialName, Tag("name")]
    | Annotated[
        tuple[GaussianRow, ...],
        Field(strict=False),
        requiring(lambda rows: 1 <= len(rows) <= LONGEST_PROFILE, f"1 to {LONGEST_PROFILE} rows"),
        Tag("table"),
    ],
    Discriminator(lambda value: "name" if isinstance(value, str) else "table"),
]


class TranslucencySettings(Table):
    """[translucency]: the light T that comes through a thickness d, and how it joins reflected light (paper 3.2).

    x, y, exponent, scale and d_min take one number, or three, for red, green and blue; T then has three channels.
    """

    form: Literal["ratio", "exponent", "beer", "gaussians"]
    """ratio: x^y / d^exponent; exponent: x^(y / d^exponent); beer: exp(-x * d); gaussians: for each channel the sum of
    w * exp(-d^2 / v), d in mm."""
    combine: Literal["multiply", "add", "transmit", "transmit_wrapped"]
    """multiply: the reflected light is scaled by T; add: T is added, less where the light is faced; transmit: T is
    added where the surface faces away; transmit_wrapped: beyond that, as far as wrap says, lit or not."""
    wrap: Share = 0.3
    """How far light from behind goes round to the lit side with combine "transmit_wrapped": up to N.L = wrap
    (Jimenez et al. 2010)."""
    x: OneOrThree[Positive]
    """Base (beer: extinction per scene unit)."""
    y: OneOrThree[Number]
    """Power of the base."""
    exponent: OneOrThree[Number] = 0.6
    """Power of the thickness."""
    scale: OneOrThree[NonNegative]
    """Factor on T where it is added."""
    d_min: OneOrThree[PositiveOrZero]
    """Smallest thickness that T is computed from, scene units."""
    gaussians: Profile = "skin"
    """Of form gaussians: the name of a material, or rows [v, red, green, blue]: v in mm^2, and w for each channel."""

    @property
    def by_channel(self) -> bool:
        """Whether T has three channels: with form gaussians, and where one of the numbers is three."""
        numbers = (self.x, self.y, self.exponent, self.scale, self.d_min)
        return self.form == "gaussians" or any(isinstance(number, tuple) for number in numbers)

    @property
    def terms(self) -> tuple[Gaussian, ...]:
        """The rows (variance, red, green, blue) of form gaussians."""
        return PROFILES[self.gaussians] if isinstance(self.gaussians, str) else self.gaussians


class Blur(Table):
    """[blur]: the screen-space diffusion (paper 3.2)."""

    kernel: Kernel
    """The name of a published kernel, or rows [X, Y, red, green, blue] with X, Y in pixels."""
    unit: Literal["pixel", "mm"] = "pixel"
    """Of the kernel's offsets X and Y: pixels or texels (paper 3.2), or millimetres on the surface. Preset
    robust has mm, and follow_surface, where the scene gives mm_per_unit and no pixel_scale."""
    pixel_scale: NonNegative
    """Pixels or texels that an offset of 1 is, with unit "pixel"."""
    mm_per_offset: Positive = 1.2
    """Millimetres that an offset of 1 is, with unit "mm"; 1.2 fits hbh09 to measured skin."""
    follow_surface: bool = False
    """Whether taps of mask "output" or "taps" leave out what lies farther before or behind than the kernel reaches;
    on the picture, with unit "mm"."""
    mask: Literal["none", "output", "taps"]
    """Where it acts: everywhere, on covered pixels, or on covered pixels from covered taps only."""
    normalize: bool = False
    """Whether each channel's weights are divided by their sum."""

    @property
    def taps(self) -> tuple[Tap, ...]:
        """The rows (X, Y, red, green, blue) in use: X, Y in pixels before pixel_scale; weights normalised if asked."""
        rows = _rows(self.kernel)
        return normalized(rows) if self.normalize else rows

    @property
    def reach(self) -> float:
        """The length of the longest offset."""
        return max(math.sqrt(x * x + y * y) for x, y, *_ in self.taps)

    @field_validator("pixel_scale")
    @classmethod
    def _within_reach(cls, pixel_scale: float, info: ValidationInfo) -> float:
        reach = max(max(abs(x), abs(y)) for x, y, *_ in _rows(info.data.get("kernel", "table1")))
        scale = pixel_scale if info.data.get("unit") == "pixel" else 1.0
        if reach * scale > LARGEST_SIZE:
            raise unmet(f"taps within {LARGEST_SIZE} pixels (the farthest is at {reach:g})", "choose a smaller scale")
        return pixel_scale

    @field_validator("follow_surface")
    @classmethod
    def _knows_lengths(cls, follow_surface: bool, info: ValidationInfo) -> bool:
        if follow_surface and info.data.get("unit") == "pixel":
            raise unmet('false with blur.unit = "pixel"', 'set blur.unit = "mm"')
        return follow_surface

    @field_validator("normalize")
    @classmethod
    def _has_weight(cls, normalize: bool, info: ValidationInfo) -> bool:
        if normalize and not all(channel_sums(_rows(info.data.get("kernel", "table1")))):
            raise unmet("a kernel whose channels have sums other than 0", "set it to false or change the kernel")
        return normalize


def _rows(kernel: str | tuple[Tap, ...]) -> tuple[Tap, ...]:
    return KERNELS[kernel] if isinstance(kernel, str) else kernel
