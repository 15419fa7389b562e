"""Texts that users hand over: what is no regular file is not opened, and no other library's words are told."""

import os

import pytest

from sss_ref.dump.mapping import read_mapping
from sss_ref.errors import DumpError, ProfileError
from sss_ref.errors.text_file import BYTE_LIMIT, text_of, toml_in, write_text, write_texts
from sss_ref.validation.profile_file import profile_of

READERS = [(read_mapping, DumpError), (profile_of, ProfileError)]


@pytest.mark.parametrize(("read", "error"), READERS)
def test_a_pipe_and_a_device_are_refused_before_they_are_opened(tmp_path, read, error):
    os.mkfifo(tmp_path / "pipe.toml")
    (tmp_path / "zero.toml").symlink_to("/dev/zero")
    for name in ("pipe.toml", "zero.toml", "."):
        with pytest.raises(error, match="got no regular file; copy its content to one") as caught:
            read(tmp_path / name)
        assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize(("read", "error"), READERS)
@pytest.mark.parametrize(
    ("data", "came"),
    [
        (b"a = " + b"[" * 100_000, "expected valid TOML, got brackets or keys nested without end; nest less"),
        (
            b".".join([b"a"] * 100_000) + b"=1",
            "expected valid TOML, got brackets or keys nested without end; nest less",
        ),
        (b"[" + b" . ".join([b'"\xc3\xa9"'] * 33) + b"]", "got brackets or keys nested without end; nest less"),
        (b"a = ?", "expected valid TOML, got none at line 1, column 5; correct that place"),
        (b"a =", "expected valid TOML, got none at end of document; correct that place"),
        (b"a = " + b"9" * 5000, "expected valid TOML, got a date or number out of range; correct it"),
        (b"\xff", "in UTF-8, got a byte that is no UTF-8 at byte 0; save it as UTF-8"),
        (b"#" * (BYTE_LIMIT + 1), "of at most 1048576 bytes, got 1048577 bytes; check the path"),
    ],
)
def test_a_text_that_is_none(tmp_path, read, error, data, came):
    (tmp_path / "x.toml").write_bytes(data)
    with pytest.raises(error) as caught:
        read(tmp_path / "x.toml")
    assert str(caught.value).endswith(came) and len(str(caught.value).splitlines()) == 1


def test_a_text_comes_through(tmp_path):
    (tmp_path / "long").write_bytes(b"#" * BYTE_LIMIT)
    assert len(text_of(tmp_path / "long", "a text", DumpError)) == BYTE_LIMIT
    (tmp_path / "x").write_text("é" * 10, encoding="utf-8")
    assert text_of(tmp_path / "x", "a text", DumpError) == "é" * 10
    with pytest.raises(DumpError, match="expected a text, got No such file or directory; check the path"):
        text_of(tmp_path / "y", "a text", DumpError)


def test_what_is_no_long_key_is_read():
    """Nor is it long to look for one: some of these take a minute where the search tries again."""
    long = ("a" * 500_000, "'" * 9 + "a" * 100_000, '"' + "a'" * 99_999)
    assert [len(toml_in(f"# {text}\n" + "a.b = 1")) for text in (*long, ". " * 100_000, "1.5, " * 100_000)] == [1] * 5
    assert toml_in(".".join("k" * 32) + " = 3")
    assert toml_in("a = [" + "1.0, " * 1000 + "]")["a"][999] == 1


def test_a_text_is_written_or_refused_in_one_line(tmp_path):
    path = write_text(tmp_path / "a.txt", "ä\n", DumpError)
    assert path.read_bytes() == b"\xc3\xa4\n"
    with pytest.raises(DumpError) as error:
        write_text(tmp_path, "a", DumpError)
    assert str(error.value) == f"{tmp_path}: expected a file that can be written, got Is a directory; choose another"


def test_texts_are_written_into_a_folder_that_is_made(tmp_path):
    write_texts(tmp_path / "new" / "deep", {"a.txt": "ä\n", "b.txt": ""}, DumpError)
    assert {path.name: path.read_bytes() for path in (tmp_path / "new" / "deep").iterdir()} == {
        "a.txt": b"\xc3\xa4\n",
        "b.txt": b"",
    }
    file = tmp_path / "new" / "deep" / "a.txt"
    for folder, name, line in (
        (file, "c", f"{file}: expected a folder to write into, got File exists; choose another"),
        (
            tmp_path,
            "new",
            f"{tmp_path / 'new'}: expected a file that can be written, got Is a directory; choose another",
        ),
    ):
        with pytest.raises(DumpError) as error:
            write_texts(folder, {name: ""}, DumpError)
        assert str(error.value) == line
