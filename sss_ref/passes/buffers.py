"""Every buffer of both methods: its unit, and what stands where nothing is drawn. The stages say the rest.

A value that no buffer keeps is named after the buffer it would be, with a prefix that says why it is none.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Buffer:
    """A buffer's unit and space in words, and its background: a number, or the name of the uniform that gives it."""

    unit: str
    background: float | str = 0.0


BUFFERS = {
    "light_triangle": Buffer("triangle index in scene order", -1),
    "light_depth": Buffer("window depth of the light's view, 0 to 1", 1.0),
    "light_distance": Buffer("scene units from the light", "light_clear_distance"),
    "light_uv": Buffer("texture coordinates of what the light sees", -1.0),
    "irradiance_mask": Buffer("1 where the layout covers the texel"),
    "irradiance": Buffer("linear RGB"),
    "irradiance_filled": Buffer("linear RGB"),
    "irradiance_filled_mask": Buffer("1 where the widened layout covers the texel"),
    "scattered_irradiance": Buffer("linear RGB"),
    "triangle": Buffer("triangle index in scene order", -1),
    "depth": Buffer("window depth of the camera's view, 0 to 1", 1.0),
    "coverage": Buffer("1 where the model is drawn"),
    "position_world": Buffer("scene units, world space"),
    "normal_world": Buffer("unit vector, world space"),
    "uv": Buffer("texture coordinates, origin at the bottom left"),
    "albedo": Buffer("linear RGB"),
    "shadow_uv": Buffer("texture coordinates on the shadow map", -1.0),
    "shadow_valid": Buffer("1 where the shadow map knows the fragment"),
    "stored_distance": Buffer("scene units from the light"),
    "entry_point": Buffer("scene units, world space"),
    "thickness": Buffer("scene units along the light's ray"),
    "directly_lit": Buffer("1 where the light reaches the fragment"),
    "incident_light": Buffer("linear RGB"),
    "phong": Buffer("linear RGB"),
    "translucency": Buffer("factor"),
    "irradiance_uv": Buffer("texture coordinates on the irradiance map", -1.0),
    "irradiance_used": Buffer("linear RGB"),
    "gloss": Buffer("linear RGB"),
    "lit": Buffer("linear RGB"),
    "scattered": Buffer("linear RGB"),
    "image": Buffer("linear RGB", "background"),
    "tap": Buffer("linear RGB, one tap's share of the blur"),
}


OWN = Buffer("of a stage of your own")
TEXEL = "texel_"  # of the point that a texel of the irradiance map shows; without it, of the point a pixel shows
EXACT = "exact_"  # before a target of eight bits rounds it
PARTIAL = "partial_"  # of one light among several
PARTIAL_SUM = f"{PARTIAL}sum_"  # of the lights up to one


def is_listed(name: str) -> bool:
    """Whether a buffer is one of ours; those of a kind are numbered: tap_00, tap_01 ..., light_distance_1 ..."""
    return entry_of(name) in BUFFERS


def described(name: str) -> Buffer:
    """The entry of a buffer."""
    return BUFFERS.get(entry_of(name), OWN)


def entry_of(name: str) -> str:
    """The name without its prefixes and its number, as BUFFERS has it."""
    for prefix in (TEXEL, EXACT, PARTIAL_SUM, PARTIAL):
        name = name.removeprefix(prefix)
    return name.rstrip("0123456789").rstrip("_")


def background(name: str, uniforms: Mapping[str, Any]) -> Any:
    """What a buffer holds where nothing is drawn: a number, or the uniform that gives it (that of the same light)."""
    given = described(name).background
    number = name.removeprefix(name.rstrip("0123456789"))
    return uniforms.get(f"{given}_{number}", uniforms.get(given)) if isinstance(given, str) else given
