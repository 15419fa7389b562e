"""Does a test fail for every mistake in the sources? One place changed at a time, and the tests that execute it run.

    python benchmarks/executing_tests.py FOLDER tests/view tests/numerics ...   # which these are: recorded once
    python benchmarks/mutation.py FOLDER --count 200 --seed 1                   # a sample of the whole package
    python benchmarks/mutation.py FOLDER view/light_fit.py numerics             # of some files and rooms

A place is an operator, a comparison, a number, a truth value, a `not`, outside types, decorators and the `strict` of
zip. Each is changed in a copy of the package; then those of the recorded tests run that execute its line, and those of
the file that mirrors the source, for nobody sees what is compiled execute: two of each function first, and sixteen of
one in its room, of that file and room before the others, the quickest first, as many as take `--limit` seconds. Where
none that short is seen to execute it, it is the tests of that file, then its room's, then others that execute the file.
A test counts that passes with the package as it is. Printed are the survivors, but for those that
equivalent_mutants.toml says nobody can tell from the original, then the score of each room and of all: the share of the
other mutants that make a test fail, or tests take four times as long and a minute.
"""

import argparse
import itertools
import math
import multiprocessing
import os
import queue
import random
import resource
import shutil
import sys
import tempfile
import time
import tomllib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from changed_sources import Mutant, mutants, sources
from executing_tests import Recorded

HERE = Path(__file__).resolve().parents[1]
EQUIVALENT = Path(__file__).with_name("equivalent_mutants.toml")
SLOW = 10  # seconds beyond which a test is not run
FEW = 12  # tests that run first
SIMILAR, OF_ITS_ROOM = 2, 16  # as many tests of a function run before the others of it; of one of the mutant's room
PRINTED = "printed.txt"  # what tests print, in their checkout
SERVER = multiprocessing.get_context("forkserver")
SERVER.set_forkserver_preload(
    ["__main__", "numpy", "numba", "trimesh", "pydantic", "mpmath", "imageio", "hypothesis", "zarr", "pytest"]
)


def main() -> None:
    """Run a sample and print what survives."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("recorded", type=Path, help="folder that executing_tests.py has filled")
    parser.add_argument(
        "places", nargs="*", type=Path, help="files and rooms, relative to sss_ref; all of it by default"
    )
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=float, default=20, help="seconds of tests for a mutant, as they were recorded")
    parser.add_argument("--minutes", type=float, default=math.inf, help="begin no mutant after so many")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at a time")
    asked = parser.parse_args()
    every = [mutant for path in sources(asked.places) for mutant in mutants(path)]
    sample = random.Random(asked.seed).sample(every, min(asked.count, len(every)))
    equivalent = {(each["path"], each["changed"]) for each in tomllib.loads(EQUIVALENT.read_text())["mutant"]}
    told_apart = [mutant for mutant in sample if (str(mutant.path), mutant.changed_line) not in equivalent]
    recorded = Recorded(asked.recorded)
    with tempfile.TemporaryDirectory() as folder:
        checkouts = [copied(Path(folder) / str(job)) for job in range(asked.jobs)]
        recorded.keep(collected(checkouts[0]))
        tests = {mutant: chosen(mutant, recorded, asked.limit) for mutant in told_apart}
        stopped = tried(tests, checkouts, time.monotonic() + 60 * asked.minutes)
    for room, count in sorted(Counter(mutant.room for mutant in stopped).items()):
        print(f"{room}: {sum(hit for mutant, hit in stopped.items() if mutant.room == room)} of {count}")
    hits = sum(stopped.values())
    low, high = interval(hits, max(len(stopped), 1))
    share = f"{hits / max(len(stopped), 1):.0%} (of all {len(every)} places {low:.0%} to {high:.0%} with 95 %)"
    print(f"{hits} of {len(stopped)} stopped, {share}, seed {asked.seed}; {len(sample) - len(tests)} equivalent")


def tried(tests: dict[Mutant, dict[str, float]], checkouts: list[Path], end: float) -> dict[Mutant, bool]:
    """Whether each mutant is stopped by its tests; survivors are printed at once.

    checkouts: copies to change, as many as mutants are tried at a time. end: on the clock, after which none is begun.
    """
    free: queue.Queue[Trial] = queue.Queue()
    for checkout in checkouts:
        free.put(Trial(checkout))

    def stop(mutant: Mutant) -> bool | None:
        trial = free.get()
        if time.monotonic() > end:
            free.put(trial)
            return None
        hit = trial.stops(mutant, tests[mutant])
        free.put(trial)
        if not hit:
            print(f"survived {len(tests[mutant])} tests: {mutant}", flush=True)
        return hit

    with ThreadPoolExecutor(len(checkouts)) as pool:
        found = zip(tests, pool.map(stop, tests), strict=True)
        return {mutant: hit for mutant, hit in found if hit is not None}


def chosen(mutant: Mutant, recorded: Recorded, limit: float) -> dict[str, float]:
    """The tests that a mutant has to pass, in order -> the seconds that each takes."""
    mirrored = f"tests/{mutant.path.with_name(f'test_{mutant.path.name}')}::"
    own = {test for test in recorded.seconds if test.startswith(mirrored)}
    executing = recorded.executing(mutant.path, mutant.executed)
    among = [executing | own]
    if not any(recorded.seconds[test] < min(SLOW, limit) for test in executing):
        room = {test for test in recorded.seconds if test.startswith(f"tests/{mutant.room}/")}
        among = [own, room, recorded.executing_file(mutant.path)]
    tests: dict[str, float] = {}
    for each in among:
        functions: Counter[str] = Counter()
        ranked = {}
        for test in sorted(each, key=recorded.seconds.__getitem__):
            function, seconds = test.partition("[")[0], recorded.seconds[test]
            is_near = test.startswith(f"tests/{mutant.room}/")
            place = functions[function] // (OF_ITS_ROOM if is_near else SIMILAR)
            ranked[test] = place, not test.startswith(mirrored), not is_near, seconds
            functions[function] += 1
        for test in sorted(each, key=lambda test: (ranked[test], test)):
            if recorded.seconds[test] < min(SLOW, limit - sum(tests.values())):
                tests.setdefault(test, recorded.seconds[test])
    return tests


def interval(hits: int, tries: int) -> tuple[float, float]:
    """Where the share in the whole lies with 95 %, by a sample of it (Wilson 1927)."""
    deviations = 1.959964  # of the normal distribution
    share, spread = hits / tries, deviations**2 / tries
    middle = (share + spread / 2) / (1 + spread)
    half = deviations * math.sqrt(share * (1 - share) / tries + spread / (4 * tries)) / (1 + spread)
    return middle - half, middle + half


def copied(folder: Path) -> Path:
    """Copy the checkout, as far as tests read it."""
    skipped = shutil.ignore_patterns(".git", ".*_cache", "_build", "shared")
    return Path(shutil.copytree(HERE, folder / "checkout", ignore=skipped, symlinks=True))


def collected(checkout: Path) -> set[str]:
    """The tests that are there: one that is not would fail for every mutant."""
    run(checkout, ["--collect-only", "-v", "-m", ""], 600)
    return set((checkout / PRINTED).read_text(encoding="utf-8").splitlines())


class Trial:
    """A copy of the checkout in which one mutant is tried after the other."""

    def __init__(self, checkout: Path) -> None:
        """checkout: the copy."""
        self._checkout = checkout
        self._times = itertools.count(1)
        self._sound: dict[str, bool] = {}  # tests -> whether they pass here, with the package as it is

    def stops(self, mutant: Mutant, seconds: dict[str, float]) -> bool:
        """Whether tests that pass otherwise fail, or take far longer than the seconds that they do.

        A few are run first, for it takes seconds to collect tests of many files.
        """
        tests = list(seconds.items())
        return self._stops(mutant, dict(tests[:FEW])) or self._stops(mutant, dict(tests[FEW:]))

    def _stops(self, mutant: Mutant, left: dict[str, float]) -> bool:
        while left:
            failed = self._failed(mutant, left)
            if failed not in left:  # none, or all of them: they cannot be read, or take too long
                return failed is not None
            if failed not in self._sound:
                self._sound[failed] = run(self._checkout, [failed], 600) == 0
            if self._sound[failed]:
                return True
            del left[failed]
        return False

    def _failed(self, mutant: Mutant, seconds: dict[str, float]) -> str | None:
        """The first test that fails of a mutant, "" if all of them do; the file is as it was afterwards."""
        self._write(mutant.path, mutant.source)
        try:
            code = run(self._checkout, ["-x", *seconds], round(60 + 4 * sum(seconds.values())))
        finally:
            self._write(mutant.path, mutant.text)
        printed = (self._checkout / PRINTED).read_text(encoding="utf-8").splitlines()
        said = [line.partition(" ")[2] for line in printed if line.startswith(("FAILED ", "ERROR "))]
        return (
            None
            if code == 0
            else next((test for test in seconds for line in said if f"{line} ".startswith(f"{test} ")), "")
        )

    def _write(self, path: Path, source: str) -> None:
        """Change a file, with a time that no bytecode of it was made at."""
        changed = self._checkout / "sss_ref" / path
        changed.write_text(source, encoding="utf-8")
        time = next(self._times)
        os.utime(changed, (time, time))


def run(checkout: Path, words: list[str], limit: int) -> int | None:
    """Run tests in a checkout, for so many seconds of processor time; 0: they pass.

    They have eight times as long on the clock. It is a fork of a process that has imported what takes long, and nothing
    of the package.
    """
    process = SERVER.Process(target=run_here, args=(checkout, words, limit))
    process.start()
    process.join(8 * limit)
    process.kill()
    process.join()
    return process.exitcode


def run_here(checkout: Path, words: list[str], limit: int) -> None:
    """Run tests in this process and leave it; what they print is in the checkout."""
    resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    os.chdir(checkout)
    printed = os.open(PRINTED, os.O_CREAT | os.O_TRUNC | os.O_WRONLY)
    os.dup2(printed, 1)
    os.dup2(printed, 2)
    cached = str(checkout.parent.parent / "cache")
    os.environ |= {"PYTHONPATH": str(checkout), "SSS_REF_CACHE_DIR": cached}
    sys.path.insert(0, str(checkout))
    sys.dont_write_bytecode, sys.pycache_prefix = False, None  # of the copy, for the next mutant
    sys.argv = ["pytest"]
    os._exit(pytest.main(["-q", "-n", "0", "-p", "no:cacheprovider", *words]))


if __name__ == "__main__":
    main()
