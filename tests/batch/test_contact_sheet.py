import numpy as np
import pytest
from noted_sheet import noted
from PIL import Image

from sss_ref.batch.contact_sheet import CAPTION, GAP, LEAST, write_contact_sheet


def test_every_picture_has_a_tile_row_by_row(tmp_path):
    paths = []
    for number in range(5):
        paths.append(tmp_path / f"{number}.png")
        Image.new("RGB", (120, 100), (40 * number + 50, 0, 0)).save(paths[-1])
    write_contact_sheet(tmp_path / "sheet.png", paths, ["a caption that is far too long for a tile"] * 5)
    with Image.open(tmp_path / "sheet.png") as sheet:
        pixels = np.asarray(sheet)
    assert pixels.shape == (GAP + 2 * (100 + CAPTION + GAP), GAP + 3 * (120 + GAP), 3)
    assert pixels.shape[1] > LEAST
    for number in range(5):
        row, column = divmod(number, 3)
        middle = pixels[GAP + row * (100 + CAPTION + GAP) + 50, GAP + column * (120 + GAP) + 60]
        assert tuple(middle) == (40 * number + 50, 0, 0)
    between = pixels[GAP + 100 + 4 : GAP + 100 + CAPTION, GAP + 120 : GAP + 120 + GAP]
    assert (between == pixels[0, 0]).all()  # a caption ends with its tile


SOFT = (158, 164, 176)


def test_everything_has_its_place_on_the_sheet(tmp_path, monkeypatch):
    """A tile is 200 x 100, as the first picture has it; others stand in the middle of theirs."""
    paths = [tmp_path / f"{number}.png" for number in range(3)]
    for path, size in zip(paths, [(300, 150), (40, 120), (96, 97)], strict=True):
        Image.new("RGB", size).save(path)
    notes = noted(monkeypatch)
    write_contact_sheet(tmp_path / "sheet.png", paths, ["one", "two", "a caption that is far too long for a tile"])
    assert notes == [
        ("paste", (12, 12), (200, 100)),
        ("text", (12, 116), "one", SOFT, 15),
        ("paste", (307, 12), (33, 100)),
        ("text", (224, 116), "two", SOFT, 15),
        ("paste", (64, 151), (96, 97)),
        ("text", (12, 254), "a caption that is far t...", SOFT, 15),  # 26 letters of 7.5 pixels, of 27 too many
    ]
    with Image.open(tmp_path / "sheet.png") as sheet:
        assert sheet.size == (436, 288)


@pytest.mark.parametrize(("letters", "shown"), [(20, "c" * 20), (21, f"{'c' * 17}...")])
def test_a_caption_is_as_wide_as_its_tile_at_most(tmp_path, monkeypatch, letters, shown):
    """20 letters of 7.5 pixels are 150."""
    Image.new("RGB", (150, 100)).save(tmp_path / "a.png")
    notes = noted(monkeypatch)
    write_contact_sheet(tmp_path / "sheet.png", [tmp_path / "a.png"], ["c" * letters])
    assert [words for kind, _, words, *_ in notes if kind == "text"] == [shown]


@pytest.mark.parametrize(("count", "step"), [(400, 1), (401, 2)])
def test_of_many_pictures_evenly_chosen_ones_are_shown(tmp_path, monkeypatch, count, step):
    Image.new("RGB", (2, 2)).save(tmp_path / "a.png")
    notes = noted(monkeypatch)
    write_contact_sheet(tmp_path / "sheet.png", [tmp_path / "a.png"] * count, [f"{number}" for number in range(count)])
    captions = [words for kind, _, words, *_ in notes if kind == "text"]
    assert captions == [f"{number}" for number in range(0, count, step)]
