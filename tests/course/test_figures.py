"""The course's sliders redraw their figure, and leave a picture for readers without widgets."""

import base64
import io
from pathlib import Path

import numpy as np
import pytest
from drawn_figure import told
from matplotlib import pyplot
from matplotlib.colors import to_hex
from PIL import Image
from small_figures import FIGURES, figure_of

from sss_ref.course import figures
from sss_ref.pictures.tiles import RAMP


@pytest.fixture(autouse=True)
def no_window():
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")


def gray(level):
    figure, (axes,) = figures.row(1)
    figures.picture(axes, np.full((4, 4, 3), level, np.float32), "")
    return figure


def middle(png):
    image = Image.open(io.BytesIO(png)).convert("RGB")
    return image.getpixel((image.width // 2, image.height // 2))


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_a_picture_of_any_float_type_is_encoded(kind):
    _, (axes,) = figures.row(1)
    figures.picture(axes, np.full((4, 4, 3), 0.5, kind), "")
    assert np.array_equal(axes.images[0].get_array(), np.full((4, 4, 3), 188))


def test_a_moved_slider_redraws_the_figure():
    sliders = figures.Sliders(gray, level=(0.0, 0.0, 1.0))
    assert middle(sliders.shown.value) == (0, 0, 0)
    sliders.controls["level"].value = 1.0
    assert middle(sliders.shown.value) == (255, 255, 255)


def test_without_widgets_the_first_picture_is_shown():
    bundle = figures.Sliders(gray, level=(0.0, 1.0, 1.0))._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in bundle
    assert middle(base64.b64decode(bundle["image/png"])) == (255, 255, 255)
    assert bundle["image/png"] in bundle["text/html"]
    assert "with sliders for level." in bundle["text/html"]


def test_no_figure_stays_open_behind_the_sliders():
    figures.Sliders(gray, level=(0.0, 0.5, 1.0))
    assert pyplot.get_fignums() == []


def test_row_0_is_at_the_bottom():
    image = np.zeros((2, 1, 3), np.float32)
    image[1] = 1.0  # the upper row is white
    figure, (axes,) = figures.row(1)
    figures.picture(axes, image, "")
    figure.canvas.draw()
    assert axes.transData.transform((0, 1))[1] > axes.transData.transform((0, 0))[1]


DRAWN = (Path(__file__).with_name("figures.txt")).read_text(encoding="utf-8").split("\n\n")


@pytest.mark.parametrize(("name", "expected"), [*zip(FIGURES, DRAWN, strict=True)], ids=FIGURES)
def test_every_kind_of_figure_has_its_lines_and_colours(name, expected):
    """What is on each was looked at; where a figure is meant to change, tests/support/small_figures.py says how."""
    assert "\n".join([f"[{name}]", *told(figure_of(name))]) == expected.strip()


def test_titles_are_a_little_larger_than_what_is_written():
    assert (pyplot.rcParams["axes.titlesize"], pyplot.rcParams["font.size"]) == (10.5, 10)


@pytest.mark.parametrize(
    ("low", "high", "step"), [(0.0, 1.0, 0.01), (0.0, 0.99, 0.001), (-100.0, 150.0, 1.0), (1.0, 11.0, 0.1)]
)
def test_a_slider_has_a_hundred_steps_or_more_of_a_power_of_ten(low, high, step):
    control = figures.Sliders(lambda level: figures.row(1)[0], level=(low, low, high)).controls["level"]
    assert (control.min, control.max, control.step) == (low, high, pytest.approx(step))


def test_colours_from_low_to_high_values():
    """The ends and the middle of overview.png's colours; where nothing is drawn it is a light gray."""
    assert [to_hex(figures.RISING(value)) for value in (0.0, 0.5, 1.0)] == [
        "#{:02x}{:02x}{:02x}".format(*RAMP[k]) for k in (0, 128, 255)
    ]
    assert to_hex(figures.RISING(np.nan)) == to_hex(figures.SIGNED(np.nan)) == "#e9eaee"
    assert to_hex(figures.SIGNED(0.0)) == "#053061" and to_hex(figures.SIGNED(1.0)) == "#67001f"


def test_a_figure_is_as_wide_as_it_is_high_unless_it_is_said():
    assert figures.row(1)[0].get_size_inches().tolist() == [3.3, 3.3]
    assert figures.row(3, 2.0)[0].get_size_inches().tolist() == [6, 2]
