"""`sss-ref truth`: a folder that goes on where it stopped, and one line for each thing that is wrong."""

import json

import numpy as np
import pytest

from sss_ref.cli import main

SMALL = ["--size", "8x6", "--set", "mm_per_unit=10", "--medium", "skin1"]


def test_a_folder_goes_on(tmp_path, capsys):
    at_once, in_two = tmp_path / "at_once", tmp_path / "in_two"
    assert main(["truth", "sphere", "-o", str(at_once), "--samples", "5", *SMALL]) == 0
    assert "5 samples a pixel, 0 lost" in capsys.readouterr().out
    for samples in ("2", "5"):
        assert main(["truth", "sphere", "-o", str(in_two), "--samples", samples, "--threads", "1", *SMALL]) == 0
    for name in ("radiance.npy", "standard_error.npy", "image.png", "truth.json"):
        assert (at_once / name).read_bytes() == (in_two / name).read_bytes()
    record = json.loads((in_two / "truth.json").read_text())
    mean = np.load(in_two / "radiance.npy")
    assert mean.shape == (6, 8, 3) and record["samples"] == 5
    assert record["mean"] == pytest.approx(mean.mean(axis=(0, 1)), rel=1e-6)  # float32


def test_the_time_is_kept(tmp_path, capsys):
    assert (
        main(["truth", "sphere", "-o", str(tmp_path / "out"), "--samples", "500", "--time-limit", "0.001", *SMALL]) == 0
    )
    assert "2 samples a pixel" in capsys.readouterr().out


def test_a_scene_without_a_unit_is_told(tmp_path, capsys):
    words = ["truth", "sphere", "--size", "8x6", "--medium", "skin1", "--samples", "1", "-o"]
    assert main([*words, str(tmp_path / "without")]) == 0
    assert "the scene has no mm_per_unit; a unit is taken for 1 mm" in capsys.readouterr().err
    assert main([*words, str(tmp_path / "with"), "--set", "mm_per_unit=1"]) == 0
    assert "mm_per_unit" not in capsys.readouterr().err


def test_the_scenes_own_material_is_taken(tmp_path):
    words = ["truth", "sphere", "-o", str(tmp_path), "--samples", "1", *SMALL[:4], "--set", 'material="marble"']
    assert main(words) == 0
    assert json.loads((tmp_path / "truth.json").read_text())["volumes_per_mm"][0]["scattering"] == 2.19


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (SMALL[:4], "--medium: expected the name of a medium, got none and a scene without material; try skin1"),
        ([*SMALL, "--samples", "0"], "--samples: expected at least 1, got 0"),
        ([*SMALL, "--threads", "0"], "--threads: expected at least 1, got 0"),
        ([*SMALL[:4], "--medium", "cheese"], "--medium: expected the name of a medium, got 'cheese'"),
    ],
)
def test_what_is_wrong_is_said(tmp_path, capsys, words, line):
    assert main(["truth", "sphere", "-o", str(tmp_path / "out"), *words]) == 2
    assert line in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_other_files_are_left_alone(tmp_path, capsys):
    (tmp_path / "mine.txt").write_text("mine")
    assert main(["truth", "sphere", "-o", str(tmp_path), *SMALL]) == 2
    assert "expected a new folder or one of sss-ref truth, got other files" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
