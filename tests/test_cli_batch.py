import os
import re
import subprocess
import sys

import pytest
from PIL import Image

from sss_ref.batch.executors import serially
from sss_ref.batch.film import has_encoder
from sss_ref.batch.run import Batch
from sss_ref.batch.workshop import ItemOutcome
from sss_ref.cli import batch_commands, main
from sss_ref.cli.batch_commands import _executor, _told

SWEEP = """
scene = "scene.toml"
set = {camera = {width = 32, height = 24}, shadow_map = {width = 32, height = 32}}
[vary]
camera.fov_y = [30, 400, 40, 500, 400]
"""
SCENE = """
mesh = {path = "sphere"}
camera = {type = "orbit", distance = 5}
lights = [{position = [0, 0, 9]}]
"""


@pytest.fixture
def sweep(tmp_path, monkeypatch):
    (tmp_path / "scene.toml").write_text(SCENE)
    (tmp_path / "sweep.toml").write_text(SWEEP)
    monkeypatch.chdir(tmp_path)
    return "sweep.toml"


def test_a_failing_item_is_told_at_the_end_and_the_rest_is_done(sweep, tmp_path, capsys):
    assert main(["batch", sweep, "-o", "out", "--jobs", "1", "--interpreter", "arrays"]) == 1
    told = capsys.readouterr()
    lines = told.err.splitlines()
    assert lines[-2].startswith("failed: item 1, 4: override: camera.fov_y: expected an angle between 0 and 180")
    assert lines[-1].startswith("failed: item 3: override: camera.fov_y:")
    assert re.fullmatch(r"5 of 5 items, 3 failed", lines[-3])
    assert told.out == f"2 rendered, 0 were there, 3 failed: {tmp_path / 'out' / 'items.csv'}\n"
    assert (tmp_path / "out" / "items.csv").read_text().count("\n") == 6


def test_items_that_fail_alike_are_told_once(tmp_path, capsys):
    """Also where the message begins with the item's number."""
    failed = tuple(ItemOutcome(n, "failed", message=f"item {n}: expected a picture, got none; a") for n in (0, 2))
    assert _told(Batch(tmp_path, failed, (tmp_path / "items.csv",))) == 1
    assert capsys.readouterr().err == "failed: item 0, 2: expected a picture, got none; a\n"


def test_a_second_run_renders_what_is_missing(sweep, tmp_path, capsys):
    (tmp_path / sweep).write_text(SWEEP.replace("400", "50").replace("500", "60"))
    assert main(["batch", sweep, "-o", "out", "--interpreter", "arrays", "--shard", "1/2", "--jobs", "1"]) == 0
    assert capsys.readouterr().out.startswith("3 rendered, 0 were there, 0 failed: ")
    assert main(["batch", sweep, "-o", "out", "--interpreter", "arrays", "--jobs", "1"]) == 0
    assert capsys.readouterr().out.startswith("1 rendered, 4 were there, 0 failed: ")  # item 4 is item 1 again
    assert {"items-1-of-2.csv", "items.csv"} < {*os.listdir("out")}


def test_several_processes_have_one_thread_each_unless_told_otherwise():
    assert _executor(1, 10, None) == (serially, None)
    assert _executor(4, 1, 3) == (serially, 3)
    assert _executor(4, 10, None)[1] == 1 and _executor(4, 10, 2)[1] == 2
    assert _executor(4, 10, None)[0] is not serially


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["no.toml"], "no.toml: expected a sweep file, got No such file or directory; check the path"),
        (["sweep.toml", "--jobs", "0"], "--jobs: expected at least 1, got 0; leave it out for one per processor"),
        (["sweep.toml", "--shard", "3/2"], "--shard: expected NUMBER/COUNT, NUMBER from 1 to COUNT, got '3/2'"),
        (["sweep.toml", "-o", "."], "expected a new folder, an empty one or an earlier batch, got other files"),
    ],
)
def test_bad_input_is_told_in_one_message(sweep, capsys, arguments, message):
    assert main(["batch", *arguments]) == 2
    told = capsys.readouterr()
    assert message in " ".join(told.err.split()) and told.out == "" and "Traceback" not in told.err
    assert sorted(os.listdir()) == ["scene.toml", "sweep.toml"]


def test_progress_is_told_at_every_tenth_where_there_is_no_terminal(capsys):
    from sss_ref.batch.workshop import ItemOutcome

    with batch_commands._progress(40) as tell:
        for item in range(40):
            tell(ItemOutcome(item, "rendered"))
    lines = capsys.readouterr().err.splitlines()
    assert [line.split(",")[0] for line in lines] == [f"{4 * tenth} of 40 items" for tenth in range(1, 11)]
    assert re.fullmatch(r"36 of 40 items, 0 failed, about \d+ s left", lines[-2])


def test_it_runs_as_a_command_with_processes(sweep, tmp_path):
    command = [
        sys.executable,
        "-m",
        "sss_ref.cli",
        "batch",
        sweep,
        "-o",
        "out",
        "--jobs",
        "2",
        "--interpreter",
        "arrays",
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 1, done.stderr
    assert done.stdout.startswith("2 rendered, 0 were there, 3 failed: ")


def test_a_turntable_leaves_films_and_a_sheet(sweep, tmp_path, capsys):
    small = ["--size", "32x24", "--set", "shadow_map.width=32", "--set", "shadow_map.height=32", "--jobs", "1"]
    assert main(["turntable", "scene.toml", "-o", "turn", "--frames", "3", *small, "--interpreter", "arrays"]) == 0
    assert {"turntable.gif", "contact_sheet.png", "items.csv"} < {*os.listdir("turn")}
    assert str(tmp_path / "turn" / "turntable.gif") in capsys.readouterr().out
    assert ("turntable.mp4" in os.listdir("turn")) == has_encoder()


def test_a_batch_makes_a_film_of_what_did_not_fail(sweep, capsys):
    assert main(["batch", sweep, "-o", "out", "--jobs", "1", "--interpreter", "arrays", "--video", "10"]) == 1
    with Image.open("out/batch.gif") as gif:
        assert (gif.n_frames, gif.info["duration"]) == (2, 100)


def test_a_light_stage_is_asked_for_beside_a_sweep(sweep, tmp_path, capsys):
    (tmp_path / sweep).write_text(SWEEP.partition("[vary]")[0])
    few = ["--jobs", "1", "--interpreter", "arrays"]
    assert main(["batch", sweep, "-o", "out", "--olat", "3", *few]) == 0
    assert capsys.readouterr().out.startswith("3 rendered, 0 were there, 0 failed: ")
    assert {"items.csv", "transforms.json"} < {*os.listdir("out")}


def test_a_caption_has_the_numbers_of_a_light():
    lights = [{"type": "directional", "azimuth": 137.507, "elevation": 54.3, "intensity": 1.0}]
    assert batch_commands._short(lights) == "[137.5, 54.3, 1]"
    assert batch_commands._short([0.5, [1, "a"]]) == "[0.5, [1, a]]"


def test_a_film_needs_pictures_and_a_rate(sweep, tmp_path, capsys):
    assert main(["batch", sweep, "-o", "out", "--video", "0"]) == 2
    assert "pictures per second: expected 1 to 100, got 0" in capsys.readouterr().err
    (tmp_path / sweep).write_text(f'outputs = ["npz"]\n{SWEEP}')
    assert main(["batch", sweep, "-o", "out", "--video", "10"]) == 2
    assert '--video: expected the output "png", got npz' in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
