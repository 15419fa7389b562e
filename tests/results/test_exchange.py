"""Two folders that change places, and what is said where a system has nothing for it."""

import ctypes
import errno
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from sss_ref.results import exchange
from sss_ref.results.exchange import exchanged


@pytest.fixture(autouse=True)
def asked_anew():
    """What a system offers is asked once a process."""
    exchange._system_call.cache_clear()
    yield
    exchange._system_call.cache_clear()


def test_two_folders_change_places(tmp_path):
    for name in "ab":
        (tmp_path / name).mkdir()
        (tmp_path / name / name).touch()
    if not exchanged(tmp_path / "a", tmp_path / "b"):
        pytest.skip("this file system exchanges no two folders")
    assert [[path.name for path in (tmp_path / name).iterdir()] for name in "ab"] == [["b"], ["a"]]


def test_what_is_not_there_is_the_systems_own_error(tmp_path):
    if exchange._system_call() is None:
        pytest.skip("this system exchanges no two folders")
    with pytest.raises(FileNotFoundError) as caught:
        exchanged(tmp_path / "a", tmp_path / "b")
    assert caught.value.filename == str(tmp_path / "b")


@pytest.mark.parametrize(
    ("platform", "name", "words"),
    [
        ("linux", "renameat2", (-100, b"a", -100, b"b", 2)),  # AT_FDCWD and RENAME_EXCHANGE of Linux' headers
        ("darwin", "renamex_np", (b"a", b"b", 2)),  # RENAME_SWAP of macOS' <sys/stdio.h>
    ],
)
@pytest.mark.parametrize(
    ("code", "came"), [(0, True), (errno.ENOSYS, False), (errno.EINVAL, False), (errno.EPERM, False), (errno.EIO, None)]
)
def test_each_system_has_a_call_of_its_own(platform, name, words, code, came, monkeypatch):
    seen = []

    def call(*given):
        seen.append(tuple(getattr(each, "value", each) for each in given))
        return -1 if code else 0

    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(ctypes, "CDLL", lambda library, use_errno: SimpleNamespace(**{name: call}))
    monkeypatch.setattr(ctypes, "get_errno", lambda: code)
    if came is None:
        with pytest.raises(OSError, match="b") as caught:
            exchanged(Path("a"), Path("b"))
        assert caught.value.errno == code
    else:
        assert exchanged(Path("a"), Path("b")) is came
    assert seen == [words]


def test_a_system_without_such_a_call_is_told_from_one_with(monkeypatch):
    monkeypatch.setattr(ctypes, "CDLL", lambda library, use_errno: SimpleNamespace())
    assert exchanged(Path("a"), Path("b")) is False
