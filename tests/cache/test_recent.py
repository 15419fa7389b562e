"""What is kept of files: as much as was asked for, and only while they hold the same."""

import hashlib
import os

import numpy as np
import pytest

from sss_ref.cache import recent as kept_recently
from sss_ref.cache.recent import Recent, file_hash, of_unchanged_file


def test_the_longest_unused_goes_first():
    recent = Recent(10)
    for key in "abc":
        recent.keep(key, key.upper(), 3)
    assert recent.get("a") == "A"
    recent.keep("d", "D", 4)  # 13 bytes: b goes
    assert [recent.get(key) for key in "abcd"] == ["A", None, "C", "D"]
    recent.keep("d", "DD", 1)  # in place of the other
    recent.keep("e", "E", 3)
    assert [recent.get(key) for key in "acde"] == ["A", "C", "DD", "E"]
    recent.keep("f", "F", 11)
    assert [recent.get(key) for key in "acdef"] == [None] * 5


def test_a_file_is_read_again_when_its_content_changes(tmp_path):
    reads = []

    @of_unchanged_file
    def read(path):
        """Its bytes."""
        reads.append(path.name)
        return np.frombuffer(path.read_bytes(), np.uint8)

    path = tmp_path / "a.bin"
    path.write_bytes(b"one")
    first = read(path)
    again = read(path)
    assert reads == ["a.bin"] and again.tobytes() == b"one" and read.__doc__ == "Its bytes."
    again[0] = 0  # it is the caller's own
    assert read(path).tobytes() == first.tobytes() == b"one"
    stat = path.stat()
    path.write_bytes(b"two")
    os.utime(path, ns=(stat.st_atime_ns, stat.st_mtime_ns))  # neither its size nor its time tells
    assert read(path).tobytes() == b"two" and reads == ["a.bin"] * 2


def test_a_read_that_fails_is_not_kept(tmp_path):
    reads = []

    @of_unchanged_file
    def read(path):
        reads.append(path)
        raise ValueError

    (tmp_path / "a").write_bytes(b"x")
    for path in (tmp_path / "a", tmp_path / "a", tmp_path / "nowhere", tmp_path):
        with pytest.raises(ValueError):
            read(path)
    assert len(reads) == 4


def test_as_much_as_was_asked_for_is_kept():
    recent = Recent(6)
    for key in "ab":
        recent.keep(key, key, 3)
    assert [recent.get(key) for key in "ab"] == ["a", "b"]
    recent.keep("c", "c", 1)
    assert [recent.get(key) for key in "abc"] == [None, "b", "c"]
    assert Recent()._limit == 2**28


def test_a_file_of_another_ending_or_that_changes_while_it_is_read_is_not_given_again(tmp_path):
    reads = []

    @of_unchanged_file
    def read(path):
        reads.append(path.name)
        if path.name == "b.bin":
            path.write_bytes(b"%d" % len(reads))
        return np.zeros(2)

    for name in ("a.bin", "a.txt", "b.bin"):
        (tmp_path / name).write_bytes(name[:1].encode())
    for name in ("a.bin", "a.txt", "a.bin", "b.bin", "b.bin"):
        read(tmp_path / name)
    assert reads == ["a.bin", "a.txt", "b.bin", "b.bin"]


def test_a_hash_is_of_a_regular_file_that_is_not_too_large(tmp_path, monkeypatch):
    path = tmp_path / "a"
    path.write_bytes(b"four")
    monkeypatch.setattr(kept_recently, "LIMIT", 4)
    assert file_hash(path) == hashlib.sha256(b"four").hexdigest()
    monkeypatch.setattr(kept_recently, "LIMIT", 3)
    assert file_hash(path) is file_hash(tmp_path) is file_hash(tmp_path / "b") is None
