"""Modules in LLVM's language: compiled once, then found in a folder; never another's code."""

import ctypes

import pytest

from sss_ref.cache import object_files
from sss_ref.cache.linked import address_of_linked

MODULE = "define i32 @{}() {{\nret i32 7\n}}"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Where they are kept."""
    monkeypatch.setattr(object_files, "cache_folder", lambda: tmp_path)
    return tmp_path


def seven(symbol, module=None, sources="source"):
    """What the function of a module returns, which is 7; module: writes it."""
    object_files.link_object_code("seven", sources, module or (lambda: MODULE.format(symbol)), symbol)
    return ctypes.CFUNCTYPE(ctypes.c_int32)(address_of_linked(symbol))()


def refused():
    """A module that nobody asks for."""
    raise AssertionError


def test_the_second_time_nothing_is_compiled(folder):
    assert seven("second_time") == seven("second_time", refused) == 7
    (path,) = folder.iterdir()
    assert path.name.startswith("seven-") and path.suffix == ".code"


def test_other_sources_and_another_processor_have_files_of_their_own(folder, monkeypatch):
    assert seven("other_a") == seven("other_b", sources="edited") == 7
    codegen = object_files.PROCESSOR.target_context.codegen()
    triple, _, _ = codegen.magic_tuple()
    monkeypatch.setattr(codegen, "magic_tuple", lambda: (triple, "generic", ""))
    assert seven("other_c") == 7
    assert len(list(folder.iterdir())) == 3


def test_a_damaged_file_is_told_and_replaced(folder, caplog):
    assert seven("damaged") == 7
    (path,) = folder.iterdir()
    path.write_bytes(path.read_bytes()[:-1])
    assert seven("damaged") == 7
    assert [record.getMessage() for record in caplog.records] == [
        f"{path}: expected a whole file, got a damaged one; it is compiled and written again"
    ]
    assert seven("damaged", refused) == 7


def test_a_whole_file_with_other_code_is_told_and_replaced(folder, caplog):
    """Its function would begin at 0, where nobody may jump to."""
    assert seven("not_asked_for") == 7
    (path,) = folder.iterdir()
    wrong = path.read_bytes()
    assert seven("wanted") == 7 and path.read_bytes() != wrong
    assert [record.getMessage() for record in caplog.records] == [
        f"{path}: expected the code of wanted, got none of that name; it is compiled and written again"
    ]
    assert seven("wanted", refused) == 7


def test_without_a_folder_it_is_compiled_each_time(monkeypatch):
    monkeypatch.setattr(object_files, "cache_folder", lambda: None)
    assert seven("each_time") == 7
    with pytest.raises(AssertionError):
        seven("each_time", refused)
