"""What a command loads: nothing that only other commands, methods or formats need."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import sss_ref

SMALL = ("--size", "16x16", "--set", "shadow_map.width=16", "--set", "shadow_map.height=16")
GIVEN = {"cache", "cli", "errors", "mesh", "numerics", "scene_file", "view"}
DRAWN = GIVEN | {"interpret", "language", "methods", "passes", "raster", "rendering", "rules", "scene"}
OTHERS = {"scipy", "coverage", "yaml", "trimesh", "imageio", "zarr", "tifffile", "skimage", "matplotlib", "websockets"}
PROGRAM = """
import sys
from sss_ref.cache.left_out import leave_out
from sss_ref.cli import main
leave_out()
assert main(sys.argv[1:]) == 0
print(*sys.modules)
"""


def loaded_by(*arguments):
    """The modules that a process has loaded when a command ends."""
    environment = {**os.environ, "PYTHONPATH": str(Path(sss_ref.__file__).parents[1])}
    command = [sys.executable, "-c", PROGRAM, *arguments]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()[-1].split()


def rooms(modules):
    """The folders and files of the package that some of its modules are in."""
    return {name.split(".")[1] for name in modules if name.startswith("sss_ref.")}


def within(prefix, modules):
    """The modules in a package, without its name."""
    return {name.removeprefix(prefix) for name in modules if name.startswith(prefix)}


@pytest.fixture(scope="module")
def drawn(tmp_path_factory):
    """A result folder, and what was loaded for it; twice, for compilation loads what kernels that are kept do not."""
    folder = tmp_path_factory.mktemp("drawn") / "out"
    words = ("render", "wedge", *SMALL, "-o", str(folder))
    loaded_by(*words)
    return folder, loaded_by(*words)


def test_a_rendering_loads_its_own_method_and_format(drawn):
    _, modules = drawn
    assert rooms(modules) == DRAWN | {"pictures", "results"}
    assert within("sss_ref.methods.", modules) == {
        "inner_body",
        "parallel_views",
        "per_light",
        "screen_space",
        "shared",
    }
    assert not within("sss_ref.mesh.gltf", modules)
    assert not OTHERS & {*modules}


def test_validation_loads_what_judges_and_nothing_that_explains(drawn):
    folder, _ = drawn
    words = ("validate", "wedge", str(folder / "buffers"), *SMALL)
    loaded_by(*words)
    modules = loaded_by(*words)
    assert rooms(modules) == DRAWN | {"capture", "dump", "pictures", "results", "validation"}
    assert not {"report_page", "junit"} & within("sss_ref.validation.report.", modules)
    assert not (OTHERS | {"PIL", "OpenEXR"}) & {*modules}


@pytest.mark.parametrize("words", [("info", "wedge"), ("scenes",), ("--help",)], ids=" ".join)
def test_what_draws_nothing_loads_no_compiler(words):
    modules = loaded_by(*words)
    assert rooms(modules) <= GIVEN
    assert not (OTHERS | {"numba", "llvmlite", "PIL", "OpenEXR"}) & {*modules}
