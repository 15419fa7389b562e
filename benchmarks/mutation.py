"""Does a test fail for every mistake in the sources? One place changed at a time, and the tests of its room run.

    python benchmarks/mutation.py --count 40 --seed 1            # a sample of the whole package
    python benchmarks/mutation.py view/light_fit.py numerics     # of some files and rooms
    python benchmarks/mutation.py --limit 60                     # with no tests that take longer than a minute

A place is an operator, a comparison, a number, a truth value, a `not`, outside types and decorators. Each is changed in
a copy of the package; then the tests in the file that mirrors the source are run, and those of its room. Before, they
are run on the package as it is: those that fail, or take longer than the limit, are named, and their sources count
nowhere. Printed are the survivors, then the score: the share of mutants that make a test fail, or tests take four times
as long and half a minute.
"""

import argparse
import ast
import copy
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]
PACKAGE = HERE / "sss_ref"
SWAPPED = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.Add: ast.Sub, ast.Sub: ast.Add,
    ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult, ast.And: ast.Or, ast.Or: ast.And,
    ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.RShift: ast.LShift, ast.LShift: ast.RShift,
}  # fmt: skip


@dataclass(frozen=True)
class Mutant:
    """A source with one place changed."""

    path: Path  # relative to the package
    line: int
    before: str
    after: str
    source: str  # the whole file, changed

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.before} -> {self.after}"


def main() -> None:
    """Run a sample and print what survives."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "places", nargs="*", type=Path, help="files and rooms, relative to sss_ref; all of it by default"
    )
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=float("inf"), help="begin no mutant after so many")
    parser.add_argument("--limit", type=float, default=900, help="seconds that a file or room of tests may take")
    asked = parser.parse_args()
    every = [mutant for path in sources(asked.places) for mutant in mutants(path)]
    sample = random.Random(asked.seed).sample(every, min(asked.count, len(every)))
    start, stopped, survivors, left_out = time.monotonic(), 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        checkout = copied(Path(folder))
        baselines = Baselines(checkout, asked.limit)
        for mutant in sample:
            if time.monotonic() - start > 60 * asked.minutes:
                break
            tests = baselines.of(mutant.path)
            if not tests:
                left_out += 1
            elif is_stopped(checkout, mutant, tests):
                stopped += 1
            else:
                survivors += 1
                print(f"survived: {mutant}", flush=True)
    tried = stopped + survivors
    low, high = interval(stopped, max(tried, 1))
    share = f"{stopped / max(tried, 1):.0%} (of all {len(every)} places {low:.0%} to {high:.0%} with 95 %)"
    print(f"{stopped} of {tried} stopped, {share}, seed {asked.seed}; {left_out} not tried")


def interval(hits: int, tries: int) -> tuple[float, float]:
    """Where the share in the whole lies with 95 %, by a sample of it (Wilson 1927)."""
    deviations = 1.959964  # of the normal distribution
    share, spread = hits / tries, deviations**2 / tries
    middle = (share + spread / 2) / (1 + spread)
    half = deviations * math.sqrt(share * (1 - share) / tries + spread / (4 * tries)) / (1 + spread)
    return middle - half, middle + half


def sources(places: list[Path]) -> Iterator[Path]:
    """The files of the package that are meant, relative to it."""
    for place in map(PACKAGE.joinpath, places or [Path()]):
        for path in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
            yield path.relative_to(PACKAGE)


def mutants(path: Path) -> Iterator[Mutant]:
    """Every mutant of a file."""
    text = (PACKAGE / path).read_text(encoding="utf-8")
    tree = ast.parse(text)
    apart = {id(part) for node in ast.walk(tree) for branch in not_computed(node) for part in ast.walk(branch)}
    for node in ast.walk(tree):
        for changed in () if id(node) in apart else changes(node):
            before, after = ast.get_source_segment(text, node) or "", f"({ast.unparse(changed)})"
            lines = text.splitlines(keepends=True)
            first, last = node.lineno - 1, node.end_lineno - 1
            head = lines[first].encode()[: node.col_offset].decode()
            tail = lines[last].encode()[node.end_col_offset :].decode()
            source = "".join([*lines[:first], head, after, tail, *lines[last + 1 :]])
            yield Mutant(path, node.lineno, " ".join(before.split()), after, source)


def not_computed(node: ast.AST) -> list[ast.AST]:
    """What of a node says a type or how a function is made; A | B is a type at a file's top level."""
    found = [getattr(node, "annotation", None), getattr(node, "returns", None), *getattr(node, "decorator_list", [])]
    if isinstance(node, ast.Module):
        found += [each.value for each in node.body if isinstance(each, ast.Assign) and is_union(each.value)]
    return [each for each in found if each]


def is_union(node: ast.AST) -> bool:
    """Whether an expression is A | B."""
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr)


def changes(node: ast.AST) -> Iterator[ast.AST]:
    """The same expression with its own operator, comparison or value changed."""
    if isinstance(node, ast.BinOp | ast.BoolOp) and type(node.op) in SWAPPED:
        yield changed_copy(node, op=SWAPPED[type(node.op)]())
    elif isinstance(node, ast.Compare) and type(node.ops[0]) in SWAPPED:
        yield changed_copy(node, ops=[SWAPPED[type(node.ops[0])](), *node.ops[1:]])
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
        yield node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield changed_copy(node, value=not node.value)
    elif isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        yield changed_copy(node, value=node.value + 1)


def changed_copy(node: ast.AST, **fields: object) -> ast.AST:
    """A copy of a node with some fields replaced."""
    other = copy.copy(node)
    for name, value in fields.items():
        setattr(other, name, value)
    return other


def tests_of(path: Path) -> tuple[str, ...]:
    """The tests of a source: the file that mirrors it, then those of its folder, or of the nearest above."""
    mirrored = Path("tests") / path.with_name(f"test_{path.name}")
    first = (str(mirrored),) if (HERE / mirrored).exists() else ()
    for folder in path.parents[:-1]:
        if any((HERE / "tests" / folder).glob("test_*.py")):
            return (*first, str(Path("tests") / folder))
    about = sorted((HERE / "tests").glob(f"test_{path.with_suffix('').parts[0]}*.py"))
    return first or tuple(str(each.relative_to(HERE)) for each in about)


def copied(folder: Path) -> Path:
    """Copy the checkout, as far as tests read it."""
    skipped = shutil.ignore_patterns(".git", "__pycache__", ".*_cache", "_build", "shared")
    return Path(shutil.copytree(HERE, folder / "checkout", ignore=skipped, symlinks=True))


class Baselines:
    """The tests of the package as it is: which pass in time, and how long they take."""

    def __init__(self, checkout: Path, limit: float) -> None:
        """limit: the seconds that a file or a folder of tests may take."""
        self._checkout, self._limit = checkout, limit
        self._seconds: dict[str, float] = {}  # 0 if they fail or take longer

    def of(self, path: Path) -> dict[str, float]:
        """The tests of a source -> the seconds they take; none if not all pass in time."""
        tests = tests_of(path)
        for each in tests:
            if each not in self._seconds:
                self._seconds[each] = self._tried(each)
        seconds = {each: self._seconds[each] for each in tests}
        return seconds if all(seconds.values()) else {}

    def _tried(self, tests: str) -> float:
        start = time.monotonic()
        failure = failure_of(tests, self._checkout, self._limit)
        if failure:
            print(f"{tests}: of the package as it is they {failure}", flush=True)
        return 0.0 if failure else time.monotonic() - start


def is_stopped(checkout: Path, mutant: Mutant, tests: dict[str, float]) -> bool:
    """Whether tests fail, or take far longer than the seconds that they do; the file is as it was afterwards."""
    path = checkout / "sss_ref" / mutant.path
    original = path.read_text(encoding="utf-8")
    path.write_text(mutant.source, encoding="utf-8")
    try:
        return any(failure_of(each, checkout, 30 + 4 * seconds) for each, seconds in tests.items())
    finally:
        path.write_text(original, encoding="utf-8")


def failure_of(tests: str, checkout: Path, limit: float) -> str:
    """How tests fail, "" if they pass: by which of them, or by taking longer than so many seconds."""
    environment = {**os.environ, "PYTHONPATH": str(checkout), "SSS_REF_CACHE_DIR": str(checkout.parent / "cache")}
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-n", "0", tests]
    try:
        done = subprocess.run(
            command, cwd=checkout, env=environment, capture_output=True, text=True, timeout=limit, check=False
        )
    except subprocess.TimeoutExpired:
        return f"take over {limit:.0f} s"
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return "" if done.returncode == 0 else ": ".join(["fail", *failed[:1]])


if __name__ == "__main__":
    main()
