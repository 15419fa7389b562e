"""A note on an image that is too bright, and the exposure that it names."""

import numpy as np
import pytest
from PIL import Image
from scenes import around, cube, written

from sss_ref.rendering.cut_off import cut_off
from sss_ref.rendering.fold import render
from sss_ref.scene import load_scene
from sss_ref.scene_file.settings import Output


def picture(bright, value, background=0.0):
    """20 x 10 pixels, half of them background, `bright` of the others with one channel at `value`."""
    image = np.full((20, 10, 3), background, np.float32)
    image[:10] = 0.5
    image.reshape(-1, 3)[:bright, 1] = value
    return image


def test_one_percent_of_what_is_no_background_may_be_white():
    assert [*cut_off(Output(), picture(1, 9.0))] == []
    assert [*cut_off(Output(), picture(100, 1.0))] == []
    assert [*cut_off(Output(), picture(2, 9.0))] == [
        "image: 2.0% of its pixels are brighter than the picture can show and are cut off; set output.exposure = -3.2"
    ]


def test_a_background_may_be_white_too():
    white = Output(background=(9.0, 9.0, 9.0))
    assert [*cut_off(white, picture(1, 9.0, background=9.0))] == []
    assert [*cut_off(white, np.full((2, 2, 3), 9, np.float32))] == []


@pytest.mark.parametrize("value", [1.5, 2.0, 3.0, 700.0])
def test_with_the_exposure_it_names_the_note_is_gone(value):
    (note,) = cut_off(Output(), picture(50, value))
    stops = float(note.rpartition("= ")[2])
    assert [*cut_off(Output(exposure=stops), picture(50, value))] == []
    assert [*cut_off(Output(exposure=stops + 0.2), picture(50, value))] != []


def test_what_no_exposure_helps():
    (note,) = cut_off(Output(), picture(50, 1e30))
    assert note.endswith("make the lights fainter")


def test_no_buffer_depends_on_the_exposure(tmp_path):
    """The picture is an eighth as bright: 3 stops."""
    tables = around(written(tmp_path / "cube.obj", *cube()), 24, phong={"ambient": 5.0})
    dark, bright = (
        render(load_scene(tables, **{"output.exposure": stops}), "arrays", keep=["image"]) for stops in (-3.0, 0.0)
    )
    assert dark.hashes == bright.hashes
    assert [note.partition(":")[0] for note in bright.notes] == ["image"] and dark.notes == ()
    files = [result.save(tmp_path / name) / "image.png" for name, result in (("dark", dark), ("bright", bright))]
    codes = [np.asarray(Image.open(file)) for file in files]
    assert (codes[0] < codes[1]).any() and not (codes[0] > codes[1]).any()
