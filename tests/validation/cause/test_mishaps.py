"""What may befall a draw, each drawn naively from corners that are put elsewhere by hand."""

from math import floor
from types import SimpleNamespace

import naive_raster
import numpy as np
import pytest

from sss_ref.raster.primitives import Primitives
from sss_ref.raster.viewport import Viewport
from sss_ref.validation.cause.mishaps import mishaps, turns

WIDTH, HEIGHT = 9, 7
CORNERS = [  # pixels from the centre of pixel (0, 0); the second's side is beside a column, but not when cut off
    (0.61, 0.73), (6.52, 1.03), (1.3, 5.27),
    (4.00234, 0.2), (1.31, 3.1), (4.00234, 6.3),
    (3.2, 0.6), (7.4, 1.45), (5.03, 5.97),
]  # fmt: skip
TRIANGLES = [(0, 1, 2), (3, 4, 5), (6, 7, 8)]
DEPTHS = (0.5, 0.25, 0.5)  # of each triangle
FAR = np.float32(1)


def drawn(corners, kept=(0, 1, 2), depths=DEPTHS, last=False, step=256, width=WIDTH):
    """The triangle numbers and depths, (H, W), of corners in pixels; of two at the same depth the first, or the last.

    step: of the grid that the corners lie on, multiplied with it.
    """
    triangle, depth = np.full((HEIGHT, width), -1, np.int32), np.full((HEIGHT, width), np.inf)
    for number in kept:
        piece = [naive_raster.Corner(*corners[corner], 0, 0, []) for corner in TRIANGLES[number]]
        for row in range(HEIGHT):
            for column in range(width):
                inside, _ = naive_raster.covering(piece, column * step, row * step)
                nearer = depths[number] <= depth[row, column] if last else depths[number] < depth[row, column]
                if inside and nearer:
                    triangle[row, column], depth[row, column] = number, depths[number]
    return triangle, np.where(triangle < 0, FAR, depth).astype(np.float32)


def snapped(snap=round, step=256):
    return [(snap(x * step), snap(y * step)) for x, y in CORNERS]


def moved(x, y):
    return drawn([(a + 128 * x, b + 128 * y) for a, b in snapped()])


def turned(mirrors_x, mirrors_y):
    right, top = (WIDTH - 1) * 256, (HEIGHT - 1) * 256
    return drawn([(right - a if mirrors_x else a, top - b if mirrors_y else b) for a, b in snapped()])


HALF = "the picture is half a pixel too far "
EXPECTED = {
    "triangles that turn clockwise in the window are culled": drawn(snapped(), kept=(0, 2)),
    "triangles that turn counter-clockwise in the window are culled": drawn(snapped(), kept=(1,)),
    "the depth test keeps the farthest": drawn(snapped(), depths=(0.5, 0.75, 0.5)),
    "there is no depth test: the last triangle drawn is seen": drawn(snapped(), depths=(0, 0, 0), last=True),
    "only the first triangle drawn is seen": drawn(snapped(), depths=(0, 0, 0)),
    f"{HALF}right": moved(1, 0),
    f"{HALF}left": moved(-1, 0),
    f"{HALF}up": moved(0, 1),
    f"{HALF}down": moved(0, -1),
    f"{HALF}up and right": moved(1, 1),
    f"{HALF}up and left": moved(-1, 1),
    f"{HALF}down and right": moved(1, -1),
    f"{HALF}down and left": moved(-1, -1),
    "the picture is upside down": turned(False, True),
    "the picture is mirrored": turned(True, False),
    "the picture is turned by 180 degrees": turned(True, True),
    "x and y are swapped": drawn([(y, x) for x, y in snapped()]),
    "it snaps to 4 subpixel bits, so choose such a profile": drawn(snapped(step=16), step=16),
    "it snaps by cutting off, so choose a profile that may (snap = any)": drawn(snapped(floor)),
}


def visible(bits=8, layout=False):
    corners, number = np.array(TRIANGLES, np.int32), np.arange(3, dtype=np.int32)
    depth, inverse_w = np.repeat(np.float32(DEPTHS), 3), np.ones(9, np.float32)
    grid = np.array(snapped(step=2**bits), np.int32)
    primitives = Primitives(corners, number, grid, depth, inverse_w, np.zeros((9, 0)))
    boxes = SimpleNamespace(primitives=primitives, viewport=Viewport(WIDTH, HEIGHT, bits), centre=np.array(CORNERS))
    draw = SimpleNamespace(layout=layout, triangle="triangle", depth="depth", coverage="coverage")
    return SimpleNamespace(boxes=boxes, draw=draw)


@pytest.mark.parametrize("text", EXPECTED)
def test_a_mishap_draws_this(text):
    triangle, depth = EXPECTED[text]
    right, _ = drawn(snapped())
    assert (triangle != right).any()  # it can be told
    for name, got in (("triangle", triangle), ("depth", depth), ("coverage", triangle >= 0)):
        assert dict(mishaps(visible(), name, got))[text].all()
    assert np.array_equal(dict(mishaps(visible(), "triangle", right))[text], triangle == right)


def test_there_are_no_others():
    assert [text for text, _ in mishaps(visible(), "triangle", drawn(snapped())[0])] == list(EXPECTED)
    texts = [text for text, _ in mishaps(visible(layout=True), "triangle", drawn(snapped())[0])]
    assert texts == [text for text in EXPECTED if text != "the depth test keeps the farthest"]


def test_in_a_layout_the_last_triangle_is_seen_unless_it_is_culled():
    assert (drawn(snapped(), (0, 2), last=True)[0] != drawn(snapped(), (0, 2))[0]).any()
    found = dict(mishaps(visible(layout=True), "triangle", drawn(snapped(), (0, 2), last=True)[0]))
    assert found["triangles that turn clockwise in the window are culled"].all()


def test_a_coarse_profile_is_held_against_a_fine_one():
    fine = drawn(snapped())[0]
    found = dict(mishaps(visible(bits=4), "triangle", fine))
    assert found["it snaps to 8 subpixel bits, so choose such a profile"].all()
    assert "it snaps to 4 subpixel bits, so choose such a profile" not in found


@pytest.mark.parametrize(("off", "same"), [(2.0**-14, True), (-(2.0**-14), True), (2.0**-13, False)])
def test_depths_may_differ_a_little(off, same):
    _, depth = EXPECTED["the picture is mirrored"]
    found = dict(mishaps(visible(), "depth", np.where(depth < 1, depth + np.float32(off), depth)))
    assert np.array_equal(found["the picture is mirrored"], (depth == 1) | same)


def test_how_much_a_piece_turns_is_twice_its_area():
    snapped = np.int32([(1, 2), (5, 3), (2, 7), (-4, 6)])
    pieces = Primitives(np.int32([(0, 1, 2), (0, 2, 1), (3, 1, 0), (0, 0, 1)]), None, snapped, None, None, None)
    assert turns(pieces).tolist() == [19, -19, -21, 0] and turns(pieces).dtype == np.int64
    far = pieces._replace(snapped=snapped * 2**22)
    assert turns(far).tolist() == [each * 2**44 for each in (19, -19, -21, 0)]
