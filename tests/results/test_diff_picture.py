from pathlib import Path

import imageio.v3 as imageio
import numpy as np
import pytest
from noted_sheet import noted

from sss_ref.errors import DumpError
from sss_ref.results import diff_picture
from sss_ref.results.diff_picture import (
    CLASS_COLOURS,
    Layout,
    checked_picture_file,
    thinned_to_worst,
    versions,
    worst_class,
    write_diff_picture,
)


@pytest.mark.parametrize(
    "size, panel", [((32, 48), (480, 320)), ((100, 300), (600, 200)), ((1024, 600), (600, 1024)), ((2050, 3), (1, 684))]
)
def test_panels_are_of_a_size_to_look_at(size, panel):
    assert Layout(*size).panel == panel


def test_places_are_inside_the_repeated_pixel():
    layout = Layout(32, 48)
    assert layout.repeat == 10
    assert layout.place(0, 0) == (5, 315) and layout.place(47, 31) == (475, 5)


def test_no_difference_is_lost_by_thinning():
    classes = np.zeros((7, 10), int)
    classes[6, 9], classes[2, 5], classes[1, 5] = 2, 5, 3
    expected = [[0, 5, 0, 0], [0, 0, 0, 0], [0, 0, 0, 2]]
    assert thinned_to_worst(classes, 3).tolist() == expected


def test_the_worst_channel_counts():
    a = np.ones((1, 2, 3), np.float32)
    b = a.copy()
    b[0, 1] = [1, np.nextafter(np.float32(1), np.float32(2)), -1]
    assert worst_class(a, b).tolist() == [[0, 6]]


def test_versions_share_one_range_of_values():
    low, high = np.float32([[0, 1]]), np.float32([[1, 4]])
    a, b = versions("depth", (low, high), (np.ones((1, 2), bool),) * 2, 1)
    assert a[0, 1].tolist() == b[0, 0].tolist() and a[0, 0].tolist() != b[0, 0].tolist()


def test_values_that_are_no_numbers_are_left_out():
    strange, plain = np.float32([[np.nan, np.inf, 1]]), np.float32([[0, 0, 3]])
    a, _ = versions("depth", (strange, plain), (np.ones((1, 3), bool),) * 2, 1)
    assert a[0, 0].tolist() == a[0, 1].tolist() == list(diff_picture.tiles.GROUND)


def test_picture(saved, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    depth = np.load(saved / "buffers" / "depth.npy")
    depth[3, 40] += 1
    np.save(other / "depth.npy", depth)
    write_diff_picture(tmp_path / "x.png", "depth", saved, other)
    picture, layout = imageio.imread(tmp_path / "x.png"), Layout(32, 48)
    assert picture.shape == (layout.size[1], layout.size[0], 3)
    (left, top), (width, height) = layout.corners[2], layout.panel
    shown = picture[top : top + height, left : left + width][5::10, 5::10][::-1]  # the middle of every pixel
    expected = CLASS_COLOURS[np.where(depth == np.load(saved / "buffers" / "depth.npy"), 0, 5)]
    ring = np.hypot(*(np.indices((32, 48)) - np.array([3, 40])[:, None, None]))
    assert np.array_equal(shown[(ring < 1) | (ring > 2)], expected[(ring < 1) | (ring > 2)])
    assert (expected == CLASS_COLOURS[5]).all(axis=-1).sum() == 1
    for left, top in layout.corners:
        x, y = layout.place(40, 3)
        assert picture[top + y - diff_picture.RING, left + x].tolist() == list(diff_picture.BRIGHT)


def test_each_light_has_its_own_background(tmp_path):
    for light, triangles in ((1, [[-1, 0]]), (2, [[7, -1]])):
        np.save(tmp_path / f"light_triangle_{light}.npy", np.int32(triangles))
    files = diff_picture.buffer_files(tmp_path)
    seen = {light: diff_picture._drawn(f"light_distance_{light}", files, np.float32([[8, 9]])) for light in (1, 2)}
    assert seen[1].tolist() == [[False, True]] and seen[2].tolist() == [[True, False]]


def test_the_background_does_not_use_up_the_range(saved, tmp_path):
    files = diff_picture.buffer_files(saved)
    drawn = diff_picture._drawn("depth", files, np.load(files["depth"]))
    assert np.array_equal(drawn, np.load(files["coverage"]) != 0)
    assert diff_picture._drawn("image", files, np.load(files["image"])).all()
    light = diff_picture._drawn("light_distance", files, np.load(files["light_distance"]))
    assert np.array_equal(light, np.load(files["light_triangle"]) >= 0) and not light.all()


def test_where_a_picture_cannot_be(tmp_path):
    with pytest.raises(DumpError, match=r"x\.jpg: expected a file name ending in \.png, got \.jpg; change it"):
        checked_picture_file(tmp_path / "x.jpg")
    with pytest.raises(DumpError, match=r"expected an existing folder, got .*nowhere; create it first"):
        checked_picture_file(tmp_path / "nowhere" / "x.png")
    assert checked_picture_file(tmp_path / "x.PNG") == tmp_path / "x.PNG"


BRIGHT, SOFT, FAINT = (238, 240, 244), (158, 164, 176), (104, 110, 122)
SHEET = [  # a buffer of 3 x 2 pixels, each shown as 160 x 160; from the upper left corner
    *(("paste", (left, 84), (480, 320)) for left in (36, 540, 1044)),
    ("text", (36, 24), "depth", BRIGHT, 34),
    ("text", (36, 416), "A: a", SOFT, 18),
    ("text", (540, 416), f"B: ...{'b' * 47}", SOFT, 18),  # 53 letters of 9 pixels, with the end of the path
    ("text", (1044, 58), "units in the last place, the channel furthest apart", FAINT, 16),
    ("box", (1044, 419, 1057, 432), (38, 41, 49), FAINT),
    ("text", (1064, 416), "0: 4", SOFT, 15),
    ("box", (1164, 419, 1177, 432), (57, 84, 158), FAINT),
    ("text", (1184, 416), "1: 1", SOFT, 15),
    ("box", (1284, 419, 1297, 432), (33, 138, 148), FAINT),
    ("text", (1304, 416), "2-3: 0", SOFT, 15),
    ("box", (1404, 419, 1417, 432), (84, 188, 110), FAINT),
    ("text", (1424, 416), "4-15: 0", SOFT, 15),
    ("box", (1044, 443, 1057, 456), (240, 200, 70), FAINT),
    ("text", (1064, 440), "16-255: 0", SOFT, 15),
    ("box", (1164, 443, 1177, 456), (236, 110, 60), FAINT),
    ("text", (1184, 440), "more: 1", SOFT, 15),
    ("box", (1284, 443, 1297, 456), (232, 60, 130), FAINT),
    ("text", (1304, 440), "sign, NaN: 0", SOFT, 15),
    *(("circle", (left + 240, 324), 14, BRIGHT, 2) for left in (36, 540, 1044)),  # the lower row's middle pixel
]


def test_everything_has_its_place_on_the_picture(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folders = Path("a"), Path("b" * 60)
    depth = np.full((2, 3), 0.5, np.float32)
    other = depth.copy()
    other[0, 1], other[1, 2] = np.nextafter(np.float32(0.5), np.float32(1)), 0.75
    for folder, buffer in zip(folders, (depth, other), strict=True):
        folder.mkdir()
        np.save(folder / "depth.npy", buffer)
    notes = noted(monkeypatch)
    write_diff_picture(Path("x.png"), "depth", *folders)
    assert notes == SHEET
    shown = imageio.imread("x.png")
    assert shown.shape == (480, 1560, 3)
    assert [shown[row, column].tolist() for row, column in ((300, 1284), (100, 1444))] == [
        [57, 84, 158],
        [236, 110, 60],
    ]


@pytest.mark.parametrize(
    ("size", "letters", "shown"),
    [
        ((4, 54), 51, f"B: {'b' * 51}"),  # 54 letters of 9 pixels are as wide as a panel of 54 pixels, each 9 times
        ((4, 54), 52, f"B: ...{'b' * 48}"),
        ((1100, 1), 30, "B: ...bb"),  # of a panel one pixel wide 8 letters are left
    ],
)
def test_a_caption_is_as_wide_as_its_panel_at_most(tmp_path, monkeypatch, size, letters, shown):
    monkeypatch.chdir(tmp_path)
    folders = Path("a"), Path("b" * letters)
    for value, folder in enumerate(folders):
        folder.mkdir()
        np.save(folder / "depth.npy", np.full(size, value, np.float32))
    notes = noted(monkeypatch)
    write_diff_picture(Path("x.png"), "depth", *folders)
    assert [words for kind, _, words, *_ in notes if kind == "text"][2] == shown
