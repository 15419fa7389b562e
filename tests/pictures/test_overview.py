from dataclasses import replace

import numpy as np
import pytest
from noted_sheet import noted
from PIL import Image

from sss_ref.pictures import overview, tiles
from sss_ref.pictures.png_file import srgb8
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

ALL = np.ones((2, 2), bool)
GROUND = list(tiles.GROUND)
BRIGHT, SOFT, FAINT = (238, 240, 244), (158, 164, 176), (104, 110, 122)


def test_colours_are_encoded_where_covered():
    image = np.random.default_rng(1).random((2, 2, 3), np.float32)
    shown = tiles.picture("image", image, np.array([[True, False], [True, True]]))
    assert shown[0, 1].tolist() == GROUND
    assert shown[0, 0].tolist() == srgb8(image[0, 0]).tolist()


def test_masks_and_triangles():
    shown = tiles.picture("coverage", np.array([[0, 1], [1, 0]], np.uint8), ALL)
    assert shown[0, 0].tolist() == GROUND and shown[0, 1].tolist() == list(tiles.MASK)
    triangles = np.array([[-1, 0], [1, 0]], np.int32)
    shown = tiles.picture("triangle", triangles, triangles >= 0)
    assert shown[0, 0].tolist() == GROUND
    assert shown[0, 1].tolist() == shown[1, 1].tolist() != shown[1, 0].tolist()
    assert shown[1].min() >= 60


def test_scalars_run_along_the_ramp_over_the_covered_range():
    values = np.array([[1, 2], [3, 900]], np.float32)
    covered = values < 900
    assert tiles.value_range(values, covered) == (1, 3)
    shown = tiles.picture("thickness", values, covered)
    ends = [tiles.RAMP[0].tolist(), tiles.RAMP[128].tolist(), tiles.RAMP[255].tolist()]
    assert [shown[0, 0].tolist(), shown[0, 1].tolist(), shown[1, 0].tolist()] == ends
    assert shown[1, 1].tolist() == GROUND


def test_ramp_is_ordered_by_lightness():
    lightness = tiles.RAMP @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(lightness) > -0.5).all() and lightness[-1] > lightness[0] + 150


def test_the_ramp_goes_through_its_anchors():
    assert tiles.RAMP[::51].tolist() == [[*anchor] for anchor in tiles.RAMP_ANCHORS]


def test_the_colour_of_a_number_is_that_of_its_hash():
    """(0 + 1) * 2654435769 is 9e3779b9 in hexadecimals, (-1 + 1) times it 0; byte b is shown as 60 + 195 * b / 255."""
    bytes_of_the_hash = [0x79, 0x37, 0x9E]
    assert tiles.hashed_colours(np.array([0])).tolist() == [[60 + 195 * each // 255 for each in bytes_of_the_hash]]
    assert tiles.hashed_colours(np.array([-1])).tolist() == [[60, 60, 60]]


def test_a_share_of_the_range_is_rounded_to_the_nearest_of_255_and_held_to_its_ends():
    values = np.array([-9, 2, 2 + 0.49 / 255, 2 + 0.51 / 255, 3, 99])
    assert tiles.stretched(values, 2, 3).tolist() == [0, 0, 0, 1, 255, 255]


@pytest.mark.parametrize(("count", "columns"), [(1, 1), (4, 4), (8, 4), (9, 5), (15, 5), (16, 6), (40, 6)])
def test_more_tiles_stand_in_longer_rows(count, columns):
    assert overview._columns(count) == columns


def test_points_and_texture_coordinates():
    normals = np.array([[[-1, 0, 1]]], np.float32)
    assert tiles.picture("normal_world", normals, np.ones((1, 1), bool)).tolist() == [[[0, 128, 255]]]
    uv = np.array([[[0, 1], [-1, -1]]], np.float32)
    shown = tiles.picture("shadow_uv", uv, np.ones((1, 2), bool))
    assert shown.tolist() == [[[0, 255, 90], GROUND]]


def test_constant_and_empty_buffers_have_a_picture():
    depth = np.ones((2, 2), np.float32)
    assert tiles.picture("depth", depth, ALL)[0, 0].tolist() == tiles.RAMP[128].tolist()
    assert tiles.value_range(depth, ~ALL) == (0, 0)
    assert tiles.picture("depth", depth, ~ALL)[0, 0].tolist() == GROUND


@pytest.mark.parametrize("channels", [(), (2,), (3,)])
def test_a_high_buffer_is_coloured_whole(channels):
    """Some rows are coloured at a time; each pixel has the colour that it has alone, of the range of all rows."""
    generator = np.random.default_rng(3)
    values = generator.random((2 * tiles.ROWS + 5, 3, *channels), np.float32) - np.float32(0.1)
    values[0], values[-1] = 7, -8
    covered = generator.random(values.shape[:2]) < 0.7
    covered[[0, -1]] = True
    name = {0: "depth", 2: "uv", 3: "normal_world"}[sum(channels)]
    assert tiles.value_range(values, covered) == (-8, 7)
    shown = tiles.picture(name, values, covered)
    for row in range(len(values)):
        alone = tiles.picture(name, values[row : row + 1], covered[row : row + 1], (-8, 7))
        assert np.array_equal(shown[row : row + 1], alone), row


def sheet_of(result, path):
    overview.write_overview(path, result)
    return np.array(Image.open(path))


def tile_picture(sheet, index, columns, frame_height):
    left = overview.MARGIN + index % columns * (overview.TILE + overview.GAP)
    top = overview.HEADER + index // columns * (overview.PASS_LINE + frame_height + overview.CAPTION)
    return sheet[top + overview.PASS_LINE :, left:][:frame_height, : overview.TILE]


def test_sheet_shows_every_buffer_in_stage_order_upright(result, tmp_path):
    sheet = sheet_of(result, tmp_path / "x.png")
    height = overview.TILE * 32 // 48
    coverage = tile_picture(sheet, list(result.buffers).index("coverage"), 6, height)
    expected = np.array(Image.fromarray(result["coverage"][::-1] * np.uint8(255)).resize((overview.TILE, height), 0))
    assert np.array_equal((coverage == tiles.MASK).all(axis=-1), expected != 0)
    rows = -(-len(result.buffers) // 6)
    assert sheet.shape[0] == overview.HEADER + rows * (overview.PASS_LINE + height + overview.CAPTION) + 18


@pytest.mark.parametrize("keep", [["image"], ["depth"], ["scattered", "thickness"]])
def test_any_choice_of_buffers_has_a_sheet(scene_file, tmp_path, keep):
    result = render(load_scene(scene_file), interpreter="arrays", keep=keep)
    sheet = sheet_of(result, tmp_path / "x.png")
    assert sheet.shape[1] == 2 * overview.MARGIN + len(keep) * (overview.TILE + overview.GAP) - overview.GAP


SHEET = [  # six buffers in rows of four: where each word, line and picture goes, in pixels from the upper left corner
    ("text", (36, 26), "small", BRIGHT, 40),
    ("text", (160.0, 26), "screen space, preset paper, 48 x 32", SOFT, 20),
    ("text", (160.0, 51), "mesh tetrahedron.obj, shadow map 64 x 64, rules 2", FAINT, 17),
    ("box", (36, 132, 355, 134), (233, 174, 84)),
    ("text", (36, 104), "shadow_map", (233, 174, 84), 20),
    ("paste", (89, 142), (213, 213)),
    ("text", (36, 363), "light_distance", BRIGHT, 23),
    ("text", (36, 393), "4.691", SOFT, 18),
    ("paste", (91, 398), (72, 12)),
    ("text", (173, 393), "10.93", SOFT, 18),
    ("text", (36, 417), "scene units from the light", FAINT, 16),
    ("box", (376, 132, 695, 134), (92, 178, 224)),
    ("text", (376, 104), "camera", (92, 178, 224), 20),
    ("paste", (376, 142), (320, 213)),
    ("text", (376, 363), "triangle", BRIGHT, 23),
    ("text", (376, 393), "3 to 3", SOFT, 18),
    ("text", (376, 417), "triangle index in scene order", FAINT, 16),
    ("box", (696, 132, 1035, 134), (92, 178, 224)),
    ("paste", (716, 142), (320, 213)),
    ("text", (716, 363), "depth", BRIGHT, 23),
    ("text", (716, 393), "0.9556", SOFT, 18),
    ("paste", (780, 398), (72, 12)),
    ("text", (862, 393), "0.9637", SOFT, 18),
    ("text", (716, 417), "window depth of the camera's view, 0 to 1", FAINT, 15),
    ("box", (1036, 132, 1375, 134), (92, 178, 224)),
    ("paste", (1056, 142), (320, 213)),
    ("text", (1056, 363), "coverage", BRIGHT, 23),
    ("text", (1056, 393), "1 to 1", SOFT, 18),
    ("text", (1056, 417), "1 where the model is drawn", FAINT, 16),
    ("box", (36, 487, 355, 489), (92, 178, 224)),
    ("text", (36, 459), "camera", (92, 178, 224), 20),
    ("paste", (36, 497), (320, 213)),
    ("text", (36, 718), "thickness", BRIGHT, 23),
    ("text", (36, 748), "0", SOFT, 18),
    ("paste", (55, 753), (72, 12)),
    ("text", (137, 748), "0.006731", SOFT, 18),
    ("text", (36, 772), "scene units along the light's ray", FAINT, 16),
    ("box", (376, 487, 695, 489), (182, 146, 226)),
    ("text", (376, 459), "composite", (182, 146, 226), 20),
    ("paste", (376, 497), (320, 213)),
    ("text", (376, 718), "image", BRIGHT, 23),
    ("text", (376, 748), "0 to 0.8371", SOFT, 18),
    ("text", (376, 772), "linear RGB", FAINT, 16),
]


def test_everything_has_its_place_on_the_sheet(scene_file, tmp_path, monkeypatch):
    kept = ["light_distance", "coverage", "thickness", "image", "triangle", "depth"]
    result = render(load_scene(scene_file), interpreter="arrays", keep=kept)
    notes = noted(monkeypatch)
    assert sheet_of(result, tmp_path / "x.png").shape == (832, 1412, 3)
    assert notes == SHEET


@pytest.mark.parametrize(("height", "frame"), [(40, 400), (2, 160), (20, 400), (17, 340)])
def test_frames_are_neither_very_high_nor_very_low(scene_file, tmp_path, height, frame):
    """Half as high as wide at least, and a quarter higher than wide at most."""
    changes = {"camera.width": 16, "camera.height": height}
    result = render(load_scene(scene_file, **changes), interpreter="arrays", keep=["image"])
    assert sheet_of(result, tmp_path / "x.png").shape == (104 + 38 + frame + 104 + 18, 36 + 320 + 36, 3)


def test_a_tile_is_coloured_where_its_pass_drew(scene_file):
    """Also where that is the first triangle; a pass whose triangles were not kept, everywhere."""
    kept = ["triangle", "depth", "light_distance", "coverage", "scattered"]
    result = render(load_scene(scene_file), interpreter="arrays", keep=kept)
    triangle = np.full((32, 48), -1, np.int32)
    triangle[0, 0], triangle[5, 7] = 0, 3
    stencil = np.zeros((32, 48), np.uint8)
    stencil[2, 3] = 1
    changed = replace(result, buffers={**result.buffers, "triangle": triangle, "coverage": stencil})
    covered = {tile.name: tile.covered for tile in overview.tiles_of(changed)}
    assert np.array_equal(covered["depth"], triangle != -1) and np.array_equal(covered["triangle"], triangle != -1)
    assert np.array_equal(covered["scattered"], stencil == 1) and covered["light_distance"].all()


def tile_of(name, buffer):
    return overview.Tile(name, buffer, np.ones(buffer.shape[:2], bool), "camera", (1, 2, 3), True, srgb8)


def test_of_a_large_buffer_one_and_a_half_values_are_averaged_to_a_pixel():
    """Three times as large as its frame: every other row and column, where this one is 0 everywhere."""
    buffer = np.ones((639, 960), np.uint8)
    buffer[::2, ::2] = 0
    sheet = Image.new("RGB", (330, 220))
    overview._draw_picture(sheet, tile_of("coverage", buffer), (5, 4), (320, 213))
    shown = np.array(sheet)
    assert (shown[4:217, 5:325] == GROUND).all()
    assert not shown[:4].any() and not shown[217:].any() and not shown[:, :5].any() and not shown[:, 325:].any()


def test_a_long_unit_is_written_smaller(monkeypatch):
    """Its 55 letters are 302 pixels wide at size 11, at size 12 wider than the tile."""
    notes = noted(monkeypatch)
    overview._draw_caption(Image.new("RGB", (9, 9)), tile_of("light_visible", np.ones((2, 2, 3), np.float32)), (10, 20))
    assert notes[-1] == ("text", (10, 82), "share, 0 to 1, of the surface around that sees the light", FAINT, 11)


def test_each_pass_has_a_colour_of_its_own():
    orange, blue, red, green, violet = overview.ACCENTS
    assert (orange, blue, red) == ((233, 174, 84), (92, 178, 224), (226, 116, 132))
    assert (green, violet) == ((126, 200, 136), (182, 146, 226))
