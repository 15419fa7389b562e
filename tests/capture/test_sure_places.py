"""How sure a place must be, and which row most files begin with, by candidates that are given."""

from types import SimpleNamespace

import pytest

from sss_ref.capture import placing
from sss_ref.capture.candidate import Candidate


def at(score, origin="top"):
    return Candidate(0, "a", score, 0.0, (2, 0), origin, 1.0, 1.0, {"scale": 2.0})


@pytest.mark.parametrize(("score", "margin"), [(1.0, 0.05), (0.5, 0.125), (0.0, 0.2)])
def test_what_fits_badly_needs_a_wider_margin(score, margin):
    assert placing.needed(at(score)) == pytest.approx(margin)


def test_the_surest_places_come_first():
    assert placing.STEPS == (0.85, 0.6, 0.45, 0.35) and placing.ASKED == 0.3


def placed(*origins):
    def keys(channels, origin):
        return {"file": "x.npy", "origin": origin}

    surface = SimpleNamespace(channels=("R", "G", "B"), keys=keys)
    places = {f"{k}": placing.Placement(surface, at(1.0, origin), 0.1) for k, origin in enumerate(origins)}
    return placing.Arrangement(places, (), ())


@pytest.mark.parametrize(
    ("origins", "usual"),
    [
        (("top", "top", "bottom"), "top"),
        (("bottom", "bottom", "top"), "bottom"),
        (("top", "bottom"), "top"),
        ((), "top"),
    ],
)
def test_the_row_that_most_files_begin_with(origins, usual):
    assert placed(*origins).usual_origin == usual


def test_what_a_mapping_file_says_of_a_place():
    (only,) = placed("bottom").placements.values()
    assert only.channel_names == ["B", "R"]
    assert (only.table.file, only.table.origin, only.table.scale) == ("x.npy", "bottom", 2.0)
