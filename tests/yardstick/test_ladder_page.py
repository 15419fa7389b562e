"""The page of a ladder whose numbers are given."""

import re

import pytest
from known_ladder import MASKS, known, off

from sss_ref.yardstick import ladder_page
from sss_ref.yardstick.color_difference import MISSING
from sss_ref.yardstick.ladder_page import as_html


def tables(page):
    """Of each table its rows, and of each row its kind and cells."""
    found = re.findall("<table>(.*?)</table>", page, re.DOTALL)
    return [
        [
            (re.match('<tr(?: class="(.*?)")?>', row)[1], re.findall("<t[hd][^>]*>(.*?)</t[hd]>", row))
            for row in re.findall("<tr.*?</tr>", table)
        ]
        for table in found
    ]


def test_what_was_measured_is_said_first():
    page = as_html(known())
    facts = re.findall("<span>(.*?)</span>", page)[:6]
    assert facts == [
        *("medium skin1", "12.5 mm a unit", "border entered", "3 x 2 pixels", "64 samples a pixel, 3 lost"),
        "diffusion length 1.26 mm",
    ]
    assert "<h1>head &lt;1&gt;: how far from the truth?</h1>" in page
    assert "as the truth has none: phong.ambient = 0.1, phong.specular = 0.2." in page


def test_how_far_off_each_is_overall_and_in_each_region():
    overall, by_region = tables(as_html(known()))
    assert overall == [
        (None, ["", "bias", "rms", "mean", "95 %", "dE", "dE 95 %", "ms of one processor"]),
        ("beside", ["noise of the truth", "-1.0%", "2.0%", "1.0%", "3.0%", "4.0", "8.0", ""]),
        ("beside", ["GPU against the oracle", "-0.0%", "0.0%", "0.0%", "0.0%", "4.0", "8.0", ""]),
        ("", ["burley, shipped", "-25.0%", "50.0%", "25.0%", "75.0%", "4.0", "8.0", "12"]),
        ("", ["burley, fitted", "-12.5%", "25.0%", "12.5%", "37.5%", "4.0", "8.0", "100"]),
    ]
    assert by_region == [
        (None, ["", "everywhere", "lit", "dark"]),
        ("beside", ["noise of the truth", "1.0%", "2.0%", "3.0%"]),
        ("beside", ["GPU against the oracle", "0.0%", "0.0%", "0.0%"]),
        ("", ["burley, shipped", "25.0%", "50.0%", "75.0%"]),
        ("", ["burley, fitted", "12.5%", "25.0%", "37.5%"]),
    ]
    assert [len(table) for table in tables(as_html(known(gpu=False)))] == [4, 4]


def test_an_error_of_a_half_has_the_deepest_colour():
    shares = re.findall('--share: (.*?)"', as_html(known(gpu=False)))
    assert shares == ["0.01", "0.02", "0.04", "0.30", "0.60", "0.60", "0.15", "0.30", "0.45"]


def test_each_technique_has_three_pictures_and_the_regions_are_counted():
    page = as_html(known())
    assert re.findall("<figcaption>(.*?)</figcaption>", page) == [
        "the regions; of several the last in the list",
        *["burley", "truth", "difference"] * 2,
    ]
    assert re.findall("</i><b>(.*?)</b> (.*?):", page) == [
        ("everywhere", "(5 pixels)"),
        ("lit", "(2 pixels)"),
        ("dark", "(1 pixels)"),
    ]
    assert "<span>20% of white too dark</span>" in page and "<span>too bright</span>" in page


@pytest.mark.parametrize("has", [True, False])
def test_colours_that_are_not_told_are_said(monkeypatch, has):
    monkeypatch.setattr(ladder_page, "has_color_difference", lambda: has)
    found = known()
    found.of.left_out = []
    page = as_html(found)
    assert ("delta E 2000 is not told" in page) == (not has) and "Left out" not in page
    assert MISSING.startswith("delta E 2000") and off(0.5).pixels == 5 and len(MASKS) == 3
