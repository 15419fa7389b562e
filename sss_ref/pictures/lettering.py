"""How pictures are labelled: one typeface, three weights of ink."""

from functools import cache

from PIL import ImageFont

BRIGHT, SOFT, FAINT = (238, 240, 244), (158, 164, 176), (104, 110, 122)  # sRGB 8-bit


@cache
def font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """Pillow's own typeface, `size` pixels high: every machine has it."""
    return ImageFont.load_default(size)
