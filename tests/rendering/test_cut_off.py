"""A note on an image that is too bright, and the exposure that it names."""

import numpy as np
import pytest
from PIL import Image
from scenes import around, cube, written

from sss_ref.rendering.cut_off import cut_off, too_bright
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


def test_a_pixel_like_the_background_in_two_channels_is_none():
    """Of four, two are background and one of the others is too bright."""
    background = (0.25, 0.5, 0.75)
    image = np.array([[background, background], [(2.0, 0.5, 0.75), (0.25, 0.5, 0.5)]], np.float32)
    (note,) = cut_off(Output(background=background), image)
    assert note.startswith("image: 50.0% of its pixels are brighter") and note.endswith("exposure = -1")
    image[1, 0] = 0.25, 2.0, 0.75
    (note,) = cut_off(Output(background=background), image)
    assert note.startswith("image: 50.0% of its pixels are brighter")


def test_one_percent_may_stay_white_with_the_exposure_it_names():
    """Of 9, 5 and 3 the first may: 2^2.4 is 5.3."""
    image = picture(3, 9.0)
    image[0, 1, 0], image[0, 2, 2] = 5.0, 3.0
    image[0, 1:3, 1] = 0.5
    (note,) = cut_off(Output(), image)
    assert note == (
        "image: 3.0% of its pixels are brighter than the picture can show and are cut off; set output.exposure = -2.4"
    )


def test_what_the_exposure_makes_too_bright():
    """Of one stop all above a half is; to show 0.75 takes 0.4."""
    assert [*cut_off(Output(exposure=1.0), picture(50, 0.5))] == []
    (note,) = cut_off(Output(exposure=1.0), picture(50, 0.75))
    assert note.startswith("image: 50.0% of its pixels") and note.endswith("; set output.exposure = 0.4")


@pytest.mark.parametrize(
    ("value", "told"), [(2.0**20, "set output.exposure = -20"), (1.001 * 2**20, "make the lights")]
)
def test_the_longest_exposure_that_can_be_set(value, told):
    (note,) = cut_off(Output(), picture(50, value))
    assert f"; {told}" in note


@pytest.mark.parametrize("shape", [(2, 5), (5, 2)])
def test_every_pixel_is_counted(shape):
    shown, brighter = too_bright(np.full((*shape, 3), 2, np.float32), np.zeros(3, np.float32), np.float32(1))
    assert (shown, brighter.tolist()) == (10, [2] * 10)
    shown, brighter = too_bright(np.full((*shape, 3), 2, np.float32), np.zeros(3, np.float32), np.float32(2))
    assert (shown, brighter.tolist()) == (10, [])
