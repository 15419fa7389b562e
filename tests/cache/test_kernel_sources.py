"""What a kernel depends on is found by the text of imports: held to Python's own reading of them."""

import ast
import shutil

import pytest

from sss_ref.cache import kernel_sources
from sss_ref.cache.kernel_sources import PACKAGE, imported, sources_hash

FILES = sorted(PACKAGE.rglob("*.py"))


def by_its_tree(source):
    """The files of the package that a source imports, as Python reads it."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert not node.level
            names = [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
        else:
            continue
        for name in names:
            first, *rest = name.split(".")
            path = PACKAGE.joinpath(*rest)
            if first == "sss_ref":
                found |= {each for each in (path.with_suffix(".py"), path / "__init__.py") if each.is_file()}
    return found


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_imports_are_found(path):
    source = path.read_text()
    assert set(imported(source)) >= by_its_tree(source)


def test_every_file_that_is_reached_counts(tmp_path, monkeypatch):
    """a imports b inside a function, b imports c by the name of its package; d is nobody's."""
    package = tmp_path / "sss_ref"
    texts = {
        "a": "def f():\n    from sss_ref.b import g\n",
        "b": "from sss_ref import (\n    c,\n)\n",
        "c": "X = 1\n",
        "d": "",
    }

    def hash_with(**changes):
        shutil.rmtree(package, ignore_errors=True)
        package.mkdir()
        for name, text in (texts | changes).items():
            (package / f"{name}.py").write_text(text)
        sources_hash.cache_clear()
        kernel_sources._read.cache_clear()
        kernel_sources.linecache.clearcache()
        return sources_hash(str(package / "a.py"))

    monkeypatch.setattr(kernel_sources, "PACKAGE", package)
    before = hash_with()
    assert hash_with(d="Y = 1\n") == before
    assert len({before, *(hash_with(**{name: texts[name] + "# a remark\n"}) for name in "abc")}) == 4
    sources_hash.cache_clear()


def test_what_has_no_source_has_no_hash():
    assert sources_hash("<nowhere>") is None
