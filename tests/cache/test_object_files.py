"""Modules in LLVM's language: compiled once, then found in a folder; never another's code."""

import pytest

from sss_ref.cache import object_files

MODULE = "define i32 @seven() {\nret i32 7\n}"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Where they are kept."""
    monkeypatch.setattr(object_files, "cache_folder", lambda: tmp_path)
    return tmp_path


def refused():
    """A module that nobody asks for."""
    raise AssertionError


def test_the_second_time_nothing_is_compiled(folder):
    code = object_files.object_code("seven", "source", lambda: MODULE)
    assert code == object_files.object_code("seven", "source", refused)
    (path,) = folder.iterdir()
    assert path.name.startswith("seven-") and path.suffix == ".code" and path.read_bytes().endswith(code)


def test_other_sources_and_another_processor_have_files_of_their_own(folder, monkeypatch):
    object_files.object_code("seven", "source", lambda: MODULE)
    object_files.object_code("seven", "edited", lambda: MODULE)
    codegen = object_files.PROCESSOR.target_context.codegen()
    triple, _, _ = codegen.magic_tuple()
    monkeypatch.setattr(codegen, "magic_tuple", lambda: (triple, "generic", ""))
    object_files.object_code("seven", "source", lambda: MODULE)
    assert len(list(folder.iterdir())) == 3


def test_a_damaged_file_is_told_and_replaced(folder, caplog):
    code = object_files.object_code("seven", "source", lambda: MODULE)
    (path,) = folder.iterdir()
    path.write_bytes(path.read_bytes()[:-1])
    assert object_files.object_code("seven", "source", lambda: MODULE) == code
    assert [record.getMessage() for record in caplog.records] == [
        f"{path}: expected a whole file, got a damaged one; it is compiled and written again"
    ]
    assert object_files.object_code("seven", "source", refused) == code


def test_without_a_folder_it_is_compiled_each_time(monkeypatch):
    monkeypatch.setattr(object_files, "cache_folder", lambda: None)
    assert object_files.object_code("seven", "source", lambda: MODULE)
    with pytest.raises(AssertionError):
        object_files.object_code("seven", "source", refused)
