"""The cache of machine code saves time and is never wrong; a rendering uses little memory beyond its result."""

import shutil
import tracemalloc
from pathlib import Path

import pytest
from fresh_process import hashes_and_words, hashes_elsewhere, machine_code
from scenes import around, cube, sphere, written

import sss_ref
from sss_ref.cache.spare_memory import SPARE
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

KEEP = ["position_world"]


@pytest.fixture
def package(tmp_path):
    """A copy of the package that a test may edit: the folder it is imported from."""
    source = Path(sss_ref.__file__).parent
    shutil.copytree(source, tmp_path / "copy" / "sss_ref", ignore=shutil.ignore_patterns("__pycache__", "data"))
    return tmp_path / "copy"


def test_an_edited_callee_is_compiled_anew(package, tmp_path):
    """The kernel and all that it calls by name stay the same; only a function two calls away changes.

    numba alone would serve the old code: it looks at the file of the kernel and at no other.
    """
    scene = around(written(tmp_path / "cube.obj", *cube()), size=32)
    cache = tmp_path / "cache"
    before = hashes_elsewhere(scene, cache, keep=KEEP, package=package)
    code = machine_code(cache)
    assert len(code) > 10

    assert hashes_elsewhere(scene, cache, keep=KEEP, package=package) == before
    assert machine_code(cache) == code

    callee = package / "sss_ref" / "raster" / "primitives.py"
    original = "np.rint((window - HALF) * np.float32(step))"
    assert callee.read_text().count(original) == 1
    callee.write_text(callee.read_text().replace(original, "np.float32(0.5) * " + original))
    after = hashes_elsewhere(scene, cache, keep=KEEP, package=package)
    assert after.keys() == before.keys() == {"position_world"}
    assert after != before
    assert code.items() < machine_code(cache).items()


def test_an_edit_leaves_the_machine_code_of_what_does_not_import_it(package, tmp_path):
    scene = around(written(tmp_path / "cube.obj", *cube()), size=32)
    cache = tmp_path / "cache"
    before = hashes_elsewhere(scene, cache, keep=KEEP, package=package)
    code = machine_code(cache)
    for name in ("passes/camera.py", "results/diff.py", "interpret/kernel/planned.py"):
        edited = package / "sss_ref" / name
        edited.write_text(edited.read_text() + "\n# A remark.\n")
    assert hashes_elsewhere(scene, cache, keep=KEEP, package=package) == before
    assert machine_code(cache) == code


@pytest.mark.parametrize("damage", ["cut off", "emptied", "one bit"])
def test_a_damaged_file_is_told_and_written_again(tmp_path, damage):
    scene = around(written(tmp_path / "cube.obj", *cube()), size=32)
    cache = tmp_path / "cache"
    before, said = hashes_and_words(scene, cache, keep=KEEP)
    code = machine_code(cache)
    assert said == ""
    for path in code:
        content = bytearray(path.read_bytes())
        content[len(content) // 2] ^= 4
        path.write_bytes({"cut off": content[: len(content) // 2], "emptied": b"", "one bit": content}[damage])
    hashes, said = hashes_and_words(scene, cache, keep=KEEP)
    assert hashes == before
    told = said.splitlines()
    assert len(told) == len({line.partition(":")[0] for line in told}) > 10
    assert all(
        line.endswith("expected a whole file, got a damaged one; it is compiled and written again") for line in told
    )
    assert hashes_and_words(scene, cache, keep=KEEP) == (before, "")
    assert machine_code(cache).keys() == code.keys()


@pytest.mark.parametrize("preset", ["paper", "robust"])
def test_a_rendering_needs_half_as_much_again_as_it_keeps(tmp_path, preset):
    """All that NumPy allocates is traced; a first rendering has compiled and allocated what stays."""
    path = written(tmp_path / "sphere.obj", *sphere(24))
    scene = load_scene(around(path, size=512, preset=preset))
    render(scene, threads=2)
    SPARE.blocks.clear()
    tracemalloc.start()
    try:
        result = render(scene, threads=2)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    kept = sum(buffer.nbytes for buffer in result.buffers.values())
    assert kept > 512 * 512 * 100
    assert kept < peak <= 1.5 * kept
