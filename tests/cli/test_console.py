"""Results to standard output, everything else to standard error, as they are given."""

import io
from functools import partial

import pytest
from rich.console import Console

from sss_ref.cli import console
from sss_ref.cli.options import Execution


@pytest.mark.parametrize("name", ["out", "err"])
def test_a_line_is_printed_as_it_is_given(name, capsys):
    """Whole, however long it is, its numbers in no colour of their own."""
    line = "12 " * 60 + "triangles"
    speaker = getattr(console, name)
    speaker.print(line)
    assert getattr(capsys.readouterr(), name) == f"{line}\n"
    assert speaker.render_str("12 triangles in 'a.obj'").spans == []


def test_tables_are_240_characters_wide_and_codes_tell_what_came_of_it():
    assert (console.out.width, console.DIFFERS, console.BAD_INPUT) == (240, 1, 2)
    assert not console.out.stderr and console.err.stderr


@pytest.mark.parametrize(
    ("interpreter", "is_cold", "is_told"),
    [("kernel", True, True), ("kernel", False, False), ("arrays", True, False), ("arrays", False, False)],
)
def test_compilation_is_told_where_it_comes(interpreter, is_cold, is_told, monkeypatch, capsys):
    monkeypatch.setattr("sss_ref.cache.compiled.is_cold", lambda: is_cold)
    console.announce_compilation(Execution(interpreter=interpreter))
    assert capsys.readouterr().err == ("compiling kernels (once per version; about 7 s) ...\n" if is_told else "")


class AtOnce:
    """Stands in for a timer: what it is to do is done when it starts."""

    def __init__(self, waited, seconds, act):
        waited.append(seconds)
        self.start, self.cancel, self.join = act, lambda: None, lambda: None


@pytest.mark.parametrize("is_terminal", [True, False])
def test_progress_is_shown_on_a_terminal_after_a_second(is_terminal, monkeypatch):
    shown, waited = io.StringIO(), []
    monkeypatch.setattr(console, "err", Console(file=shown, force_terminal=is_terminal))
    monkeypatch.setattr(console, "Timer", partial(AtOnce, waited))
    with console.progress("loading") as show:
        show("drawing")
    assert waited == ([1.0] if is_terminal else [])
    assert ("drawing" in shown.getvalue()) == is_terminal
    assert is_terminal or not shown.getvalue()
