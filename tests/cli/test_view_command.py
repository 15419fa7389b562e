"""What `sss-ref view` serves and says; the server has tests of its own."""

import webbrowser
from types import SimpleNamespace

import pytest

from sss_ref.cli import main, view_command


@pytest.fixture
def served(monkeypatch):
    """Runs the command; what was served, and what was opened in a browser."""
    seen = []

    def serve(document, host, port, tell):
        seen.append((document.source, host, port))
        tell("http://[::1]:80")

    monkeypatch.setattr("sss_ref.viewer.server.view", serve)
    monkeypatch.setattr(
        "sss_ref.viewer.studio.starting_point", lambda scene, overrides: SimpleNamespace(source=f"{scene}[1]")
    )
    monkeypatch.setattr("sss_ref.cache.compiled.is_cold", lambda: False)
    monkeypatch.setattr(view_command, "find_spec", lambda name: name)
    monkeypatch.setattr(webbrowser, "open", lambda address: seen.append(address))

    def run(*words):
        return main(["view", "wedge", *words])

    run.seen = seen
    return run


def test_the_address_is_told_and_opened_if_asked(served, capsys):
    assert served() == 0
    told = capsys.readouterr()
    assert (told.out, told.err) == ("http://[::1]:80 shows wedge[1]; Ctrl-C ends it\n", "ended\n")
    assert served("--open", "--host", "0.0.0.0", "--port", "1") == 0
    assert served.seen == [("wedge[1]", "127.0.0.1", 8710), ("wedge[1]", "0.0.0.0", 1), "http://[::1]:80"]


@pytest.mark.parametrize(("port", "code"), [("0", 0), ("65535", 0), ("65536", 2), ("-1", 2)])
def test_the_ports_that_there_are(port, code, served, capsys):
    assert served(f"--port={port}") == code
    assert (f"--port: expected 0 to 65535, got {port}" in capsys.readouterr().err) == (code == 2)


@pytest.mark.parametrize("missing", view_command.NEEDED)
def test_each_package_of_the_extra_is_needed(missing, served, monkeypatch, capsys):
    monkeypatch.setattr(view_command, "find_spec", lambda name: None if name == missing else name)
    assert served() == 2
    assert "view: expected the extra `view`, got an installation without" in capsys.readouterr().err
