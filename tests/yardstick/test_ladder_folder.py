"""Where a measurement may be written."""

import pytest

from sss_ref.errors import DumpError
from sss_ref.yardstick.ladder_folder import checked_folder


def test_a_new_an_empty_and_an_earlier_folder(tmp_path):
    assert checked_folder(tmp_path / "new") == tmp_path / "new"
    assert checked_folder(tmp_path) == tmp_path
    (tmp_path / "truth").mkdir()
    for name in ("measure.html", "measure.json", "measure.md"):
        (tmp_path / name).touch()
    assert checked_folder(tmp_path) == tmp_path


def test_other_files_are_not_written_over(tmp_path):
    (tmp_path / "measure.html").touch()
    (tmp_path / "thesis.tex").touch()
    for folder in (tmp_path, tmp_path / "thesis.tex"):
        with pytest.raises(DumpError) as error:
            checked_folder(folder)
        assert str(error.value) == (
            f"{folder}: expected a new folder or one of sss-ref measure, got other files; choose another folder"
        )
