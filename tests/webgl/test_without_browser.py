"""What Chromium is asked, and what is made of what it says, where another process stands in for it."""

import base64
import io
import subprocess
from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.errors import ShaderError
from sss_ref.webgl import browser
from sss_ref.webgl.browser import printed_buffers

LIT = np.arange(6, dtype=np.float32).reshape(1, 2, 3)


def link(name, array):
    file = io.BytesIO()
    np.save(file, array)
    data = base64.b64encode(file.getvalue()).decode()
    return f'<a download="{name}.npy" href="data:application/octet-stream;base64,{data}">{name}</a>'


@pytest.fixture
def chromium(monkeypatch):
    """Has the browser print a page, or fail; gives its commands."""
    commands = []

    def stand_in(shown="", code=0, said=""):
        def run(command, capture_output, text, timeout):
            assert capture_output and text and timeout == 600
            commands.append(command)
            return SimpleNamespace(returncode=code, stdout=shown, stderr=said)

        monkeypatch.setattr(browser.subprocess, "run", run)
        monkeypatch.setattr(browser.shutil, "which", lambda name: f"/{name}" if name == "google-chrome" else None)
        return commands

    return stand_in


def refusal():
    with pytest.raises(ShaderError) as error:
        printed_buffers("page")
    return str(error.value)


def test_buffers_are_read_from_the_page(chromium):
    chromium(link("lit", LIT) + "\n" + link("coverage", np.uint8([[1, 0]])))
    found = printed_buffers("page")
    assert list(found) == ["lit", "coverage"] and found["lit"].tolist() == LIT.tolist()
    assert found["coverage"].dtype == np.uint8


@pytest.mark.parametrize(("user", "alone"), [(0, True), (1000, False)])
def test_only_root_needs_no_sandbox(chromium, monkeypatch, user, alone):
    commands = chromium(link("lit", LIT))
    monkeypatch.setattr(browser.os, "geteuid", lambda: user)
    printed_buffers("page", ["--mine"])
    ((program, *options),) = commands
    assert program == "/google-chrome" and ("--no-sandbox" in options) == alone and "--mine" in options
    assert (
        options[-2] == "--dump-dom" and options[-1].startswith("file:///") and options[-1].endswith("page.html#inline")
    )


def test_a_system_without_users_has_no_root(chromium, monkeypatch):
    commands = chromium(link("lit", LIT))
    monkeypatch.delattr(browser.os, "geteuid")
    printed_buffers("page")
    assert "--no-sandbox" not in commands[0]


def test_what_the_page_says_is_told(chromium):
    chromium('<p id="error">no &lt;webgl2&gt;</p>' + link("lit", LIT))
    assert refusal() == "webgl: expected every pass to be drawn, got no <webgl2>"
    chromium("<p>nothing</p>")
    assert refusal() == "webgl: expected every pass to be drawn, got a page without buffers"


def test_the_last_of_what_a_browser_says_is_told(chromium):
    chromium(code=3, said="a" * 499 + "b" * 500)
    expected = f"webgl: expected /google-chrome to run, got exit code 3: {'b' * 500}; try it by hand, with other"
    assert refusal() == f"{expected} options if need be"


def test_a_browser_that_hangs_or_is_not_there(chromium, monkeypatch):
    chromium()

    def hang(command, timeout, **_):
        raise subprocess.TimeoutExpired(command, timeout)

    monkeypatch.setattr(browser.subprocess, "run", hang)
    with pytest.raises(ShaderError, match="webgl: expected a page drawn in 7 s, got none; draw a smaller picture"):
        printed_buffers("page", seconds=7)
    monkeypatch.setattr(browser.shutil, "which", lambda name: None)
    assert refusal() == "webgl: expected one of chromium, chromium-browser, google-chrome, got none; install Chromium"
