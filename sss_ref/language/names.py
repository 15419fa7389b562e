"""The names of buffers, registers, uniforms and passes: what they are of, in one place.

A name is a base, such as `thickness`, and says besides of which light it is, of which body, where it was computed, and
which share of the whole it is: `texel_thickness_2`, `partial_sum_lit_2`, `exact_image`, `shadow_map_1`, `inner_lit`.
"""

import re
from dataclasses import dataclass, replace

INNER = "inner"  # body: the one that is seen through the mesh; without it, the mesh
TEXEL = "texel"  # site: the point that a texel of the irradiance map shows; without it, the point that a pixel shows
EXACT = "exact"  # share: before a target of eight bits rounds it
PARTIAL = "partial"  # share: of one light among several
PARTIAL_SUM = "partial_sum"  # share: of the lights up to one

FORM = re.compile(
    rf"(?:(?P<body>{INNER})_)?(?:(?P<site>{TEXEL})_)?(?:(?P<share>{EXACT}|{PARTIAL_SUM}|{PARTIAL})_)?"
    r"(?P<base>tap_\d\d|.+?)(?:_(?P<light>[1-9]\d*))?"
)


def tap_name(number: int) -> str:
    """What belongs to a single tap of the blur, by its number from 0: tap_07."""
    return f"tap_{number:02}"


@dataclass(frozen=True)
class Name:
    """A name taken apart; `str` puts it together again.

    light: the number of a light, from 1, or 0 where there is only one, or where it is of all. body, site, share: as
    above, or "". A tap's number is part of its base: tap_07.
    """

    base: str
    light: int = 0
    site: str = ""
    share: str = ""
    body: str = ""

    @classmethod
    def of(cls, text: str) -> "Name":
        """The parts of a name."""
        found = FORM.fullmatch(text)
        if not found:
            return cls(text)
        given = {part: found[part] or "" for part in ("site", "share", "body")}
        return cls(found["base"], int(found["light"] or 0), **given)

    def __str__(self) -> str:
        """The name as stages, files and reports have it."""
        number = str(self.light) if self.light else ""
        return "_".join(part for part in (self.body, self.site, self.share, self.base, number) if part)

    @property
    def is_register(self) -> bool:
        """Whether it stands for a value on the way to a buffer, which no target keeps."""
        return bool(self.site or self.share)

    def at(self, site: str) -> "Name":
        """The same quantity, computed elsewhere."""
        return replace(self, site=site)

    def of_light(self, light: int) -> "Name":
        """The same quantity of another light."""
        return replace(self, light=light)

    def of_body(self, body: str) -> "Name":
        """The same quantity of another body."""
        return replace(self, body=body)

    def as_share(self, share: str) -> "Name":
        """A share of the same quantity."""
        return replace(self, share=share)
