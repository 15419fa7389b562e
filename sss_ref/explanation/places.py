"""Which texel of each target a pixel of the image looks at."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from sss_ref.language.names import Name
from sss_ref.language.pipeline import Pass
from sss_ref.language.sampling import nearest_texel
from sss_ref.language.types import ivec2, vec2


@dataclass(frozen=True)
class Place:
    """A pixel of a pass's target, and why it is looked at. pixel: (column, row), row 0 at the bottom; None: none is."""

    pixel: tuple[int, int] | None
    reason: str


def place_of(
    this_pass: Pass, size: tuple[int, int], buffers: Mapping[str, np.ndarray], pixel: tuple[int, int]
) -> Place:
    """Where a pass with a target of this size (width, height) is to be looked at, for a pixel of the image."""
    if this_pass.target == "camera":
        return Place(pixel, "the pixel itself")
    drawn = Name.of(this_pass.name)
    shadow_uv, shadow_valid, looked_up = (
        str(replace(drawn, base=base)) for base in ("shadow_uv", "shadow_valid", "irradiance_uv")
    )
    if this_pass.target == "shadow_map":
        if shadow_uv not in buffers:
            return Place(None, "looked up at the vertices, see there")
        return _texel(shadow_uv, size, buffers, pixel, hit=bool(buffers[shadow_valid][pixel[::-1]]))
    name = looked_up if looked_up in buffers else "uv"
    return _texel(name, size, buffers, pixel, hit=bool(buffers["coverage"][pixel[::-1]]))


def _texel(
    name: str, size: tuple[int, int], buffers: Mapping[str, np.ndarray], pixel: tuple[int, int], hit: bool
) -> Place:
    """The texel in which a buffer's texture coordinates lie; hit: whether the fragment reads one at all."""
    if not hit:
        return Place(None, f"the fragment reads no texel: {name} names none")
    texel = nearest_texel(ivec2(*size), vec2(*buffers[name][pixel[::-1]]))
    return Place((int(texel.x), int(texel.y)), f"the texel that holds {name}")
