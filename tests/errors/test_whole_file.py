"""Files that are whole or not there: replaced, refused, cut short, written through."""

import errno
import os
import stat

import pytest

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_text
from sss_ref.errors.whole_file import put_new, whole_file


def test_a_file_is_replaced_and_keeps_who_may_read_it(tmp_path):
    path = write_text(tmp_path / "a.csv", "one\r\n", DumpError)
    path.chmod(0o640)
    write_text(path, "two\n", DumpError)
    assert os.listdir(tmp_path) == ["a.csv"] and path.read_bytes() == b"two\n"
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_one_that_was_there_stays_where_writing_ends_early(tmp_path):
    path = write_text(tmp_path / "a.png", "one", DumpError)
    with pytest.raises(OSError, match="No space"), whole_file(path) as hidden:
        hidden.write_text("tw")
        assert hidden.suffix == ".png" and path.read_text() == "one"
        raise OSError(errno.ENOSPC, "No space left on device")
    assert os.listdir(tmp_path) == ["a.png"] and path.read_text() == "one"


@pytest.mark.parametrize("has_links", [True, False])
def test_a_new_file_takes_no_name_that_is_taken(tmp_path, monkeypatch, has_links):
    def link(first, second):
        raise PermissionError

    if not has_links:
        monkeypatch.setattr(os, "link", link)
    path = write_text(tmp_path / "a", "one", DumpError, put_new)
    with pytest.raises(FileExistsError):
        write_text(path, "two", DumpError, put_new)
    assert os.listdir(tmp_path) == ["a"] and path.read_text() == "one"


def test_links_and_pipes_are_written_through(tmp_path):
    target, link, pipe = tmp_path / "target", tmp_path / "link", tmp_path / "pipe"
    target.write_text("before")
    link.symlink_to(target)
    write_text(link, "after", DumpError)
    assert link.is_symlink() and target.read_text() == "after"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    write_text(pipe, "all", DumpError)
    assert os.read(reader, 9) == b"all"
    os.close(reader)
    assert sorted(os.listdir(tmp_path)) == ["link", "pipe", "target"]


def test_a_folder_that_is_not_there_is_told(tmp_path):
    with pytest.raises(DumpError) as error:
        write_text(tmp_path / "no" / "a.csv", "one", DumpError)
    line = f"{tmp_path}/no/a.csv: expected a file that can be written, got No such file or directory; choose another"
    assert str(error.value) == line
