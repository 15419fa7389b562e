"""overview.png: all buffers on one labelled sheet, in stage order, grouped by pass."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from sss_ref.language.pipeline import Pass
from sss_ref.passes.buffers import described
from sss_ref.pictures import tiles
from sss_ref.pictures.lettering import BRIGHT, FAINT, SOFT, font
from sss_ref.pictures.png_file import ZLIB, encoding_of, image_encoding_of
from sss_ref.rendering.result import Result
from sss_ref.rules import RULES_VERSION

TILE = 320  # width of a tile, pixels
SUPERSAMPLES = 1.5  # at least so many values in each direction are averaged to a pixel of a tile, where there are more
GAP = 20
MARGIN = 36
HEADER = 104  # height of the title
PASS_LINE = 38  # above a tile: the pass it belongs to
CAPTION = 104  # below a tile: name, range, unit

ACCENTS = ((233, 174, 84), (92, 178, 224), (226, 116, 132), (126, 200, 136), (182, 146, 226))  # one a pass


@dataclass(frozen=True, eq=False)
class Tile:
    """A buffer and what its tile says about it."""

    name: str
    buffer: np.ndarray
    covered: np.ndarray  # bool (H, W)
    pass_name: str
    accent: tuple[int, int, int]
    leads: bool  # the first of its pass
    encode: Callable[[np.ndarray], np.ndarray]  # of colours

    @cached_property
    def value_range(self) -> tuple[float, float]:
        """Least and largest value where something is drawn."""
        return tiles.value_range(self.buffer, self.covered)

    @property
    def range_text(self) -> tuple[str, str]:
        """Least and largest value as text."""
        low, high = self.value_range
        return (str(low), str(high)) if self.buffer.dtype.kind in "iu" else (f"{low:.4g}", f"{high:.4g}")


def write_overview(path: Path, result: Result) -> None:
    """Draw the contact sheet of a rendering, `result`, and write it as a PNG file at `path`."""
    found = list(tiles_of(result))
    columns = _columns(len(found))
    camera = result.scene.settings.camera
    frame = (TILE, min(max(TILE * camera.height // camera.width, TILE // 2), TILE * 5 // 4))
    cell = (TILE + GAP, PASS_LINE + frame[1] + CAPTION)
    rows = -(-len(found) // columns)
    size = (2 * MARGIN + columns * cell[0] - GAP, HEADER + rows * cell[1] + MARGIN // 2)
    sheet = Image.new("RGB", size, tiles.GROUND)
    _draw_title(sheet, result)
    for index, tile in enumerate(found):
        row, column = divmod(index, columns)
        corner = (MARGIN + column * cell[0], HEADER + row * cell[1])
        _draw_pass_line(sheet, tile, corner, named=tile.leads or column == 0, joined=column > 0 and not tile.leads)
        _draw_picture(sheet, tile, (corner[0], corner[1] + PASS_LINE), frame)
        _draw_caption(sheet, tile, (corner[0], corner[1] + PASS_LINE + frame[1]))
    sheet.save(path, **ZLIB)


def tiles_of(result: Result) -> Iterator[Tile]:
    """The kept buffers in stage order, each with the pass that wrote it."""
    settings = result.scene.settings
    for number, this_pass in enumerate(result.scene.method.passes):
        kept = [name for name in this_pass.values if name in result.buffers]
        limited = _drawn(result, this_pass)
        for name in kept:
            buffer = result.buffers[name]
            accent = ACCENTS[number % len(ACCENTS)]
            covered = np.ones(buffer.shape[:2], bool) if limited is None else limited
            encode = image_encoding_of(settings) if name == "image" else encoding_of(settings)
            yield Tile(name, buffer, covered, this_pass.name, accent, name == kept[0], encode)


def _drawn(result: Result, this_pass: Pass) -> np.ndarray | None:
    """Where a pass has drawn: its mesh, or its rectangle within the stencil; None if that was not kept."""
    limit = result.buffers.get(this_pass.draw.triangle or this_pass.draw.stencil)
    if limit is None:
        return None
    return limit != 0 if limit.dtype == np.uint8 else limit >= 0


def _columns(count: int) -> int:
    """How many tiles a row has."""
    return min(count, 6 if count > 15 else 5 if count > 8 else 4)


def _draw_title(sheet: Image.Image, result: Result) -> None:
    """Which scene this is, and what it was made with."""
    settings = result.scene.settings
    camera, shadow_map = settings.camera, settings.shadow_map
    draw, name = ImageDraw.Draw(sheet), Path(result.scene.source).stem
    facts = (
        f"{settings.method.replace('_', ' ')}, preset {settings.preset}, {camera.width} x {camera.height}",
        f"mesh {result.scene.mesh.name}, shadow map {shadow_map.width} x {shadow_map.height}, rules {RULES_VERSION}",
    )
    title = font(40)
    draw.text((MARGIN, 26), name, BRIGHT, title)
    left = MARGIN + draw.textlength(name, title) + 24
    draw.text((left, 26), facts[0], SOFT, font(20))
    draw.text((left, 51), facts[1], FAINT, font(17))


def _draw_pass_line(sheet: Image.Image, tile: Tile, corner: tuple[int, int], named: bool, joined: bool) -> None:
    """A line in the pass's colour above its tiles, joined to the tile on the left if that is of the same pass."""
    draw, (left, top) = ImageDraw.Draw(sheet), corner
    draw.rectangle((left - GAP * joined, top + 28, left + TILE - 1, top + 30), tile.accent)
    if named:
        draw.text((left, top), tile.pass_name, tile.accent, font(20))


def _draw_picture(sheet: Image.Image, tile: Tile, corner: tuple[int, int], frame: tuple[int, int]) -> None:
    """The buffer in the middle of its frame, in its own proportions: areas averaged, or pixels repeated."""
    height, width = tile.buffer.shape[:2]
    step = max(1, int(min(height / frame[1], width / frame[0]) / SUPERSAMPLES))
    shown, covered = tile.buffer[::step, ::step], tile.covered[::step, ::step]
    pixels = tiles.picture(tile.name, shown, covered, tile.value_range, tile.encode)[::-1]
    scale = min(frame[0] / width, frame[1] / height)
    size = (max(1, round(width * scale)), max(1, round(height * scale)))
    filtered = Image.Resampling.BOX if scale < 1 else Image.Resampling.NEAREST
    place = (corner[0] + (frame[0] - size[0]) // 2, corner[1] + (frame[1] - size[1]) // 2)
    sheet.paste(Image.fromarray(np.ascontiguousarray(pixels)).resize(size, filtered), place)


def _draw_caption(sheet: Image.Image, tile: Tile, corner: tuple[int, int]) -> None:
    """Name, range and unit, one below the other."""
    draw, (left, top) = ImageDraw.Draw(sheet), corner
    draw.text((left, top + 8), tile.name, BRIGHT, font(23))
    _draw_range(sheet, tile, (left, top + 38))
    unit = described(tile.name).unit
    size = next((size for size in range(16, 9, -1) if draw.textlength(unit, font(size)) <= TILE), 9)
    draw.text((left, top + 62), unit, FAINT, font(size))


def _draw_range(sheet: Image.Image, tile: Tile, corner: tuple[int, int]) -> None:
    """Least and largest value, and between them the colours that stand for what lies between."""
    draw, (left, top), small = ImageDraw.Draw(sheet), corner, font(18)
    low, high = tile.range_text
    if not tiles.has_ramp(tile.name, tile.buffer):
        draw.text(corner, f"{low} to {high}", SOFT, small)
        return
    ramp = Image.fromarray(tiles.RAMP[None]).resize((72, 12))
    start = round(left + draw.textlength(low, small) + 10)
    draw.text(corner, low, SOFT, small)
    sheet.paste(ramp, (start, top + 5))
    draw.text((start + ramp.width + 10, top), high, SOFT, small)
