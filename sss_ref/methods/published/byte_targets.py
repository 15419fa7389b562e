"""Render targets of eight bits a channel: what is left of a value that is written to one and read again.

A stage of this file stands for the target itself, so that every interpreter computes the loss and none has to know of
it: 256 steps from 0 to 1, and everything beyond cut off. A light distance above 1 is 1.
"""

from typing import NamedTuple

from sss_ref.language import clamp, floor, function, stage, vec3


@function
def unorm8(value: float) -> float:
    """The nearest n/255, n = 0 ... 255, as float32."""
    return floor(clamp(value, 0.0, 1.0) * 255.0 + 0.5) / 255.0


class StoredColor(NamedTuple):
    """A colour as the target holds it."""

    stored_color: vec3  # each channel n/255


@stage(source="OpenGL, GL_RGB8")
def stored_rgb8(color: vec3) -> StoredColor:
    """A colour in a target of three unsigned normalised bytes."""
    return StoredColor(vec3(unorm8(color.x), unorm8(color.y), unorm8(color.z)))


class StoredValue(NamedTuple):
    """A number as the target holds it."""

    stored_value: float  # n/255


@stage(source="OpenGL, GL_RGB8, a number shown as brightness")
def stored_r8(value: float) -> StoredValue:
    """One channel of such a target."""
    return StoredValue(unorm8(value))
