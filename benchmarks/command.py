"""Times `sss-ref render`, warm, from the process's start to its end: python benchmarks/command.py --against OLD.

With another checkout of the project, OLD, both take turns. Prints medians of the wall time, of the processors' time and
of the bytes that each writes, and the ratio. What follows `--` goes to the command: `-- --keep final`.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Run:
    """One process: seconds that passed, seconds of all processors in the program and in the system, bytes written."""

    wall: float
    program: float
    system: float
    written: int


def run(checkout: Path, cache: str, words: list[str]) -> Run:
    """Run the command of a checkout. Raises CalledProcessError where it fails."""
    environment = {**os.environ, "PYTHONPATH": str(checkout), "SSS_REF_CACHE_DIR": cache}
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "sss_ref.cli", "render", "-o", f"{folder}/out", *words]
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run(command, env=environment, cwd=folder, capture_output=True, check=True)
        wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        written = sum(path.stat().st_size for path in Path(folder).rglob("*") if path.is_file())
    return Run(wall, after.ru_utime - before.ru_utime, after.ru_stime - before.ru_stime, written)


def medians(runs: list[Run]) -> Run:
    """Of each number the median."""
    return Run(*(statistics.median(getattr(each, name) for each in runs) for name in Run.__dataclass_fields__))


def main() -> None:
    """One run of each to compile, then `--runs` in turns."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", type=Path, help="another checkout")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("words", nargs="*", help="for the command, after --")
    asked = parser.parse_args()
    sides = {"here": HERE} | ({"there": asked.against.resolve()} if asked.against else {})
    with tempfile.TemporaryDirectory() as cache:
        for name, checkout in sides.items():
            run(checkout, f"{cache}/{name}", asked.words)
        turns = [
            {name: run(checkout, f"{cache}/{name}", asked.words) for name, checkout in sides.items()}
            for _ in range(asked.runs)
        ]
    found = {name: medians([turn[name] for turn in turns]) for name in sides}
    print(f"medians of {asked.runs} runs, in turns; seconds")
    for name, each in found.items():
        print(
            f"  {name:6s} wall {each.wall:5.2f}   processors {each.program:5.2f} + system {each.system:5.2f}   ", end=""
        )
        print(f"{each.written / 1e6:.0f} MB")
    if asked.against:
        here, there = found["here"], found["there"]
        busy = (here.program + here.system) / (there.program + there.system)
        print(f"  here / there: wall {here.wall / there.wall:.2f}, processors {busy:.2f}")


if __name__ == "__main__":
    main()
