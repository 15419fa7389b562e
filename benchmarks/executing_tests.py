"""Which tests execute a line of the package, and how long each takes: recorded once, asked for every mutant.

    python benchmarks/executing_tests.py FOLDER tests/view tests/mesh    # a piece in a process, kept under its name

A piece is a file or a folder of tests. FOLDER keeps of each what coverage saw, test by test, the times, and the commit.
It sees the processes that a test starts as well, as far as they are given its environment and end by themselves.
"""

import argparse
import os
import re
import subprocess
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

from coverage import CoverageData

HERE = Path(__file__).resolve().parents[1]
ALONE = ["-o", "addopts=--import-mode=importlib", "-q", "-m", "not full"]  # with xdist's options no test has a context
# What a process that a test starts executes counts for the test that pytest says to be running at its start.
CONFIGURATION = """[run]
include = */sss_ref/*
relative_files = true
parallel = true
context = ${PYTEST_CURRENT_TEST-}
[paths]
sources =
    sss_ref
    */sss_ref
"""
# pytest-cov measures this process; a variable that it had from the start would have coverage measure it twice.
PYTEST = "import os, sys, pytest; os.environ['COVERAGE_PROCESS_START'] = sys.argv.pop(1); sys.exit(pytest.main())"
STEPS = re.compile(r"(\|(setup|run|teardown)| \((setup|call|teardown)\))$")  # of a test, here and in its processes


def main() -> None:
    """Record pieces."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("pieces", nargs="+")
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    for piece in asked.pieces:
        print(piece, record(asked.folder.resolve(), piece), flush=True)


def record(folder: Path, piece: str) -> str:
    """Run a piece of the tests under coverage; the last line that pytest prints."""
    name = piece.replace("/", ".")
    configuration = folder / "coveragerc"
    configuration.write_text(CONFIGURATION, encoding="utf-8")
    command = [sys.executable, "-c", PYTEST, str(configuration), *ALONE, f"--junitxml={folder / name}.xml", "--cov"]
    command += ["--cov-context=test", "--cov-report=", f"--cov-config={configuration}", piece]
    environment = {**os.environ, "COVERAGE_FILE": f"{folder / name}.coverage", "PYTHONPATH": str(HERE)}
    (folder / f"{name}.commit").write_text(git("rev-parse", "HEAD"), encoding="utf-8")
    done = subprocess.run(command, cwd=HERE, env=environment, capture_output=True, text=True, check=False)
    return (done.stdout.splitlines() or [done.stderr])[-1]


def git(*words: str) -> str:
    """What git prints."""
    return subprocess.run(["git", *words], cwd=HERE, capture_output=True, text=True, check=True).stdout.strip()


class Recorded:
    """What a folder of recordings says."""

    def __init__(self, folder: Path) -> None:
        """folder: as `record` has filled it. seconds: the tests that were run -> what each took, under coverage."""
        self._pieces = [Piece(path) for path in sorted(folder.glob("*.coverage"))]

        self.seconds = {test: each for piece in self._pieces for test, each in piece.seconds().items()}

    def keep(self, tests: set[str]) -> None:
        """Forget all tests but these."""
        self.seconds = {test: each for test, each in self.seconds.items() if test in tests}

    def executing(self, path: Path, lines: Iterable[int]) -> set[str]:
        """The tests that execute one of these lines of a file of the package, or may, because it changed since."""
        return {test for piece in self._pieces for test in piece.executing(f"sss_ref/{path}", lines)} & set(
            self.seconds
        )

    def executing_file(self, path: Path) -> set[str]:
        """The tests that execute anything of a file."""
        return self.executing(path, range(1, 1000))


class Piece:
    """What one process recorded."""

    def __init__(self, path: Path) -> None:
        """path: of what coverage saw; the rest lies beside it."""
        self._path = path
        self._data = CoverageData(str(path))
        self._data.read()
        self._contexts = cache(self._data.contexts_by_lineno)

    def seconds(self) -> dict[str, float]:
        """The tests that were run -> the seconds that each took; some fail because coverage is there and count too."""
        cases = ElementTree.parse(self._path.with_suffix(".xml")).iter("testcase")
        return {name_of(case): float(case.get("time", 0)) for case in cases if case.find("skipped") is None}

    def executing(self, path: str, lines: Iterable[int]) -> set[str]:
        """The tests that execute one of these lines, if there are any; any line, if the file has changed since."""
        contexts = self._contexts(path)
        lines = list(lines)
        if lines and path in changed_since(self._path.with_suffix(".commit").read_text(encoding="utf-8").strip()):
            lines = contexts
        return {STEPS.sub("", test) for line in lines for test in contexts.get(line, ())} - {""}


def name_of(case: ElementTree.Element) -> str:
    """The name by which pytest runs a test: tests/view/test_x.py::test_y[z]."""
    return f"{case.get('classname', '').replace('.', '/')}.py::{case.get('name')}"


@cache
def changed_since(commit: str) -> frozenset[str]:
    """The files of the package that are not as they were in a commit."""
    return frozenset(git("diff", "--name-only", commit, "--", "sss_ref").splitlines())


if __name__ == "__main__":
    main()
