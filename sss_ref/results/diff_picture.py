"""The picture of a difference: both versions of a buffer and, beside them, how far apart their values are."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from sss_ref.errors import DumpError
from sss_ref.errors.whole_file import whole_file
from sss_ref.language.names import Name
from sss_ref.pictures import tiles
from sss_ref.pictures.channels import channel_names
from sss_ref.pictures.lettering import BRIGHT, FAINT, SOFT, font
from sss_ref.results.diff import ULP_CLASSES, buffer_files, buffer_pair, differing_pixels, ulp_class
from sss_ref.results.folder import read_buffer

PANEL = 480  # least width of a panel, pixels: of smaller buffers the pixels are repeated
LARGEST = 1024  # of a panel in either direction: larger buffers are thinned out
GAP, MARGIN = 24, 36
HEADER, CAPTION = 84, 76  # above and below the panels
RING = 14  # radius of the mark around the first difference, pixels
SWATCH = 13  # of the legend, pixels

CLASS_COLOURS = np.array(
    [(38, 41, 49), (57, 84, 158), (33, 138, 148), (84, 188, 110), (240, 200, 70), (236, 110, 60), (232, 60, 130)],
    np.uint8,
)
"""sRGB 8-bit for each of ULP_CLASSES, equal values first; zeros of either sign differ and are of the last one."""

Pair = tuple[np.ndarray, np.ndarray]


@dataclass(frozen=True)
class Layout:
    """Where the pixels of a buffer come to lie: three panels in a row."""

    height: int
    width: int

    @property
    def step(self) -> int:
        """Every how many-th row and column is shown."""
        return -(-max(self.height, self.width) // LARGEST)

    @property
    def repeat(self) -> int:
        """How often a shown pixel is repeated in each direction."""
        return max(1, -(-PANEL // self.width)) if self.height < LARGEST else 1

    @property
    def panel(self) -> tuple[int, int]:
        """Width and height of a panel, in pixels of the picture."""
        return -(-self.width // self.step) * self.repeat, -(-self.height // self.step) * self.repeat

    @property
    def corners(self) -> list[tuple[int, int]]:
        """The panels' upper left corners."""
        return [(MARGIN + column * (self.panel[0] + GAP), HEADER) for column in range(3)]

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the picture."""
        return self.corners[-1][0] + self.panel[0] + MARGIN, HEADER + self.panel[1] + CAPTION

    def place(self, column: int, row: int) -> tuple[int, int]:
        """Where the middle of a buffer's pixel is in a panel, from its upper left corner."""
        scale = self.repeat / self.step
        return round((column + 0.5) * scale), self.panel[1] - round((row + 0.5) * scale)


def checked_picture_file(path: Path) -> Path:
    """The file of a picture to be written. Raises DumpError for another format or a folder that is not there."""
    if path.suffix.lower() != ".png":
        raise DumpError(f"{path}: expected a file name ending in .png, got {path.suffix or 'no suffix'}; change it")
    if not path.absolute().parent.is_dir():
        raise DumpError(f"{path}: expected an existing folder, got {path.parent}; create it first")
    return path


def write_diff_picture(path: Path, name: str, a: Path, b: Path) -> None:
    """Draw buffer `name`, which differs between the folders a and b, from both, and a map of the differences.

    The map shows every difference, also of a buffer too large to be shown whole. path: the PNG file to write.
    Raises DumpError as `diff` does.
    """
    files_a, files_b = buffer_files(a), buffer_files(b)
    pair = buffer_pair(files_a[name], files_b[name])
    layout = Layout(*pair[0].shape[:2])
    classes = worst_class(*pair)
    sheet = Image.new("RGB", layout.size, tiles.GROUND)
    drawn = _drawn(name, files_a, pair[0]), _drawn(name, files_b, pair[1])
    panels = (*versions(name, pair, drawn, layout.step), CLASS_COLOURS[thinned_to_worst(classes, layout.step)])
    for panel, corner in zip(panels, layout.corners, strict=True):
        _draw_panel(sheet, panel, corner, layout.repeat)
    _draw_text(sheet, layout, name, (f"A: {a}", f"B: {b}"))
    _draw_legend(sheet, layout, classes)
    _draw_rings(sheet, layout, np.argwhere(differing_pixels(*pair))[0])
    _save(sheet, path)


def worst_class(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """For every pixel (H, W) the index in ULP_CLASSES of the channel that is furthest apart."""
    worst: np.ndarray = ulp_class(a, b).reshape(*a.shape[:2], -1).max(axis=-1)
    return worst


def thinned_to_worst(classes: np.ndarray, step: int) -> np.ndarray:
    """The worst class of every block of step x step pixels, so that no single pixel is lost."""
    rows, columns = (np.arange(0, size, step) for size in classes.shape)
    return np.maximum.reduceat(np.maximum.reduceat(classes, rows, axis=0), columns, axis=1)


def versions(name: str, pair: Pair, drawn: Pair, step: int) -> list[np.ndarray]:
    """Both buffers as colours, uint8 (H, W, 3); one range of values for both, so that equal values look alike.

    drawn: bool (H, W) for each. NaN and infinity are shown as if nothing were drawn.
    """
    both = np.concatenate([buffer[::step, ::step] for buffer in pair])
    covered = np.concatenate([mask[::step, ::step] for mask in drawn])
    finite = np.isfinite(both)
    covered &= finite.reshape(*both.shape[:2], -1).all(axis=-1)
    return np.split(tiles.picture(name, np.where(finite, both, both.dtype.type(0)), covered), 2)


def _drawn(name: str, files: Mapping[str, Path], buffer: np.ndarray) -> np.ndarray:
    """Where the model is seen, as far as the folder tells: the background would use up the range of a scalar."""
    parts = Name.of(name)
    shown = Name("light_triangle", parts.light) if parts.base.startswith("light_") else Name("triangle")
    triangle = files.get(str(shown.of_body(parts.body)))
    seen = read_buffer(triangle) >= 0 if triangle and channel_names(name, buffer)[0] != "R" else None
    return seen if seen is not None and seen.shape == buffer.shape[:2] else np.ones(buffer.shape[:2], bool)


def _draw_panel(sheet: Image.Image, panel: np.ndarray, corner: tuple[int, int], repeat: int) -> None:
    """Colours (H, W, 3), row 0 at the bottom, each pixel as a square."""
    upright = panel[::-1].repeat(repeat, axis=0).repeat(repeat, axis=1)
    sheet.paste(Image.fromarray(np.ascontiguousarray(upright)), corner)


def _draw_text(sheet: Image.Image, layout: Layout, name: str, captions: tuple[str, str]) -> None:
    """The buffer's name on top, and which folder is which; of a long path its end."""
    draw = ImageDraw.Draw(sheet)
    draw.text((MARGIN, 24), name, BRIGHT, font(34))
    for (left, _), caption in zip(layout.corners[:2], captions, strict=True):
        while draw.textlength(caption, font(18)) > layout.panel[0] and len(caption) > 8:
            caption = f"{caption[:3]}...{caption[7:]}"
        draw.text((left, layout.size[1] - CAPTION + 12), caption, SOFT, font(18))


def _draw_legend(sheet: Image.Image, layout: Layout, classes: np.ndarray) -> None:
    """The classes' colours and how many pixels are of each, below the map: one row of four, one of three."""
    draw, (left, _) = ImageDraw.Draw(sheet), layout.corners[-1]
    draw.text((left, HEADER - 26), "units in the last place, the channel furthest apart", FAINT, font(16))
    counts = np.bincount(classes.reshape(-1), minlength=len(ULP_CLASSES)).tolist()
    for place, (label, colour, count) in enumerate(zip(ULP_CLASSES, CLASS_COLOURS.tolist(), counts, strict=True)):
        row, column = divmod(place, 4)
        x, y = left + column * layout.panel[0] // 4, layout.size[1] - CAPTION + 12 + 24 * row
        draw.rectangle((x, y + 3, x + SWATCH, y + 3 + SWATCH), tuple(colour), FAINT)
        draw.text((x + SWATCH + 7, y), f"{label}: {count}", SOFT, font(15))


def _draw_rings(sheet: Image.Image, layout: Layout, first: np.ndarray) -> None:
    """A ring around the first difference, (row, column), in every panel."""
    row, column = first.tolist()
    x, y = layout.place(column, row)
    for left, top in layout.corners:
        ImageDraw.Draw(sheet).circle((left + x, top + y), RING, outline=BRIGHT, width=2)


def _save(sheet: Image.Image, path: Path) -> None:
    try:
        with whole_file(path) as hidden:
            sheet.save(hidden)
    except OSError as error:
        raise DumpError(f"{path}: cannot be written ({error.strerror}); choose another file") from None
