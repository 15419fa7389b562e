"""All pictures of a batch on one sheet, each with what was varied in it."""

import math
from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw

from sss_ref.errors.whole_file import whole_file
from sss_ref.pictures.lettering import SOFT, font
from sss_ref.pictures.tiles import GROUND

LEAST, LARGEST = 96, 200  # width and height of a tile, pixels
GAP, CAPTION, LETTERS = 12, 26, 15
MOST_TILES = 400  # of more pictures, so many evenly chosen ones are shown


def write_contact_sheet(path: Path, pictures: Sequence[Path], captions: Sequence[str]) -> None:
    """Write a PNG of pictures in rows, as many as columns, each above its caption.

    pictures: PNG files, at least one; the first has the form of all tiles.
    """
    step = -(-len(pictures) // MOST_TILES)
    shown = list(zip(pictures, captions, strict=True))[::step]
    columns = math.ceil(math.sqrt(len(shown)))
    tile = _tile(pictures[0])
    width, height = tile[0] + GAP, tile[1] + CAPTION + GAP
    sheet = Image.new("RGB", (GAP + columns * width, GAP + -(-len(shown) // columns) * height), GROUND)
    draw = ImageDraw.Draw(sheet)
    for number, (picture, caption) in enumerate(shown):
        left, top = GAP + number % columns * width, GAP + number // columns * height
        _paste(sheet, picture, (left, top), tile)
        draw.text((left, top + tile[1] + 4), _cut(draw, caption, tile[0]), SOFT, font(LETTERS))
    with whole_file(path) as hidden:
        sheet.save(hidden)


def _tile(path: Path) -> tuple[int, int]:
    """Width and height of a tile for pictures like the one at `path`."""
    with Image.open(path) as picture:
        picture.thumbnail((LARGEST, LARGEST))
        return max(picture.width, LEAST), max(picture.height, LEAST)


def _paste(sheet: Image.Image, path: Path, corner: tuple[int, int], tile: tuple[int, int]) -> None:
    """A picture in the middle of its tile, no larger than it."""
    with Image.open(path) as opened:
        picture = opened.convert("RGBA")
        picture.thumbnail(tile, Image.Resampling.BOX)
        left, top = ((room - side) // 2 for room, side in zip(tile, picture.size, strict=True))
        sheet.paste(picture, (corner[0] + left, corner[1] + top), picture)


def _cut(draw: ImageDraw.ImageDraw, caption: str, width: int) -> str:
    """What of a caption is as wide as a tile."""
    while draw.textlength(caption, font(LETTERS)) > width:
        caption = f"{caption[:-4]}..."
    return caption
