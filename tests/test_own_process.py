"""`sss-ref` as a process of its own: set up for a short run, and nobody else's libraries are in its way."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import sss_ref

RUN = """
import gc, os, sys
from sss_ref.cli.own_process import NEW_OBJECTS, run
sys.argv = ["sss-ref", *{arguments}]
try:
    run()
except SystemExit as left:
    assert gc.get_threshold()[0] == NEW_OBJECTS and gc.get_freeze_count()
    print(os.environ["OPENBLAS_NUM_THREADS"])
    sys.exit(left.code)
"""


THREE = 'import os; os.environ["OPENBLAS_NUM_THREADS"] = "3"'


def of_new_process(program, folder=None):
    environment = {**os.environ, "PYTHONPATH": str(Path(sss_ref.__file__).parents[1])}
    environment.pop("OPENBLAS_NUM_THREADS", None)
    command = [sys.executable, "-c", program]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def test_the_exit_code_is_that_of_the_command_line():
    assert of_new_process(RUN.format(arguments=["scenes"])).returncode == 0
    assert of_new_process(RUN.format(arguments=["info", "nowhere.toml"])).returncode == 2


@pytest.mark.parametrize(("before", "threads"), [("", "1"), (THREE, "3")])
def test_numpy_has_one_thread_unless_asked_for_more(before, threads):
    assert of_new_process(before + RUN.format(arguments=["--version"])).stdout.split()[-1] == threads


LOADED = """
import sys
import numpy as np
{before}
import numba
from sss_ref.numerics.scalar import exp_scalar
exp_scalar(np.float32(1))
print(*(name for name in ("scipy", "coverage", "yaml") if name in sys.modules), numba.config.DEBUG_ARRAY_OPT)
numba.njit(lambda x: x + x)(1)  # what is compiled asks for all that numba knows
print("scipy.linalg" in sys.modules)
import coverage, scipy.linalg.cython_blas, yaml
"""
LEAVE_OUT = "from sss_ref.cache.left_out import leave_out; leave_out()"


@pytest.mark.parametrize(
    ("before", "settings", "loaded", "blas"),
    [
        ("", "", "scipy coverage yaml 0", "True"),
        ("", "debug_array_opt: 1", "scipy coverage yaml 1", "True"),
        (LEAVE_OUT, "", "0", "False"),
        (LEAVE_OUT, "debug_array_opt: 1", "yaml 1", "False"),
    ],
)
def test_kernels_load_without_what_numba_asks_for_if_it_is_left_out(before, settings, loaded, blas, tmp_path):
    """Its settings are read all the same."""
    for name in ("scipy.linalg", "coverage", "yaml"):
        pytest.importorskip(name)
    if settings:
        (tmp_path / ".numba_config.yaml").write_text(settings)
    done = of_new_process(LOADED.format(before=before), tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [loaded, blas]
