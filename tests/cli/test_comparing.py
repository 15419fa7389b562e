"""What `sss-ref verify` and `diff` print and their exit codes; comparing has tests of its own."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from sss_ref.cli import main
from sss_ref.results.diff import BufferDiff, FolderDiff


@pytest.mark.parametrize(("equal", "code"), [(True, 0), (False, 1)])
def test_a_verdict_is_printed_as_it_is(equal, code, monkeypatch, capsys):
    seen = []

    def verify(folder, interpreter, threads, on_pass):
        seen.append((folder, interpreter, threads))
        return SimpleNamespace(equal=equal, message="verified: [bold] 1 buffer")

    monkeypatch.setattr("sss_ref.results.verify.verify", verify)
    assert main(["verify", "out", "--interpreter", "arrays", "--threads", "1"]) == code
    assert capsys.readouterr().out == "verified: [bold] 1 buffer\n" and seen == [(Path("out"), "arrays", 1)]


SAME = BufferDiff("uv", 24, 0, 0.0, (48, 0, 0, 0, 0, 0, 0), None)
OTHER = BufferDiff("lit", 24, 3, 0.1234567, (69, 1, 0, 0, 2, 0, 0), "first at pixel [1,2]")


@pytest.fixture
def compared(monkeypatch, tmp_path):
    """Runs the command on two folders whose differences are given; the pictures that were written."""
    written = []
    monkeypatch.setattr(
        "sss_ref.results.diff_picture.write_diff_picture", lambda path, name, a, b: written.append((path, name, a, b))
    )
    monkeypatch.setattr("sss_ref.results.diff_picture.checked_picture_file", lambda path: None)

    def run(found, *words):
        monkeypatch.setattr("sss_ref.results.diff.diff", lambda a, b: found)
        return main(["diff", "a[1]", "b[1]", *words])

    run.written = written
    return run


def test_what_differs_is_a_table_with_the_first_difference_below(compared, capsys):
    assert compared(FolderDiff((SAME, OTHER), (), ()), "-o", "x[1].png") == 1
    title, *lines = capsys.readouterr().out.splitlines()
    assert [title.strip(), *map(str.rstrip, lines)] == [
        "pixels that differ, and values by their distance in ULP",
        "",
        "  buffer    pixels   largest    0   1   2-3   4-15   16-255   more   sign, NaN",
        f" {'─' * 78}",
        "  uv         equal         0   48",
        "  lit      3 of 24    0.1235   69   1                     2",
        "",
        "first difference: buffer lit, first at pixel [1,2]",
        "x[1].png: both versions of lit and where they differ",
    ]
    assert compared.written == [(Path("x[1].png"), "lit", Path("a[1]"), Path("b[1]"))]


def test_without_a_file_no_picture_is_made(compared, capsys):
    assert compared(FolderDiff((OTHER,), (), ())) == 1
    assert capsys.readouterr().out.splitlines()[-1].startswith("first difference") and not compared.written


@pytest.mark.parametrize(
    ("only_a", "only_b", "code", "told"),
    [
        ((), (), 0, ""),
        (("depth", "lit"), (), 2, "only in a[1]: depth, lit\n"),
        ((), ("depth",), 2, "only in b[1]: depth\n"),
        (("lit",), ("depth",), 2, "only in a[1]: lit\nonly in b[1]: depth\n"),
    ],
)
def test_what_one_has_alone_decides_where_all_else_is_equal(only_a, only_b, code, told, compared, capsys):
    assert compared(FolderDiff((SAME,), only_a, only_b), "-o", "x.png") == code
    printed = capsys.readouterr()
    assert (printed.out, printed.err) == ("equal in every bit: uv\n", told) and not compared.written
    assert compared(FolderDiff((SAME, OTHER), only_a, only_b)) == 1
    assert capsys.readouterr().err == told
