"""From a folder to a mapping file, on the command line: what is printed, and the exit code."""

import tomllib

import numpy as np
import pytest

from sss_ref.cli import main
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

SIZES = [f"{table}.{side}" for table in ("camera", "shadow_map") for side in ("width", "height")]
SMALL = [part for size in SIZES for part in ("--set", f"{size}=32")] + ["--interpreter", "arrays"]


@pytest.fixture(scope="module")
def buffers():
    return dict(render(load_scene("sphere", **dict.fromkeys(SIZES, 32)), interpreter="arrays").buffers)


@pytest.fixture
def folder(buffers, tmp_path):
    """Three pictures, and a text."""
    (tmp_path / "in").mkdir()
    np.save(tmp_path / "in" / "1.npy", buffers["thickness"])
    np.save(tmp_path / "in" / "2.npy", buffers["phong"][..., ::-1])
    np.save(tmp_path / "in" / "3.npy", buffers["translucency"][::-1])
    (tmp_path / "in" / "4.txt").write_text("none")
    return tmp_path / "in"


def test_the_mapping_file_says_what_was_found(folder, tmp_path, capsys):
    assert main(["import", str(folder), "sphere", "-o", str(tmp_path / "out"), *SMALL]) == 0
    printed = capsys.readouterr()
    assert "thickness: 1.npy, rows from the bottom, 100% alike" in printed.out
    assert "phong: the channels of 2.npy are in the order B, G, R" in printed.err
    assert "translucency: the rows of 3.npy begin at the top" in printed.err
    assert "4.txt: expected a picture" in printed.err
    tables = tomllib.loads((tmp_path / "out" / "mapping.toml").read_text())["buffers"]
    assert tables == {
        "thickness": {"file": "../in/1.npy", "channels": ["R"], "origin": "bottom"},
        "phong": {"file": "../in/2.npy", "channels": ["B", "G", "R"], "origin": "bottom"},
        "translucency": {"file": "../in/3.npy", "channels": ["R"], "origin": "top"},
    }
    assert main(["validate", "sphere", str(tmp_path / "out" / "mapping.toml"), *SMALL]) == 0


def test_both_at_once(folder, buffers, capsys):
    assert main(["validate", "sphere", str(folder), "--auto", *SMALL]) == 0
    np.save(folder / "3.npy", buffers["translucency"] * np.float32(1.01))
    assert main(["validate", "sphere", str(folder), "--auto", *SMALL]) == 1
    assert "of translucency are out of reach" in capsys.readouterr().out


def test_a_question_ends_with_exit_code_1(folder, buffers, capsys):
    np.save(folder / "5.npy", buffers["thickness"] * np.float32(1.00002))
    assert main(["import", str(folder), "sphere", *SMALL]) == 1
    line = f"{folder}: expected one file for thickness, got 1.npy and 5.npy, which fit it alike; remove all but one"
    assert line in capsys.readouterr().err
    text = (folder / "mapping.toml").read_text()
    assert f"# {line}" in text and "thickness" not in tomllib.loads(text)["buffers"]


@pytest.mark.parametrize(
    ("files", "words"),
    [
        ({"a.txt": b"x"}, "expected pictures (.npy, "),
        ({"a.npy": b"x"}, "expected pictures (.npy, "),
        ({"a.npy": None}, "expected pictures like the buffers of sphere, got none"),
        ({}, "expected pictures (.npy, "),
    ],
)
def test_nothing_to_be_found(files, words, tmp_path, capsys):
    for name, data in files.items():
        if data is None:
            np.save(tmp_path / name, np.random.default_rng(1).random((32, 32), np.float32))
        else:
            (tmp_path / name).write_bytes(data)
    assert main(["import", str(tmp_path), "sphere", *SMALL]) == 2
    printed = capsys.readouterr().err
    assert words in printed and printed.count("\n") == 1


def test_no_folder_and_a_mapping_file_that_is_there(folder, capsys):
    assert main(["import", str(folder / "none"), "sphere", *SMALL]) == 2
    assert "expected a folder, got No such file or directory" in capsys.readouterr().err
    (folder / "mapping.toml").write_text("mine")
    assert main(["import", str(folder), "sphere", *SMALL]) == 2
    assert "expected a new file, got one that is there" in capsys.readouterr().err
    assert (folder / "mapping.toml").read_text() == "mine"
