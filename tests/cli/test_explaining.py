"""What `sss-ref explain` prints of its sections; what is in them has tests of its own."""

from types import SimpleNamespace

import pytest

from sss_ref.cli import main
from sss_ref.explanation.rows import Row, Section

SECTIONS = [
    Section(1, "camera", "[512 x 512]"),
    Section(2, "phong", "pixel 3,4", [Row("line", 0, "a = b[0]", "1", glsl="float a = b[0];")]),
    Section(2, "lit", "", [Row("call", 1, "dot", "2", glsl="dot(n, l)"), Row("line", 2, "c", "3")]),
    Section(
        2, "wide", "", [Row("line", 0, "x" * 71, "(1, 2)", "3f800000 40000000", "mm"), Row("line", 0, "y" * 72, "1")]
    ),
]
PRINTED = """
camera  [512 x 512]

  phong  pixel 3,4
    a = b[0]                                                                1
    float a = b[0];

  lit
      dot                                                                   2
      dot(n, l)
        c                                                                   3

  wide
"""
WIDE = [
    f"    {'x' * 71} (1, 2)                                      3f800000 40000000           mm",
    f"    {'y' * 72}",
    f"{' ' * 76}1",
    "",
]


@pytest.fixture
def explained(monkeypatch):
    """Runs the command; what was asked of the explanation and its sections."""
    seen = []

    def explain(scene, at, interpreter, threads):
        seen.append((scene, at, interpreter, threads))
        return SimpleNamespace(passes="passes")

    def sections(*given):
        seen.append(given)
        return SECTIONS

    monkeypatch.setattr("sss_ref.scene.load.load_scene", lambda name: name)
    monkeypatch.setattr("sss_ref.explanation.explain.explain", explain)
    monkeypatch.setattr("sss_ref.explanation.rows.sections", sections)
    monkeypatch.setattr("sss_ref.cache.compiled.is_cold", lambda: False)

    def run(*words):
        return main(["explain", *words])

    run.seen = seen
    return run


def test_each_section_has_its_heading_and_its_lines_in_columns(explained, capsys):
    assert explained("wedge", "--pixel", "3,4") == 0
    lines = [line.rstrip() for line in capsys.readouterr().out.split("\n")]
    assert lines == [*PRINTED.splitlines(), *WIDE]
    assert explained.seen == [("wedge", (3, 4), "kernel", None), ("passes", None, 1, False)]


def test_what_is_asked_for_is_explained(explained):
    words = ("--stage", "phong", "--depth", "2", "--glsl", "--interpreter", "arrays", "--threads", "3")
    assert explained("--pixel", " 0 , 12 ", *words) == 0
    assert explained.seen == [("default", (0, 12), "arrays", 3), ("passes", "phong", 2, True)]


@pytest.mark.parametrize("pixel", ["20", "20,", ",20", "1;2", "x,2", "1,x", "1,2.5", ""])
def test_a_pixel_is_a_column_and_a_row(pixel, explained, capsys):
    assert explained(f"--pixel={pixel}") == 2
    assert "--pixel: expected COLUMN,ROW, got" in capsys.readouterr().err and not explained.seen
