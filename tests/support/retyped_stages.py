"""Stages that a method also runs with other types than they are written with, bound as it binds them."""

from sss_ref.language import Texture, vec2, vec3
from sss_ref.methods.published.printed_stages import image_sqrt_add, translucency_unclamped
from sss_ref.methods.shared import BY_CHANNEL
from sss_ref.methods.stages import all_stages
from sss_ref.passes.blur import scatter, scatter_inside, single_tap
from sss_ref.passes.irradiance import dilate
from sss_ref.passes.lengths import offset_length
from sss_ref.passes.soft_shadow import lit_multiply_soft, lit_transmit_soft, lit_transmit_wrapped_soft
from sss_ref.passes.texture_image import irradiance_added, irradiance_replaced
from sss_ref.passes.translucency import (
    lit_add,
    lit_multiply,
    lit_transmit,
    translucency_beer,
    translucency_exponent,
    translucency_ratio,
)
from sss_ref.passes.transmittance import (
    irradiance_added_wrapped,
    lit_transmit_wrapped,
    translucency_beer_throughout,
    translucency_exponent_throughout,
    translucency_ratio_throughout,
)

PER_FRAGMENT = {"pixel_scale": "pixels_per_offset"}
BY_AXIS = {"pixel_scale": "texels_per_offset"}


def by_channel(stage):
    """A stage of the translucency with one number for each channel."""
    own = [name for name in BY_CHANNEL if name in (*stage.parameters, *stage.outputs)]
    other_names = {name: f"{name.removeprefix('translucency_')}_by_channel" for name in own if name in stage.parameters}
    return stage.retyped(**dict.fromkeys(own, vec3)).bound(**other_names)


IN_COLOR = (
    translucency_ratio,
    translucency_exponent,
    translucency_beer,
    translucency_ratio_throughout,
    translucency_exponent_throughout,
    translucency_beer_throughout,
    translucency_unclamped,
)
JOINED = (
    lit_multiply,
    lit_add,
    lit_transmit,
    lit_transmit_wrapped,
    lit_multiply_soft,
    lit_transmit_soft,
    lit_transmit_wrapped_soft,
    irradiance_replaced,
    irradiance_added,
    irradiance_added_wrapped,
    image_sqrt_add,
)

RETYPED = {
    **{f"{stage.name}-by-channel": by_channel(stage) for stage in (*IN_COLOR, *JOINED)},
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


def once_a_channel(naive, stage):
    """A naive form that takes one number, run once for each channel where a stage takes three."""
    before = all_stages()[stage.name]
    changed = [own for own, kind in stage.parameters.items() if kind is vec3 and before.parameters[own] is float]
    if not changed:
        return naive

    def channels(**given):
        runs = [naive(**{**given, **{own: given[own][k] for own in changed}}) for k in range(3)]
        return tuple(
            [run[place] if kind is float else run[place][k] for k, run in enumerate(runs)]
            for place, kind in enumerate(before.outputs.values())
        )

    return channels
