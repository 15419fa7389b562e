"""Times `sss-ref render`, warm, from the process's start to its end: python benchmarks/command.py --against OLD.

With another checkout of the project, OLD, both take turns. Prints medians of the wall time, of the processors' time and
of the bytes that each writes, and the ratio. What follows `--` goes to the command: `-- --keep final`.
"""

import argparse
import os
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
    """One process: seconds that passed, seconds of all processors in the program and in the system, bytes written.

    memory: the bytes that it had at most.
    """

    wall: float
    program: float
    system: float
    written: int
    memory: int


def run(checkout: Path, cache: str, words: list[str]) -> Run:
    """Run the command of a checkout. Raises CalledProcessError where it fails."""
    environment = {**os.environ, "PYTHONPATH": str(checkout), "SSS_REF_CACHE_DIR": cache}
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "sss_ref.cli", "render", "-o", f"{folder}/out", *words]
        start = time.perf_counter()
        with subprocess.Popen(
            command, env=environment, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        ) as process:
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        wall = time.perf_counter() - start
        if process.returncode:
            raise subprocess.CalledProcessError(process.returncode, command)
        written = sum(path.stat().st_size for path in Path(folder).rglob("*") if path.is_file())
    return Run(wall, used.ru_utime, used.ru_stime, written, 1024 * used.ru_maxrss)


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
