"""Files of the cache are whole or not there."""

from pathlib import Path

from sss_ref.cache.whole_files import keep, kept


def test_a_full_disk_leaves_nothing_behind(tmp_path, monkeypatch, caplog):
    def cut_off(path, content):
        path.touch()
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", cut_off)
        keep(tmp_path / "a.code", b"code")
    assert list(tmp_path.iterdir()) == []
    assert caplog.messages == [
        f"{tmp_path / 'a.code'}: expected a file that can be written, got No space left on device; "
        "the next process compiles again"
    ]
    keep(tmp_path / "a.code", b"code")
    assert kept(tmp_path / "a.code") == b"code" and len(list(tmp_path.iterdir())) == 1
