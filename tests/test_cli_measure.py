"""`sss-ref measure`: a folder that goes on where it stopped, and one line for each thing that is wrong."""

import json

import numpy as np
import pytest

from sss_ref.cli import main

SMALL = ["--size", "16x16", "--set", "mm_per_unit=20", "--medium", "skin2", "--photons", "1000"]
MAPS = [word for side in ("width", "height") for word in ("--set", f"shadow_map.{side}=64")]
FILES = {"measure.html", "measure.json", "measure.md", "truth"}


def test_a_measurement_goes_on(tmp_path, capsys):
    words = ["measure", "sphere", *SMALL, *MAPS, "-o", str(tmp_path / "out"), "--methods", "burley", "separable"]
    assert main([*words, "--samples", "2", "--no-fit"]) == 0
    assert main([*words, "--samples", "4", "--threads", "1"]) == 0
    told = capsys.readouterr()
    assert "4 samples a pixel, 0 lost" in told.out and "separable, fitted" in told.out
    assert "left out, as the truth has none: phong.ambient = 0.04, phong.specular = 0.5" in told.err
    assert {path.name for path in (tmp_path / "out").iterdir()} == FILES
    record = json.loads((tmp_path / "out" / "measure.json").read_text())
    assert [(one["method"], one["parameters"]) for one in record["techniques"]] == [
        (method, keys) for method in ("burley", "separable") for keys in ("shipped", "fitted")
    ]
    assert (
        main(["truth", "sphere", *SMALL[:6], "-o", str(tmp_path / "t"), "--samples", "4", "--border", "entered"]) == 0
    )
    mean = np.load(tmp_path / "t" / "radiance.npy").mean(axis=(0, 1))
    assert record["truth"]["mean"] == pytest.approx(mean.tolist(), rel=1e-6)  # float32


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["sphere", "--medium", "skin2"], "mm_per_unit: expected how many mm a unit of the scene is, got nothing"),
        (["sphere", *SMALL[:4]], "--medium: expected the name of a medium, got none and a scene without material"),
        (["sphere", *SMALL[:4], "--medium", "skin9"], "--medium: expected the name of a medium, got 'skin9'"),
        (
            ["sphere", *SMALL, "--methods", "seperable"],
            "--methods: expected a technique, got 'seperable'; did you mean",
        ),
        (["sphere", *SMALL, "--samples", "1"], "--samples: expected at least 2, got 1"),
        (["sphere", *SMALL[:6], "--photons", "10"], "--photons: expected at least 1000, got 10"),
        (["lesson_stretch", *SMALL], "mesh: expected a closed surface, so that there is an inside"),
        (["teeth_layers", *SMALL], "layers: expected one body, got another inside it"),
        (["figure3_with", *SMALL[:2], "--set", 'material="skin"'], "got none, and of skin no coefficients are known"),
        (["figure4_wax", *SMALL], 'preset: expected one whose keys can be fitted, got "published"; give --no-fit'),
        (["figure4_wax", *SMALL, "--no-fit"], 'preset: expected "paper" or "robust" with method = "separable"'),
        (["sphere", *SMALL, "--set", 'mesh.color="material"'], "mesh.color: expected one colour"),
    ],
)
def test_what_is_wrong_is_said_before_anything_is_written(tmp_path, capsys, words, line):
    assert main(["measure", *words, "-o", str(tmp_path / "out")]) == 2
    told = capsys.readouterr().err
    assert line in " ".join(told.split())
    assert not (tmp_path / "out").exists()


def test_a_dump_of_another_size_and_one_without_picture_are_refused(tmp_path, capsys):
    np.save(tmp_path / "image.npy", np.zeros((8, 8, 3), np.float32))
    words = ["measure", "sphere", *SMALL, "-o", str(tmp_path / "out"), "--dump", str(tmp_path)]
    assert main(words) == 2
    assert "image.npy: expected" in capsys.readouterr().err
    (tmp_path / "image.npy").rename(tmp_path / "lit.npy")
    np.save(tmp_path / "lit.npy", np.zeros((16, 16, 3), np.float32))
    assert main(words) == 2
    assert "expected the buffer image, got others" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_other_files_are_left_alone(tmp_path, capsys):
    (tmp_path / "mine.txt").write_text("mine")
    assert main(["measure", "sphere", *SMALL, "-o", str(tmp_path)]) == 2
    assert "expected a new folder or one of sss-ref measure, got other files" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
