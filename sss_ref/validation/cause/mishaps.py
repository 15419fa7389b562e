"""What may be wrong with a draw: each mishap is drawn, and compared with what was dumped."""

from collections.abc import Iterator

import numpy as np

from sss_ref.raster.primitives import Primitives, drawable, only
from sss_ref.raster.rasterize import first_and_last
from sss_ref.raster.viewport import Viewport
from sss_ref.validation.accept.rasterizer.visible import Visible

SAME_DEPTH = 2.0**-14
HALF_A_PIXEL = {"right": (1, 0), "left": (-1, 0), "up": (0, 1), "down": (0, -1)}
DIAGONALS = {
    f"{y} and {x}": (HALF_A_PIXEL[x][0], HALF_A_PIXEL[y][1]) for y in ("up", "down") for x in ("right", "left")
}
Redrawn = tuple[str, Primitives, Viewport, bool]  # in words, what is drawn, into what, and whether the last one wins


def mishaps(visible: Visible, name: str, got: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    """Every mishap, and the pixels of a buffer (H, W) that it would draw as they are, bool (H, W)."""
    for text, primitives, viewport, last in _drawings(visible):
        drawn = only(primitives, drawable(primitives))
        pieces = first_and_last(drawn, viewport, None)
        shown = np.append(drawn.triangle, np.int32(-1))[pieces[last]]
        if name == visible.draw.depth:
            with np.errstate(invalid="ignore"):
                same = np.abs(got - pieces[-1]) <= SAME_DEPTH
        else:
            same = got == (shown if name == visible.draw.triangle else shown >= 0)
        yield text, same


def _drawings(visible: Visible) -> Iterator[Redrawn]:
    primitives, viewport, layout = visible.boxes.primitives, visible.boxes.viewport, visible.draw.layout
    step, snapped = viewport.step, primitives.snapped
    turn = turns(primitives)
    yield "triangles that turn clockwise in the window are culled", only(primitives, turn > 0), viewport, layout
    yield (
        "triangles that turn counter-clockwise in the window are culled",
        only(primitives, turn < 0),
        viewport,
        layout,
    )
    if not layout:
        farthest = primitives._replace(depth=1 - primitives.depth)
        yield "the depth test keeps the farthest", farthest, viewport, False
    flat = primitives._replace(depth=np.zeros_like(primitives.depth))
    yield "there is no depth test: the last triangle drawn is seen", flat, viewport, True
    yield "only the first triangle drawn is seen", flat, viewport, False
    for direction, (x, y) in (HALF_A_PIXEL | DIAGONALS).items():
        moved = snapped + np.array([x, y], np.int32) * (step // 2)
        yield f"the picture is half a pixel too far {direction}", _at(primitives, moved), viewport, False
    size = np.array([viewport.width - 1, viewport.height - 1], np.int32) * step
    for text, axes in {"upside down": [0, 1], "mirrored": [1, 0], "turned by 180 degrees": [1, 1]}.items():
        turned = np.where(axes, size - snapped, snapped)
        yield f"the picture is {text}", _at(primitives, turned), viewport, False
    yield "x and y are swapped", _at(primitives, snapped[:, ::-1]), viewport, False
    for bits in {4, 8} - {viewport.subpixel_bits}:
        other = Viewport(viewport.width, viewport.height, bits)
        snapped_there = np.rint(visible.boxes.centre * other.step)
        yield (
            f"it snaps to {bits} subpixel bits, so choose such a profile",
            _at(primitives, snapped_there),
            other,
            False,
        )
    cut_off = np.floor(visible.boxes.centre * step)
    yield (
        "it snaps by cutting off, so choose a profile that may (snap = any)",
        _at(primitives, cut_off),
        viewport,
        False,
    )


def _at(primitives: Primitives, snapped: np.ndarray) -> Primitives:
    """The same with its vertices elsewhere."""
    return primitives._replace(snapped=np.ascontiguousarray(snapped, np.int32))


def turns(primitives: Primitives) -> np.ndarray:
    """Above 0 for pieces that turn counter-clockwise in the window, rows counted upwards; int64 (P,)."""
    a, b, c = (primitives.snapped[primitives.corners[:, k]].astype(np.int64).T for k in range(3))
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
