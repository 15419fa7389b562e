"""The session on a GPU, on llvmpipe: few scenes, small, and in time."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from opengl import needs_mesa

SCRIPT = Path(__file__).parents[1] / "benchmarks" / "real_gpu.py"
SMALL = ["--size", "32", "-o", "session.json"]

pytestmark = needs_mesa


def run(folder, *words, **environment):
    command = [sys.executable, str(SCRIPT), *SMALL, *words]
    return subprocess.run(
        command, cwd=folder, env=os.environ | environment, capture_output=True, text=True, check=False
    )


def record(folder):
    return json.loads((folder / "session.json").read_text())


def test_two_scenes_are_judged(tmp_path):
    done = run(tmp_path, "--scenes", "wedge", "figure5")
    assert done.returncode == 0, done.stderr
    found = record(tmp_path)
    assert [(row["scene"], row["api"], row["verdict"]) for row in found["scenes"]] == [
        ("wedge", "opengl", "pass"),
        ("figure5", "opengl", "pass"),
    ]
    assert found["device"].startswith("llvmpipe") and found["subpixel_bits"] == 8 and "Mesa" in found["driver"]
    assert found["left_out"] == [] and "| wedge | opengl | pass | " in done.stdout


def test_it_stops_in_time_and_says_what_was_left_out(tmp_path):
    """One scene is begun and cut off, the other is not begun."""
    start = time.monotonic()
    done = run(tmp_path, "--scenes", "wedge", "sphere", "--minutes", "0.055", SSS_REF_CACHE_DIR=str(tmp_path / "cold"))
    assert done.returncode == 0 and time.monotonic() - start < 30
    assert [row["verdict"] for row in record(tmp_path)["scenes"]] == ["no time"]
    assert record(tmp_path)["left_out"] == ["opengl sphere"]
    assert "Left out for want of time: opengl sphere." in done.stdout


def test_a_wrong_profile_and_a_missing_opengl_are_told_in_the_table(tmp_path):
    done = run(tmp_path, "--scenes", "wedge", GALLIUM_DRIVER="softpipe")
    (row,) = record(tmp_path)["scenes"]
    assert done.returncode == 0 and row["verdict"] == "error" and record(tmp_path)["device"] is None
    assert "gl: expected OpenGL 4.0, got softpipe, OpenGL 3.3" in row["summary"]


@pytest.mark.parametrize("words", [["--minutes", "7"], ["--size", "0"], ["--scenes", "none"]])
def test_wrong_options_are_refused(tmp_path, words):
    done = run(tmp_path, *words)
    assert done.returncode == 2 and "error: " in done.stderr.splitlines()[-1]
