"""The same bits whatever the machine and the compiler are told: each setting in a process with an empty cache."""

import os
import subprocess
import sys

import pytest
from fresh_process import hashes_elsewhere, machine_code
from numpy._core import _multiarray_umath as numpy_build
from scenes import around, cube, sphere, written

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

# What this NumPy can choose at run time and this processor has.
VECTOR_UNITS = " ".join(name for name in numpy_build.__cpu_dispatch__ if numpy_build.__cpu_features__[name])
GENERIC = {"NUMBA_CPU_NAME": "generic"}
UNOPTIMIZED = {"NUMBA_OPT": "0"}
WITHOUT_VECTORS = {"NPY_DISABLE_CPU_FEATURES": VECTOR_UNITS}

SETTINGS = {
    "one thread": {"threads": 1},
    "two threads": {"threads": 2},
    "four threads": {"threads": 4},
    "any processor": GENERIC,
    "this processor": {"NUMBA_CPU_NAME": "host"},
    "unoptimized": UNOPTIMIZED,
    "optimized": {"NUMBA_OPT": "3"},
    "NumPy without vector units": WITHOUT_VECTORS,
}


METHODS = ("screen_space", "texture_space")


@pytest.fixture(scope="module", params=METHODS)
def scene(request, tmp_path_factory):
    """Every kind of arithmetic in one small scene: pow with a varying base, the shadow test, a masked blur."""
    path = written(tmp_path_factory.mktemp("sphere") / "sphere.obj", *sphere(16))
    irradiance_map = {"width": 64, "height": 64}
    return around(path, size=64, method=request.param, preset="robust", irradiance_map=irradiance_map)


@pytest.fixture(scope="module")
def plain_cache(tmp_path_factory):
    """Where a plain processor and compiler keep the kernels that both methods need."""
    return tmp_path_factory.mktemp("plain") / "cache"


@pytest.fixture(scope="module")
def hashes(scene):
    return render(load_scene(scene), threads=1).hashes


def compiled_elsewhere(scene, cache, **settings):
    """The hashes of a process that has compiled everything itself."""
    assert not cache.exists()
    found = hashes_elsewhere(scene, cache, **settings)
    assert len(machine_code(cache)) > 20
    return found


def test_a_plain_processor_and_compiler_give_the_same_bits(scene, hashes, plain_cache):
    settings = GENERIC | UNOPTIMIZED | WITHOUT_VECTORS
    assert hashes_elsewhere(scene, plain_cache, threads=2, **settings) == hashes
    assert len(machine_code(plain_cache)) > 20


@pytest.mark.full
@pytest.mark.parametrize("name", SETTINGS)
def test_every_setting_gives_the_same_bits(scene, hashes, tmp_path, name):
    assert compiled_elsewhere(scene, tmp_path / "cache", **SETTINGS[name]) == hashes


@pytest.mark.parametrize("threads", [2, 3, 4, 7])
def test_the_number_of_threads_changes_no_bit(scene, hashes, threads):
    assert render(load_scene(scene), threads=threads).hashes == hashes


def test_python_itself_gives_the_same_bits(tmp_path):
    """With numba's compiler off, the kernels run as the Python that they are."""
    scene = around(written(tmp_path / "cube.obj", *cube()), size=32, preset="robust")
    cache = tmp_path / "cache"
    assert hashes_elsewhere(scene, cache, NUMBA_DISABLE_JIT="1") == render(load_scene(scene)).hashes
    assert not machine_code(cache)


@pytest.mark.skipif(not VECTOR_UNITS, reason="this NumPy has nothing to switch off on this processor")
def test_the_vector_units_of_numpy_can_be_switched_off():
    """Without this, the test above could compare a setting with itself."""
    left = "[name for name in n.__cpu_dispatch__ if n.__cpu_features__[name]]"
    ask = f"from numpy._core import _multiarray_umath as n; print({left})"
    done = subprocess.run(
        [sys.executable, "-c", ask], env=os.environ | WITHOUT_VECTORS, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
