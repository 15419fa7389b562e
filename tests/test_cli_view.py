"""`sss-ref view` on the command line: what it refuses, and that Ctrl-C ends it."""

import signal
import socket

import pytest
from viewing import PATIENCE, viewing

from sss_ref.cli import main, view_command

SMALL = ("--size", "64x64", "--set", "shadow_map.width=64", "--set", "shadow_map.height=64")


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (["no_such_scene"], "no_such_scene: expected a scene file"),
        (["default", "--port", "70000"], "--port: expected 0 to 65535, got 70000; choose another"),
        (["default", "--set", "camera.fov_y=400"], "override: camera.fov_y: expected an angle between 0 and 180"),
        (["default", "--host", "no.such.host.invalid"], "no.such.host.invalid:8710: expected a free port, got "),
    ],
)
def test_what_cannot_be_served_is_told_in_one_line(arguments, line, capsys):
    assert main(["view", *arguments]) == 2
    told = capsys.readouterr().err.strip().splitlines()[-1]
    assert told.startswith(f"error: {line}")


def test_a_port_in_use_is_told(capsys):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert main(["view", "default", *SMALL, "--port", str(port)]) == 2
    told = capsys.readouterr().err.strip().splitlines()[-1]
    assert told.startswith(f"error: 127.0.0.1:{port}: expected a free port, got ")
    assert told.endswith("; choose another with --port")


def test_without_the_extra_it_is_named(monkeypatch, capsys):
    monkeypatch.setattr(view_command, "NEEDED", ("no_such_package",))
    assert main(["view", "default"]) == 2
    assert "expected the extra `view`, got an installation without; python -m pip install" in capsys.readouterr().err


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_it_at_once(how):
    with viewing("default", *SMALL, "--port", "0") as viewer:
        viewer.process.send_signal(how)
        out, err = viewer.process.communicate(timeout=PATIENCE)
        assert viewer.process.returncode == 0
        assert (out, err.splitlines()[-1]) == ("", "ended")
        assert "Traceback" not in err
