"""Where a package may lie: in a folder that nobody can write to, without a cache, or with one that several begin."""

import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from fresh_process import hashes_and_words, machine_code
from scenes import around, cube, written

import sss_ref
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

KEEP = ["position_world"]


@pytest.fixture
def scene(tmp_path):
    return around(written(tmp_path / "cube.obj", *cube()), size=32)


@pytest.fixture
def expected(scene):
    return render(load_scene(scene), keep=KEEP).hashes


@pytest.fixture
def read_only(tmp_path):
    """A copy of the package that cannot be written to, but by root: the folder it is imported from."""
    copy = tmp_path / "site"
    shutil.copytree(Path(sss_ref.__file__).parent, copy / "sss_ref", ignore=shutil.ignore_patterns("__pycache__"))
    folders = [copy, *(path for path in copy.rglob("*") if path.is_dir())]
    for folder in folders:
        folder.chmod(0o555)
    yield copy
    for folder in folders:
        folder.chmod(0o755)


def listing(folder):
    """Every file below a folder, and when it was written."""
    return {path: path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("cache", [pytest.param("elsewhere", marks=pytest.mark.full), "cube.obj/below"])
def test_nothing_is_written_beside_the_package(scene, expected, read_only, tmp_path, cache):
    """With a cache in another folder, and with none, as no folder can be made below a file."""
    before = listing(read_only)
    found, said = hashes_and_words(scene, tmp_path / cache, keep=KEEP, package=read_only)
    assert (found, said) == (expected, "")
    assert listing(read_only) == before
    assert bool(machine_code(tmp_path / cache)) == (cache == "elsewhere")


@pytest.mark.full
def test_two_processes_with_one_cold_cache(scene, expected, tmp_path):
    """Both are right, and leave a cache that a third uses as it is."""
    with ThreadPoolExecutor(2) as pool:
        both = list(pool.map(lambda _: hashes_and_words(scene, tmp_path / "cache", keep=KEEP), range(2)))
    assert both == [(expected, "")] * 2
    left = machine_code(tmp_path / "cache")
    assert len(left) > 10
    assert hashes_and_words(scene, tmp_path / "cache", keep=KEEP) == (expected, "")
    assert machine_code(tmp_path / "cache") == left


@pytest.mark.parametrize("mask", [0o077, 0o022, 0o007])
def test_a_result_is_readable_as_the_umask_says(scene, tmp_path, mask):
    result = render(load_scene(scene), keep=KEEP)
    before = os.umask(mask)
    try:
        result.save(tmp_path / "out")
    finally:
        os.umask(before)
    modes = {path: path.stat().st_mode & 0o777 for path in [tmp_path / "out", *(tmp_path / "out").rglob("*")]}
    assert {mode for path, mode in modes.items() if path.is_dir()} == {0o777 & ~mask}
    assert {mode for path, mode in modes.items() if path.is_file()} == {0o666 & ~mask}
