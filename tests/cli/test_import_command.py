"""What `sss-ref import` prints, where it writes and its exit code; recognising has tests of its own."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from sss_ref.cli import import_command, main


class Recognized:
    """Stands in for pictures that were recognised."""

    def __init__(self, questions):
        self.placed = SimpleNamespace(questions=questions)

    def lines(self):
        return ["lit: [a].png", "uv: b.png"]

    def doubts(self):
        return ["b.png: [bold] is doubtful"]

    def write(self, folder):
        return folder / "mapping.toml"


@pytest.fixture
def imported(monkeypatch):
    """Runs the command; where pictures were read and written to."""
    seen = []

    def recognized(source, oracle, extracted):
        seen.append((source, oracle, extracted))
        return Recognized(imported.questions)

    def captured(source, folder):
        seen.append((source, folder))
        return ["p", "q"], ["[one] was left out"]

    def imported(*words, questions=()):
        imported.questions = questions
        return main(["import", *words])

    monkeypatch.setattr("sss_ref.capture.recognized.recognized", recognized)
    monkeypatch.setattr("sss_ref.capture.renderdoc_file.captured", captured)
    monkeypatch.setattr("sss_ref.capture.renderdoc_file.listing", lambda pictures: [f"[{each}]" for each in pictures])
    monkeypatch.setattr("sss_ref.scene.load.load_scene", lambda name: name)
    monkeypatch.setattr(
        "sss_ref.rendering.fold.render", lambda scene, interpreter, threads, on_pass: (scene, interpreter, threads)
    )
    monkeypatch.setattr("sss_ref.cache.compiled.is_cold", lambda: False)
    monkeypatch.setattr(import_command, "made_folder", lambda folder, error: folder)
    imported.seen = seen
    return imported


@pytest.mark.parametrize(("questions", "code"), [((), 0), (("which?",), 1)])
def test_pictures_are_told_with_their_doubts(questions, code, imported, capsys):
    assert imported("dir[bold]", "wedge", questions=questions) == code
    told = capsys.readouterr()
    assert told.out.splitlines() == [
        "lit: [a].png",
        "uv: b.png",
        "dir[bold]/mapping.toml: sss-ref validate wedge dir[bold]/mapping.toml judges them",
    ]
    assert told.err == "note: b.png: [bold] is doubtful\n"


ORACLE = ("wedge", "kernel", None)


@pytest.mark.parametrize(
    ("words", "seen", "folder"),
    [
        (("dir", "wedge"), (Path("dir"), ORACLE, None), "dir"),
        (("dir", "wedge", "-o", "new"), (Path("dir"), ORACLE, None), "new"),
        (("a.rdc", "wedge"), (Path("a.rdc"), ORACLE, Path("a")), "a"),
        (("a.rdc", "wedge", "-o", "new"), (Path("a.rdc"), ORACLE, Path("new")), "new"),
    ],
)
def test_the_mapping_is_written_beside_the_pictures_unless_told_otherwise(words, seen, folder, imported, capsys):
    assert imported(*words) == 0
    assert imported.seen == [seen]
    assert capsys.readouterr().out.splitlines()[-1].startswith(f"{folder}/mapping.toml: ")


@pytest.mark.parametrize(("words", "folder"), [((), "a[1]"), (("-o", "new[1]"), "new[1]")])
def test_a_capture_alone_is_listed(words, folder, imported, capsys):
    assert imported("a[1].rdc", *words) == 0
    told = capsys.readouterr()
    assert told.out.splitlines() == ["[p]", "[q]", f"{folder}: 2 pictures"]
    assert told.err == "note: [one] was left out\n" and imported.seen == [(Path("a[1].rdc"), Path(folder))]


def test_pictures_alone_are_not(imported, capsys):
    assert imported("dir") == 2
    expected = "import: expected a scene to hold the pictures against, got none; give it after the folder"
    assert expected in capsys.readouterr().err and not imported.seen
