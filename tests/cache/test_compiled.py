"""Where machine code is kept and under what name, and what numba is spared, without compiling anything."""

import sys

import pytest

from sss_ref.cache import compiled, left_out
from sss_ref.cache.root import cache_below


def test_the_contract_is_ieee_division_and_threads_side_by_side():
    assert compiled.CONTRACT == {"nogil": True, "error_model": "numpy"}


def test_a_fingerprint_is_of_versions_settings_and_contract(monkeypatch):
    before = compiled.fingerprint()
    assert len(before) == 16 and set(before) <= set("0123456789abcdef") and before == compiled.fingerprint()
    changed = set()
    for owner, name, other in (
        (compiled.SETTINGS, "OPT", 1),
        (compiled.SETTINGS, "BOUNDSCHECK", 1),
        (compiled, "CONTRACT", {"nogil": True, "error_model": "python"}),
        (compiled, "version", lambda package: "0"),
        (sys, "version", "another"),
    ):
        with monkeypatch.context() as patch:
            patch.setattr(owner, name, other)
            changed.add(compiled.fingerprint())
    assert len(changed) == 5 and before not in changed


@pytest.mark.parametrize(
    ("names", "cold"), [(None, True), ([], True), (["a.code", "a.part"], True), (["a.kernel"], False)]
)
def test_a_cache_is_cold_until_a_kernel_is_kept(monkeypatch, tmp_path, names, cold):
    """None: there is no folder."""
    for name in names or ():
        (tmp_path / name).write_bytes(b"")
    monkeypatch.setattr(compiled, "cache_folder", lambda: None if names is None else tmp_path)
    assert compiled.is_cold() == cold


class Kept:
    """A kernel whose cache is set."""

    _cache = "its own"


@pytest.mark.parametrize(("folder", "disabled", "is_kept"), [(True, 0, True), (True, 1, False), (False, 0, False)])
def test_code_is_kept_where_there_is_a_folder_and_a_compiler(monkeypatch, tmp_path, folder, disabled, is_kept):
    monkeypatch.setattr(compiled, "cache_folder", lambda: tmp_path if folder else None)
    monkeypatch.setattr(compiled.SETTINGS, "DISABLE_JIT", disabled)
    kernel = compiled._keeping(Kept(), len, lambda *given: given)
    assert kernel._cache == ((tmp_path, len) if is_kept else "its own")


def test_a_folder_of_the_cache_is_made_where_it_is_asked_for(monkeypatch, tmp_path):
    monkeypatch.setenv("SSS_REF_CACHE_DIR", str(tmp_path / "a" / "b"))
    assert cache_below("c") == cache_below("c") == tmp_path / "a" / "b" / "c"
    assert (tmp_path / "a" / "b" / "c").is_dir()
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("SSS_REF_CACHE_DIR", str(tmp_path / "file"))
    assert cache_below("c") is None


def test_without_a_word_it_is_the_users_own_cache(monkeypatch, tmp_path):
    asked = []
    monkeypatch.delenv("SSS_REF_CACHE_DIR", raising=False)
    monkeypatch.setattr(
        "platformdirs.user_cache_dir", lambda name, appauthor: asked.append((name, appauthor)) or str(tmp_path)
    )
    assert cache_below("c") == tmp_path / "c" and asked == [("sss_ref", False)]


def test_a_module_is_absent_once_and_only_while_numba_asks(monkeypatch):
    monkeypatch.setitem(sys.modules, "asking", sys)
    finder = left_out._Absent({"a": "asking", "b": "nobody"})
    with pytest.raises(ModuleNotFoundError, match="a: left out"):
        finder.find_spec("a", None)
    assert finder.find_spec("a", None) is None
    assert finder.find_spec("b", None) is None and finder.find_spec("c", None) is None


@pytest.mark.parametrize("settings", [False, True])
def test_yaml_is_there_where_numba_has_settings(monkeypatch, tmp_path, settings):
    """It is looked for before all others."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "meta_path", ["others"])
    if settings:
        left_out.SETTINGS.write_text("")
    left_out.leave_out()
    finder, *others = sys.meta_path
    assert others == ["others"]
    assert set(finder.left) == {"scipy", "scipy.linalg", "coverage"} | (set() if settings else {"yaml"})
