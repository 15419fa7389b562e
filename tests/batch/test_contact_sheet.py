import numpy as np
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
