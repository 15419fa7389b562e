"""Sliders drawn beforehand: where they stop, and that each picture is that of its value."""

import base64
import io
import re

import numpy as np
import pytest
from matplotlib import pyplot
from PIL import Image

from sss_ref.course import figures, frames


@pytest.fixture(autouse=True)
def no_window(monkeypatch):
    monkeypatch.setenv(frames.WANTED, "1")
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")


def gray(level, tint):
    figure, (axes,) = figures.row(1)
    figures.picture(axes, np.full((4, 4, 3), [level, level, tint], np.float32), "")
    return figure


def middle(address):
    image = Image.open(io.BytesIO(base64.b64decode(address.removeprefix("data:image/webp;base64,"))))
    return image.getpixel((image.width // 2, image.height // 2))


def attributes(page, name):
    return re.findall(f' {name}="([^"]*)"', page)


@pytest.mark.parametrize(
    ("numbers", "expected"),
    [
        ((0.0, 0.5, 1.0, 0.01), [0.0, 0.17, 0.33, 0.5, 0.67, 0.83, 1.0]),
        ((0.0, 0.25, 4.0, 0.01), [0.25, 0.67, 1.33, 2.0, 2.67, 3.33, 4.0]),  # the first value in the place of 0
        ((-180.0, 60.0, 180.0, 1.0), [-180, -120, -60, 0, 60, 120, 180]),
        ((1.0, 1.0, 1.5, 0.25), [1.0, 1.25, 1.5]),  # what falls on the same step once
    ],
)
def test_a_slider_stops_evenly_and_at_its_first_value(numbers, expected):
    assert frames.stops(*numbers) == pytest.approx(expected, abs=1e-12)
    assert numbers[1] in frames.stops(*numbers)


def test_each_picture_is_drawn_for_its_value_and_the_first_of_the_others():
    page = figures.Sliders(gray, level=(0.0, 0.5, 1.0), tint=(0.0, 0.0, 1.0))._repr_mimebundle_()["text/html"]
    of_level, of_tint = (each.split() for each in attributes(page, "data-pictures"))
    levels, tints = (each.split() for each in attributes(page, "data-values"))
    assert len(of_level) == len(levels) == len(of_tint) == len(tints) == frames.COUNT
    assert middle(of_level[0])[0] < 4 and middle(of_level[-1])[0] > 251 and middle(of_level[-1])[2] < 4
    assert abs(middle(of_tint[-1])[0] - 188) < 4 and middle(of_tint[-1])[2] > 251
    assert attributes(page, "data-first") == ["3", "0"]
    assert of_level[3] == of_tint[0] == attributes(page, "src")[0]  # what is shown to begin with


def test_a_page_names_its_sliders_safely():
    page = frames.page(lambda values: png(values["a<b"]), {"a<b": (0.0, 0.0, 1.0, 0.1)})
    assert "a&lt;b" in page and "a<b" not in page and frames.ONE in page


def png(level):
    target = io.BytesIO()
    Image.new("RGB", (2, 2), (round(255 * level),) * 3).save(target, "PNG")
    return target.getvalue()


PAGE = """<figure class="sliders">
<label>a<input type="range" min="0" max="6" value="2" data-first="2"
 data-values="0 0.5 1.25 1.5 2 2.5 3" data-pictures="0,7 0.5,7 1.25,7 1.5,7 2,7 2.5,7 3,7"><output>1.25</output></label>
<label>b<input type="range" min="0" max="6" value="6" data-first="6"
 data-values="1 2 3 4 5 6 7" data-pictures="1.25,1 1.25,2 1.25,3 1.25,4 1.25,5 1.25,6 1.25,7"><output>7</output></label>
<img src="1.25,7" alt="a, b">
<figcaption>Drawn beforehand: one slider at a time; in Jupyter they move together.</figcaption>
</figure>"""


def test_a_page_of_two_sliders(monkeypatch):
    """The first values are drawn once, and shown by both and to begin with."""
    drawn = []

    def draw(values):
        drawn.append(f"{values['a']:g},{values['b']:g}")
        return drawn[-1]

    monkeypatch.setattr(frames, "webp", str)
    assert frames.page(draw, {"a": (0.0, 1.25, 3.0, 0.25), "b": (1.0, 7.0, 7.0, 1.0)}) == PAGE
    assert len(drawn) == len(set(drawn)) == 13


def test_pictures_are_small():
    """WebP of the quality 82."""
    source = Image.fromarray(np.arange(48 * 48 * 3, dtype=np.uint8).reshape(48, 48, 3))
    pixels, expected = io.BytesIO(), io.BytesIO()
    source.save(pixels, "PNG")
    source.save(expected, "WEBP", quality=82)
    assert frames.webp(pixels.getvalue()) == "data:image/webp;base64," + base64.b64encode(expected.getvalue()).decode()
