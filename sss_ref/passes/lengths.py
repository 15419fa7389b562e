"""How long a millimetre is: in pixels of the picture, in texels of the layout. A blur in mm has its offsets from here.

A blur in pixels softens a face more the smaller its picture is. In skin light spreads over millimetres, whatever the
picture's size and however near the camera.
"""

from typing import NamedTuple

from sss_ref.language import Array, constant, mat4, max, min, stage, vec2, vec3, vec4

SHORTEST = constant(1e-30)  # mm: where nothing is drawn the length is 0
MOST_PIXELS = constant(4096.0)  # an offset of one, however near the surface is: a tap's place stays an int


class PixelLength(NamedTuple):
    """What a pixel of the picture spans at the surface."""

    mm_per_pixel: float  # mm across the line of sight


@stage(source="the projection's scale at the fragment's depth")
def pixel_length(
    position_world: vec3, camera_clip_from_world: mat4, camera_pixel_size: float, mm_per_unit: float
) -> PixelLength:
    """w * (height of a pixel at w = 1): in perspective w is the depth along the line of sight."""
    clip = camera_clip_from_world * vec4(position_world, 1.0)
    return PixelLength((clip.w * camera_pixel_size) * mm_per_unit)


class TexelLength(NamedTuple):
    """What a texel of the layout spans on the surface."""

    mm_per_texel: vec2  # mm along the layout's two axes


@stage(source="d'Eon, Luebke and Enderton 2007: stretch maps")
def texel_length(triangle: int, triangle_stretch: Array[vec2], mm_per_unit: float) -> TexelLength:
    """The stretch of the triangle: from its corners to their UVs it is the same all over."""
    return TexelLength(triangle_stretch[triangle] * mm_per_unit)


class OffsetLength(NamedTuple):
    """What stands in the place of `pixel_scale` where the kernel is in mm."""

    pixels_per_offset: float


@stage(source="a kernel in mm")
def offset_length(mm_per_pixel: float, mm_per_offset: float) -> OffsetLength:
    """How many pixels an offset of 1 is at this fragment."""
    return OffsetLength(min(mm_per_offset / max(mm_per_pixel, SHORTEST), MOST_PIXELS))
