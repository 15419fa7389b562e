"""What `sss-ref measure` traces, fits and prints; measuring has tests of its own."""

import math
from pathlib import Path
from types import SimpleNamespace

import pytest

from sss_ref.cli import main, measure_command
from sss_ref.yardstick.ladder_table import OVERALL

CELLS = [["burley", "+1.0%", "2%", "3%", "4%", "0.5", "0.6", "7%", "8%", "12"], ["noise", *"abcdefgh", ""]]


@pytest.fixture
def measured(monkeypatch):
    """Runs the command; what was traced, fitted and climbed."""
    seen = {}

    def traced(found, folder, samples, seconds, threads, _):
        seen["traced"] = (found, folder, samples, seconds, threads)
        return SimpleNamespace(samples=samples, lost=2)

    def fitted(volumes, photons, threads, diffuse, _):
        seen["fitted"] = (volumes, photons, threads, diffuse)
        return "fit"

    def climbed(of, radiance, chosen, fit, drawn, _):
        seen["climbed"] = (chosen, fit, drawn)
        return SimpleNamespace(of=of, radiance=radiance)

    def yardstick(scene, overrides, medium, border):
        left_out = run.left_out
        return SimpleNamespace(
            tracing=f"{scene} traced", volumes=medium, medium=medium, border=border, left_out=left_out
        )

    def run(*words, left_out=(), has_color=True):
        run.left_out = left_out
        monkeypatch.setattr("sss_ref.yardstick.color_difference.has_color_difference", lambda: has_color)
        return main(["measure", "wedge", *words])

    rooms = {
        "scene.load.load_scene": lambda name: name,
        "truth.material_fit.fitted_material": fitted,
        "truth.truth_folder.begun": lambda folder, tracing: (folder, tracing),
        "yardstick.ladder.climbed": climbed,
        "yardstick.ladder.drawn_image": lambda of, dump: f"{dump} drawn",
        "yardstick.ladder_folder.checked_folder": lambda folder: folder,
        "yardstick.ladder_folder.write_ladder": lambda ladder, folder: folder / "measure.html",
        "yardstick.ladder_table.rows": lambda ladder: CELLS,
        "yardstick.rungs.check_rungs": lambda of, chosen, fit: None,
        "yardstick.rungs.checked_methods": lambda names: names or ("all",),
        "yardstick.yardstick.Yardstick": yardstick,
        "yardstick.yardstick.medium_of": lambda scene, medium: medium,
        "cache.compiled.is_cold": lambda: False,
    }
    for name, stand_in in rooms.items():
        monkeypatch.setattr(f"sss_ref.{name}", stand_in)
    monkeypatch.setattr(measure_command, "traced", traced)
    run.seen = seen
    return run


def test_a_measurement_is_told_as_a_table_without_its_regions(measured, capsys):
    assert measured("--medium", "skin1", "-o", "out[1]", "--samples", "2") == 0
    told = capsys.readouterr()
    lines = [line.rstrip() for line in told.out.splitlines()]
    assert OVERALL == ("bias", "rms", "mean", "95 %", "dE", "dE 95 %")
    assert lines == [
        "truth: skin1, border entered, 2 samples a pixel, 2 lost",
        "",
        "  technique    bias   rms   mean   95 %    dE   dE 95 %   ms",
        f" {'─' * 60}",
        "  burley      +1.0%    2%     3%     4%   0.5       0.6   12",
        "  noise           a     b      c      d     e         f",
        "",
        "out[1]/measure.html: open it first",
    ]
    assert told.err == ""


def test_what_is_measured_unless_told_otherwise(measured):
    assert measured("--medium", "wax") == 0
    truth = Path("measure/truth")
    assert measured.seen == {
        "traced": ((truth, "wedge traced"), truth, 256, None, None),
        "fitted": ("wax", 100_000, None, True),
        "climbed": (("all",), "fit", None),
    }


def test_what_is_asked_for_is_measured(measured):
    words = ["--methods", "burley", "separable", "--dump", "drawn", "--no-fit", "--time-limit", "9", "--threads", "3"]
    assert measured("--medium", "wax", *words) == 0
    assert measured.seen["traced"][2:] == (256, 9.0, 3) and "fitted" not in measured.seen
    assert measured.seen["climbed"] == (("burley", "separable"), None, "drawn drawn")
    assert measured("--medium", "wax", "--photons", "1000", "--threads", "1", "--time-limit", "inf") == 0
    assert measured.seen["fitted"] == ("wax", 1000, 1, True) and measured.seen["traced"][3] == math.inf


def test_what_is_left_out_and_missing_is_said(measured, capsys):
    assert measured("--medium", "wax", left_out=["phong.ambient = 1", "a[1] = 2"], has_color=False) == 0
    first, second = capsys.readouterr().err.splitlines()
    assert first == "left out, as the truth has none: phong.ambient = 1, a[1] = 2"
    assert "sss_ref[metrics]" in second


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (("--samples", "1"), "--samples: expected at least 2, got 1"),
        (("--photons", "999"), "--photons: expected at least 1000, got 999"),
        (("--threads", "0"), "--threads: expected at least 1, got 0"),
    ],
)
def test_too_little_is_refused(words, line, measured, capsys):
    assert measured(*words) == 2
    assert line in capsys.readouterr().err and not measured.seen
