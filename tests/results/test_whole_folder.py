"""Folders appear whole or not at all, whoever else writes there and whenever a writer is killed."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from sss_ref.errors import DumpError
from sss_ref.results import whole_folder
from sss_ref.results.exchange import exchanged
from sss_ref.results.whole_folder import appearing, writable

FILES = 20


def write(folder, content):
    with appearing(folder) as part:
        for number in range(FILES):
            (part / f"{number}.txt").write_text(content)


def contents(folder):
    """What its files hold; a whole one has all of them, and all the same."""
    paths = list(folder.iterdir())
    assert len(paths) == FILES
    return {path.read_text() for path in paths}


@pytest.fixture(params=["in one step", "by two renames"])
def system(request, monkeypatch):
    """A system that exchanges two folders, and one that cannot."""
    if request.param == "by two renames":
        monkeypatch.setattr(whole_folder, "exchanged", lambda first, second: False)


def test_two_folders_change_places(tmp_path):
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "file").write_text(name)
    if not exchanged(tmp_path / "a", tmp_path / "b"):
        pytest.skip("this system cannot exchange two folders")
    assert [(tmp_path / name / "file").read_text() for name in ("a", "b")] == ["b", "a"]


@pytest.mark.usefixtures("system")
def test_a_folder_is_replaced_whole(tmp_path):
    for content in ("first", "second"):
        write(tmp_path / "out", content)
        assert contents(tmp_path / "out") == {content} and os.listdir(tmp_path) == ["out"]


@pytest.mark.usefixtures("system")
def test_threads_that_write_one_folder_lose_nothing(tmp_path):
    with ThreadPoolExecutor(8) as pool:
        done = [pool.submit(write, tmp_path / "out", str(number)) for number in range(40)]
        for each in done:
            each.result()
    assert len(contents(tmp_path / "out")) == 1 and os.listdir(tmp_path) == ["out"]


def test_what_a_killed_writer_left_goes_with_the_next(tmp_path):
    write(tmp_path / "out", "earlier")
    program = (
        "import sys, time, pathlib\nfrom sss_ref.results.whole_folder import appearing\n"
        "with appearing(pathlib.Path(sys.argv[1])) as part:\n"
        "    (part / 'half').write_text('x'); print('there', flush=True); time.sleep(60)\n"
    )
    command = [sys.executable, "-c", program, str(tmp_path / "out")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as writer:
        assert writer.stdout.readline().strip() == "there"
        write(tmp_path / "out", "meanwhile")  # the other one still writes: its folder stays
        assert len(os.listdir(tmp_path)) == 3
        writer.send_signal(signal.SIGKILL)
    assert contents(tmp_path / "out") == {"meanwhile"} and len(os.listdir(tmp_path)) == 3
    write(tmp_path / "out", "later")
    assert contents(tmp_path / "out") == {"later"} and os.listdir(tmp_path) == ["out"]


WRITER = """
import pathlib, sys
from sss_ref.results.whole_folder import appearing, writable
number = 0
print("ready", flush=True)
while True:
    number += 1
    with appearing(pathlib.Path(sys.argv[1])) as part:
        for k in range(20):
            (part / f"{k}.txt").write_text(str(number))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL")
def test_a_writer_killed_at_any_moment_leaves_a_whole_folder(tmp_path):
    write(tmp_path / "out", "0")
    for kill in range(12):
        command = [sys.executable, "-c", WRITER, str(tmp_path / "out")]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as writer:
            writer.stdout.readline()
            time.sleep(0.003 + 0.0017 * kill)
            writer.send_signal(signal.SIGKILL)
        assert len(contents(tmp_path / "out")) == 1
    write(tmp_path / "out", "last")
    assert contents(tmp_path / "out") == {"last"} and os.listdir(tmp_path) == ["out"]


def test_an_earlier_result_set_aside_by_a_killed_writer_comes_back(tmp_path):
    hidden = tmp_path / f".out.abc{whole_folder.HIDDEN}"
    (hidden / "old").mkdir(parents=True)
    (hidden / "old" / "file").write_text("earlier")
    (hidden / "content").mkdir()
    hidden.with_suffix(whole_folder.LOCK).touch()
    with pytest.raises(ZeroDivisionError), appearing(tmp_path / "out"):
        raise ZeroDivisionError
    assert (tmp_path / "out" / "file").read_text() == "earlier" and os.listdir(tmp_path) == ["out"]


def test_a_name_with_signs_of_patterns_is_a_name(tmp_path):
    write(tmp_path / "out[1]*", "x")
    assert contents(Path(tmp_path / "out[1]*")) == {"x"}


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("a" * 300, r"/a+: cannot be written \(File name too long\); choose another folder"),
        (os.fsdecode(b"out\xff"), r"/out\\udcff: expected a name in UTF-8, got another; choose another folder"),
    ],
)
def test_a_name_that_no_result_can_have_is_refused_before_the_work(name, told, tmp_path):
    """OpenEXR would refuse the second at the end, and a manifest cannot hold it."""
    with pytest.raises(DumpError, match=told) as refused:
        writable(tmp_path / name, lambda folder: True, "an earlier result")
    assert str(refused.value).isprintable()


def test_what_a_library_says_of_a_file_that_is_cut_off_is_not_passed_on(tmp_path):
    """NumPy tells what it asked of the system, without an error of the system."""
    told = r"/out: cannot be written \(not all of it was taken\); choose another folder"
    with pytest.raises(DumpError, match=told), appearing(tmp_path / "out"):
        raise OSError("4096 requested and 218 written")
    assert list(tmp_path.iterdir()) == []
