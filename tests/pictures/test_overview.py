import numpy as np
import pytest
from PIL import Image

from sss_ref.pictures import overview, tiles
from sss_ref.pictures.png_file import srgb8
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

ALL = np.ones((2, 2), bool)
GROUND = list(tiles.GROUND)


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
