"""Stages that a method also runs with other types than they are written with, bound as it binds them."""

from sss_ref.language import Texture, vec2
from sss_ref.passes.blur import scatter, scatter_inside, single_tap
from sss_ref.passes.irradiance import dilate
from sss_ref.passes.lengths import offset_length

PER_FRAGMENT = {"pixel_scale": "pixels_per_offset"}
BY_AXIS = {"pixel_scale": "texels_per_offset"}

RETYPED = {
    "scatter-at-each-pixel": scatter.bound(**PER_FRAGMENT),
    "single_tap-at-each-pixel": single_tap.bound(**PER_FRAGMENT),
    "scatter_inside-at-each-pixel": scatter_inside.bound(**PER_FRAGMENT),
    "scatter-of-two-axes": scatter.retyped(pixel_scale=vec2).bound(**BY_AXIS),
    "scatter_inside-of-two-axes": scatter_inside.retyped(pixel_scale=vec2).bound(**BY_AXIS),
    "offset_length-of-two-axes": offset_length.retyped(mm_per_pixel=vec2, pixels_per_offset=vec2).bound(
        mm_per_pixel="mm_per_texel"
    ),
    "dilate-of-two-axes": dilate.retyped(irradiance=Texture[vec2], irradiance_filled=vec2).bound(
        irradiance="texels_per_offset"
    ),
}
