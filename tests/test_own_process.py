"""`sss-ref` as a process of its own: set up for a short run, and nobody else's SciPy is in its way."""

import subprocess
import sys

import pytest

RUN = """
import gc, sys
from sss_ref.cli.own_process import NEW_OBJECTS, run
sys.argv = ["sss-ref", *{arguments}]
try:
    run()
except SystemExit as left:
    assert gc.get_threshold()[0] == NEW_OBJECTS
    sys.exit(left.code)
"""


def of_new_process(program):
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)


def test_the_exit_code_is_that_of_the_command_line():
    assert of_new_process(RUN.format(arguments=["scenes"])).returncode == 0
    assert of_new_process(RUN.format(arguments=["info", "nowhere.toml"])).returncode == 2


@pytest.mark.parametrize(("before", "loads"), [("leave_out()", False), ("", True)])
def test_kernels_load_without_scipys_linear_algebra_if_it_is_left_out(before, loads):
    pytest.importorskip("scipy.linalg")
    program = f"""
import sys
import numba
import numpy as np
from sss_ref.cache.left_out import leave_out
from sss_ref.numerics.scalar import exp_scalar
{before}
exp_scalar(np.float32(1))
numba.njit(lambda x: x + x)(1)  # what is compiled asks for all that numba knows
print("scipy.linalg" in sys.modules)
import scipy.linalg.cython_blas
"""
    done = of_new_process(program)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == [str(loads)]
