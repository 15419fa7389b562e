"""A damaged file of machine code is told in one line and written again, whatever was done to it."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

PROCESS = Path(__file__).parents[1] / "support" / "damaged_cache.py"
PACKAGE = Path(__file__).parents[2]
SEEDS = 40


@pytest.mark.skipif(sys.platform == "win32", reason="links and pipes")
def test_forty_damages(tmp_path):
    own = {"SSS_REF_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(PACKAGE)}
    command = [sys.executable, str(PROCESS), *map(str, range(SEEDS))]
    done = subprocess.run(command, env={**os.environ, **own}, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stderr
    results = [line.split() for line in done.stdout.splitlines()]
    assert len({damage for damage, *_ in results}) == 10 and len(results) == SEEDS
    for damage, given, hits, whole in results:
        assert (given, hits, whole) == ("21.0", "1", "True"), damage
    told = done.stderr.splitlines()
    assert len(told) == SEEDS
    assert all(": expected a whole file, got " in line for line in told)
    assert all(line.endswith("; it is compiled and written again") for line in told)
