"""Every buffer of both methods: its unit, and what stands where nothing is drawn. The stages say the rest.

A value that no buffer keeps is named after the buffer it would be; `language.names` says how.
"""

import re
from dataclasses import dataclass

from sss_ref.language.names import Name


@dataclass(frozen=True)
class Buffer:
    """A buffer of the methods.

    unit: with its space, in words. background: a number, or the name of the uniform that gives it. per_light: with
    several lights each has its own, with its number. in_parts: with several lights what each of them gives is handed on
    as a part, and summed.
    """

    unit: str
    background: float | str = 0.0
    per_light: bool = False
    in_parts: bool = False


BUFFERS = {
    "light_triangle": Buffer("triangle index in scene order", -1, per_light=True),
    "light_depth": Buffer("window depth of the light's view, 0 to 1", 1.0, per_light=True),
    "light_distance": Buffer("scene units from the light", "light_clear_distance", per_light=True),
    "light_uv": Buffer("texture coordinates of what the light sees", -1.0, per_light=True),
    "light_normal": Buffer("unit vector, world space", per_light=True),
    "irradiance_triangle": Buffer("triangle index in scene order", -1),
    "irradiance_mask": Buffer("1 where the layout covers the texel"),
    "mm_per_texel": Buffer("mm on the surface along the layout's two axes"),
    "texels_per_offset": Buffer("texels along the layout's two axes"),
    "texels_per_offset_filled": Buffer("texels along the layout's two axes"),
    "texels_per_offset_mask": Buffer("1 where the widened layout covers the texel"),
    "irradiance": Buffer("linear RGB", per_light=True),
    "irradiance_filled": Buffer("linear RGB", per_light=True),
    "irradiance_filled_mask": Buffer("1 where the widened layout covers the texel", per_light=True),
    **{f"spread_{each}": Buffer("linear RGB", per_light=True) for one in "abcdef" for each in (f"{one}_rows", one)},
    "scattered_irradiance": Buffer("linear RGB", per_light=True),
    "triangle": Buffer("triangle index in scene order", -1),
    "depth": Buffer("window depth of the camera's view, 0 to 1", 1.0),
    "coverage": Buffer("1 where the model is drawn"),
    "position_world": Buffer("scene units, world space"),
    "unmapped_normal_world": Buffer("unit vector, world space"),
    "normal_world": Buffer("unit vector, world space"),
    "uv": Buffer("texture coordinates, origin at the bottom left"),
    "mm_per_pixel": Buffer("mm across the line of sight"),
    "pixels_per_offset": Buffer("pixels"),
    "curvature": Buffer("per mm"),
    "albedo": Buffer("linear RGB"),
    "mapped_specular": Buffer("weight"),
    "shadow_uv": Buffer("texture coordinates on the shadow map", -1.0, per_light=True),
    "shadow_valid": Buffer("1 where the shadow map knows the fragment", per_light=True),
    "stored_distance": Buffer("scene units from the light", per_light=True),
    "inside_point": Buffer("scene units, world space", per_light=True),
    "inside_shadow_uv": Buffer("texture coordinates on the shadow map", -1.0, per_light=True),
    "inside_shadow_valid": Buffer("1 where the shadow map holds a surface before the point", per_light=True),
    "inside_stored_distance": Buffer("scene units from the light", per_light=True),
    "entry_point": Buffer("scene units, world space", per_light=True),
    "thickness": Buffer("scene units along the light's ray", per_light=True),
    "directly_lit": Buffer("1 where the light reaches the fragment", per_light=True),
    "light_visible": Buffer("share, 0 to 1, of the surface around that sees the light", per_light=True),
    "light_around": Buffer("linear RGB", per_light=True),
    "incident_light": Buffer("linear RGB", per_light=True),
    "phong": Buffer("linear RGB", per_light=True),
    "translucency": Buffer("factor", per_light=True),
    "irradiance_uv": Buffer("texture coordinates on the irradiance map", -1.0, per_light=True),
    "irradiance_used": Buffer("linear RGB", in_parts=True),
    "gloss": Buffer("linear RGB", in_parts=True),
    "lit": Buffer("linear RGB", in_parts=True),
    "way_to_inner": Buffer("mm along the line of sight"),
    "seen": Buffer("linear RGB"),
    "scattered_rows": Buffer("linear RGB"),
    "scattered": Buffer("linear RGB"),
    "image": Buffer("linear RGB", "background"),
    "tap": Buffer("linear RGB, one tap's share of the blur"),
}


OWN = Buffer("of a stage of your own")
TAP = re.compile(r"tap_\d+")  # one of the kernel; tap_count and tap_offset are uniforms


def is_listed(name: str) -> bool:
    """Whether a buffer is one of ours; those of a kind are numbered: tap_00, tap_01 ..., light_distance_1 ..."""
    return entry_of(name) in BUFFERS


def described(name: str) -> Buffer:
    """The entry of a buffer."""
    return BUFFERS.get(entry_of(name), OWN)


def entry_of(name: str) -> str:
    """The name that BUFFERS has it under."""
    base = Name.of(name).base
    return "tap" if TAP.fullmatch(base) else base
