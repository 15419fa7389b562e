"""What `sss-ref batch` and `turntable` ask for and print; batches have tests of their own."""

import io
import os
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace

import pytest
from rich.console import Console

from sss_ref.batch.executors import serially
from sss_ref.batch.plan import WHOLE, Shard
from sss_ref.batch.workshop import ItemOutcome
from sss_ref.cli import batch_commands, main

SWEEP = 'outputs = ["png", "npz"]\nvary.camera.azimuth = [0, 30.5, 90]\nvary.lights.0.color = [[1, 2, 3]]'
ARCHIVES = 'outputs = ["npz"]\nvary.camera.azimuth = [0, 30]'


class Batches:
    """Runs the command with the rooms below replaced by what tells how it was called."""

    def __init__(self, folder, monkeypatch):
        self.folder, self.seen, self.made, self.outcomes = folder, [], [], None
        monkeypatch.chdir(folder)
        monkeypatch.setattr("sss_ref.batch.run.run", self.run)
        monkeypatch.setattr("sss_ref.batch.executors.in_processes", lambda count: f"{count} processes")
        monkeypatch.setattr("sss_ref.batch.cluster.on_cluster", self.on_cluster)
        monkeypatch.setattr("sss_ref.batch.film.has_encoder", lambda: self.has_encoder)
        monkeypatch.setattr("sss_ref.batch.film.write_films", self.write_films)
        monkeypatch.setattr("sss_ref.batch.contact_sheet.write_contact_sheet", self.write_contact_sheet)
        monkeypatch.setattr("sss_ref.cache.compiled.is_cold", lambda: False)
        monkeypatch.setattr(os, "cpu_count", lambda: self.processors)
        self.has_encoder, self.processors, self.cameras = True, 4, None

    def __call__(self, *words, sweep=SWEEP):
        (self.folder / "sweep.toml").write_text(sweep)
        return main([*words])

    def run(self, wanted, output, execution, part, tell):
        self.seen.append((output, execution.executor, execution.interpreter, execution.threads, part))
        outcomes = self.outcomes or [ItemOutcome(k, "rendered", f"{k}{k}aa") for k in part.of(3)]
        tables = (output / "items.csv", output / "items.parquet")
        return SimpleNamespace(
            folder=output, outcomes=outcomes, tables=tables, cameras=self.cameras,
            of_state=lambda state: [each for each in outcomes if each.state == state],
        )  # fmt: skip

    @contextmanager
    def on_cluster(self, address):
        yield f"cluster {address}"

    def write_films(self, folder, stem, pictures, rate):
        self.made.append((folder, stem, pictures, rate))
        return [folder / f"{stem}.gif"]

    def write_contact_sheet(self, path, pictures, captions):
        self.made.append((path, captions))


@pytest.fixture
def batches(tmp_path, monkeypatch):
    return Batches(tmp_path, monkeypatch)


OUT = Path("out[1]")


@pytest.mark.parametrize(
    ("words", "processors", "executor", "threads", "part"),
    [
        ((), 4, "3 processes", 1, WHOLE),
        ((), 2, "2 processes", 1, WHOLE),
        ((), 1, serially, None, WHOLE),
        ((), None, serially, None, WHOLE),
        (("--jobs", "2"), 4, "2 processes", 1, WHOLE),
        (("--jobs", "2", "--threads", "3"), 4, "2 processes", 3, WHOLE),
        (("--jobs", "1"), 4, serially, None, WHOLE),
        (("--jobs", "1", "--threads", "3"), 4, serially, 3, WHOLE),
        (("--shard", "2/2"), 4, serially, None, Shard(2, 2)),
        (("--shard", "1/2"), 4, "2 processes", 1, Shard(1, 2)),
        (("--dask", "tcp://x"), 4, "cluster tcp://x", 1, WHOLE),
        (("--dask", "tcp://x", "--threads", "2"), 4, "cluster tcp://x", 2, WHOLE),
    ],
)
def test_who_renders(words, processors, executor, threads, part, batches, capsys):
    batches.processors = processors
    assert batches("batch", "sweep.toml", "-o", str(OUT), *words) == 0
    assert batches.seen == [(OUT, executor, "kernel", threads, part)]
    count = len(part.of(3))
    assert capsys.readouterr().out == f"{count} rendered, 0 were there, 0 failed: out[1]/items.csv\n"
    assert not batches.made


def test_a_batch_without_pictures_needs_no_film(batches):
    assert batches("batch", "sweep.toml", sweep=ARCHIVES) == 0
    assert batches("batch", "sweep.toml", "--video", "24", sweep=ARCHIVES) == 2
    assert [output for output, *_ in batches.seen] == [Path("batch")]


def test_films_and_a_sheet_are_made_of_what_did_not_fail(batches, capsys):
    batches.outcomes = [ItemOutcome(0, "rendered", "00aa"), ItemOutcome(1, "failed"), ItemOutcome(2, "there", "22aa")]
    batches.cameras, batches.has_encoder = OUT / "transforms.json", False
    assert batches("batch", "sweep.toml", "-o", str(OUT), "--video", "24") == 1
    pictures = [OUT / "items" / name[:2] / name / "image.png" for name in ("00aa", "22aa")]
    sheet = OUT / "contact_sheet.png"
    assert batches.made == [(OUT, "batch", pictures, 24), (sheet, ["0, [1, 2, 3]", "90, [1, 2, 3]"])]
    told = capsys.readouterr()
    assert told.out.splitlines() == [
        "1 rendered, 1 were there, 1 failed: out[1]/items.csv, out[1]/transforms.json",
        "out[1]/batch.gif, out[1]/contact_sheet.png",
    ]
    assert told.err.splitlines() == [
        "failed: item 1: ",
        "no MP4, which needs the extra: python -m pip install 'sss_ref[video]'",
    ]


def test_a_turn_has_films_and_nothing_is_missing_with_the_extra(batches, capsys):
    assert batches("turntable", "wedge", "--frames", "3", "--fps", "100", "-o", str(OUT)) == 0
    assert [what[1:] for what in batches.made] == [
        ("turntable", [OUT / "items" / f"{k}{k}" / f"{k}{k}aa" / "image.png" for k in range(3)], 100),
        (batches.made[1][1],),
    ]
    assert [len(caption.split()) for caption in batches.made[1][1]] == [1, 1, 1]
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (("--dask", "tcp://x", "--jobs", "2"), "--dask: expected without --jobs, got both; the cluster knows"),
        (("--jobs", "0"), "--jobs: expected at least 1, got 0; leave it out for one per processor"),
        (("--video", "101"), "pictures per second: expected 1 to 100, got 101; 24 looks smooth"),
        (("--video", "0"), "pictures per second: expected 1 to 100, got 0; 24 looks smooth"),
    ],
)
def test_what_does_not_go_together_is_told_before_anything_is_rendered(words, line, batches, capsys):
    assert batches("batch", "sweep.toml", *words) == 2
    assert line in " ".join(capsys.readouterr().err.split()) and not batches.seen


@pytest.mark.parametrize("rate", ["1", "100"])
def test_the_ends_of_how_fast_a_film_is(rate, batches):
    assert batches("batch", "sweep.toml", "--video", rate) == 0


OF_25 = [3, 5, 8, 10, 13, 15, 18, 20, 23, 25]


@pytest.mark.parametrize(("items", "told_at"), [(3, [1, 2, 3]), (10, range(1, 11)), (25, OF_25)])
def test_progress_is_a_line_at_every_tenth(items, told_at, capsys):
    with batch_commands._progress(items) as tell:
        for item in range(items):
            tell(ItemOutcome(item, "failed" if item % 2 else "rendered"))
    lines = [line.partition(", about")[0] for line in capsys.readouterr().err.splitlines()]
    assert lines == [f"{done} of {items} items, {done // 2} failed" for done in told_at]


def test_progress_is_a_bar_on_a_terminal(monkeypatch):
    shown = io.StringIO()
    monkeypatch.setattr(batch_commands, "err", Console(file=shown, force_terminal=True, width=100))
    with batch_commands._progress(4) as tell:
        for item in range(3):
            tell(ItemOutcome(item, "rendered"))
        tell(ItemOutcome(3, "failed"))
    assert "4/4" in shown.getvalue() and "1 failed" in shown.getvalue() and "4 of 4 items" not in shown.getvalue()


def test_two_failures_are_told_apart(batches, capsys):
    batches.outcomes = [
        ItemOutcome(0, "failed", message="item 0: no [light]"),
        ItemOutcome(1, "failed", message="no mesh"),
        ItemOutcome(2, "failed", message="item 2: no [light]"),
    ]
    assert batches("batch", "sweep.toml") == 1
    assert capsys.readouterr().err.splitlines() == ["failed: item 0, 2: no [light]", "failed: item 1: no mesh"]
