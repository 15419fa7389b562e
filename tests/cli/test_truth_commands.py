"""How long `sss-ref truth` goes on, and what it says, of tracings that are made up."""

import math
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace

import pytest

from sss_ref.cli import main, truth_commands
from sss_ref.cli.truth_commands import check_tracing, traced
from sss_ref.errors import SceneError

FOLDER = Path("folder")


@dataclass
class Radiance:
    """Stands in for what was traced so far; each sample takes a second of its clock."""

    samples: int = 0
    lost: int = 0
    clock: list = field(default_factory=lambda: [100.0])
    asked: list = field(default_factory=list)

    def more(self, samples, threads, seconds):
        self.asked.append((samples, threads, seconds))
        assert len(self.asked) < 20, "it does not end"
        self.clock[0] += samples
        return Radiance(self.samples + samples, 3, self.clock, self.asked)


@pytest.fixture
def written(monkeypatch):
    """The samples of each folder that was written."""
    found = []
    monkeypatch.setattr(
        "sss_ref.truth.truth_folder.write_truth", lambda folder, radiance: found.append((folder, radiance.samples))
    )
    return found


@pytest.mark.parametrize(
    ("before", "samples", "steps"),
    [(0, 1, [1]), (0, 8, [8]), (0, 9, [8, 1]), (0, 20, [8, 8, 4]), (5, 20, [8, 7]), (20, 20, []), (21, 20, [])],
)
def test_eight_samples_are_traced_at_a_time_and_each_time_is_written(before, samples, steps, written):
    shown, start = [], Radiance(before)
    found = traced(start, FOLDER, samples, None, 3, shown.append)
    assert start.asked == [(step, 3, math.inf) for step in steps]
    counts = [before + sum(steps[: k + 1]) for k in range(len(steps))]
    assert written == [(FOLDER, count) for count in counts]
    assert shown == [f"tracing: {count} of {samples} samples a pixel" for count in counts]
    assert found.samples == max(before, samples)


@pytest.mark.parametrize(
    ("before", "seconds", "asked"),
    [
        (0, 0.0, [(8, None, 0.0)]),  # two at least, or no error is known
        (1, 0.0, [(8, None, 0.0)]),
        (2, 0.0, []),
        (2, 8.0, [(8, None, 8.0)]),
        (2, 9.0, [(8, None, 9.0), (8, None, 1.0)]),
    ],
)
def test_no_sample_is_begun_when_the_time_is_up(before, seconds, asked, written, monkeypatch):
    start = Radiance(before)
    monkeypatch.setattr(truth_commands.time, "monotonic", lambda: start.clock[0])
    traced(start, FOLDER, 1000, seconds, None, str)
    assert start.asked == asked


@pytest.mark.parametrize(
    ("given", "option"),
    [
        ((0, 0, 1), "--samples: expected at least 1, got 0"),
        ((1, -1, 1), "--seed: expected at least 0, got -1"),
        ((1, 0, 0), "--threads: expected at least 1, got 0"),
    ],
)
def test_the_least_numbers_that_something_is_traced_with(given, option):
    check_tracing(1, 0, 1)
    check_tracing(1, 0, None)
    with pytest.raises(SceneError, match=option):
        check_tracing(*given)


def test_a_measurement_needs_two_samples():
    check_tracing(2, 0, 1, least=2)
    with pytest.raises(SceneError, match="--samples: expected at least 2, got 1"):
        check_tracing(1, 0, 1, least=2)


@pytest.fixture
def run(monkeypatch, written):
    """Runs the command on a scene of settings that are given; what was to be traced, and until when."""
    seen = []

    def running(*words, **settings):
        own = SimpleNamespace(settings=SimpleNamespace(**{"material": None, **settings}, model_fields_set={*settings}))
        monkeypatch.setattr("sss_ref.scene.load.load_scene", lambda name: own)
        return main(["truth", *words])

    def tracing(scene, volumes, border, seed):
        return (volumes, border, seed)

    def begun(folder, what):
        seen.append((folder, *what))
        return Radiance(1)

    mean = {"mean": [0.5, 0.25, 1.0], "mean_error": [0.001, 0.0, 0.0000004]}
    monkeypatch.setattr("sss_ref.truth.media.volumes", lambda name, where: f"{where} {name}")
    monkeypatch.setattr("sss_ref.truth.tracing.Tracing", tracing)
    monkeypatch.setattr("sss_ref.truth.truth_folder.begun", begun)
    monkeypatch.setattr("sss_ref.truth.truth_folder.recorded", lambda found: mean)
    running.seen = seen
    return running


def test_the_mean_is_told_with_its_error(run, capsys):
    assert run("-o", "new[bold]", "--medium", "wax", "--samples", "4", mm_per_unit=2.0) == 0
    told = capsys.readouterr()
    assert told.err == ""
    assert told.out == (
        "4 samples a pixel, 3 lost; mean radiance (red, green, blue) and standard error:\n"
        "0.500000 0.250000 1.000000 +- 0.001000 0.000000 0.000000\n"
        "new[bold]: open image.png first\n"
    )
    assert run.seen == [(Path("new[bold]"), "--medium wax", "matched", 0)]


def test_what_is_given_is_traced(run, written, capsys):
    """Without a unit, which is told, for a time, which is over after two samples."""
    words = ("--border", "entered", "--seed", "3", "--time-limit", "0")
    assert run(*words, material="marble") == 0
    assert run.seen == [(Path("truth"), "--medium marble", "entered", 3)] and written == [(Path("truth"), 9)]
    assert capsys.readouterr().err == "warning: the scene has no mm_per_unit; a unit is taken for 1 mm\n"


def test_without_a_limit_all_samples_are_traced(run, written):
    assert run("--medium", "wax", "--time-limit", "1e9", material="marble") == run("--medium", "wax") == 0
    assert [count for _, count in written][-1] == 64
    assert [medium for _, medium, *_ in run.seen] == ["--medium wax"] * 2


def test_a_body_is_of_some_medium(run, capsys):
    assert run() == 2
    assert "--medium: expected the name of a medium, got none and a scene without material" in capsys.readouterr().err
