"""The picture: the scattered model before its background (paper 3.2)."""

from typing import NamedTuple

from sss_ref.language import select, stage, vec3


class Image(NamedTuple):
    """The final picture."""

    image: vec3  # linear RGB


@stage(source="paper 3.2: a stencil limits the blur to the model")
def over_background(scattered: vec3, coverage: bool, background: vec3) -> Image:
    """The model where it covers the pixel, the background elsewhere."""
    return Image(select(coverage, scattered, background))


@stage(source="paper 3.2, before the stencil")
def glow(scattered: vec3) -> Image:
    """The blurred picture everywhere: light spills over the outline."""
    return Image(scattered)
