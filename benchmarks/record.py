"""Runs a benchmark and keeps what it prints, with the machine it ran on: benchmarks/results/NAME.txt.

    python benchmarks/record.py detection.py --size 256
    python benchmarks/record.py --name render_robust --note "shared machine" render.py --preset robust
    python benchmarks/record.py --speed --against ../older      # all records of speed, of this commit

NAME is the benchmark's unless given. A record is one command line, one line about the machine, a note if there is one,
an empty line, and the output. Commit first: the line about the machine names the commit.
"""

import argparse
import datetime
import os
import platform
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

FOLDER = Path(__file__).parent
SPEED = {  # name of the record -> its command
    "opengl_1024": ("opengl.py", "--runs", "5", "--threads", "2", "1"),
    "opengl_2048": ("opengl.py", "--size", "2048", "--triangles", "500000", "--runs", "3", "--threads", "2", "1"),
    "linearity": ("linearity.py",),
    "render": ("render.py", "--size", "512", "--triangles", "20000"),
    "render_robust": ("render.py", "--size", "512", "--triangles", "20000", "--preset", "robust"),
}
RESULTS = FOLDER / "results"


def main() -> None:
    """Run, show and keep, one benchmark or all of speed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--name", help="of the record")
    parser.add_argument("--note", default="", help="what a reader of the numbers should know")
    parser.add_argument("--speed", action="store_true", help="make all records of speed")
    parser.add_argument("--against", default="", help="with --speed: another checkout, for the time of the command")
    parser.add_argument("benchmark", nargs="?", default="", help="a file of this folder")
    parser.add_argument("arguments", nargs=argparse.REMAINDER, help="for the benchmark")
    given = parser.parse_args()
    if given.speed:
        command = {"command": ("command.py", "--against", given.against, "--runs", "3")} if given.against else {}
        started = machine()  # one commit, before the first record changes a file
        for name, words in (SPEED | command).items():
            keep(name, [*words], given.note, started)
    else:
        name = given.name or Path(given.benchmark).stem
        keep(name, [given.benchmark, *given.arguments], given.note, machine())


def keep(name: str, words: list[str], note: str, machine: str) -> None:
    """Run one benchmark, show what it prints and keep it under a name."""
    head = [f"$ python benchmarks/{' '.join(words)}", machine, *filter(None, [note])]
    print("\n".join(head), end="\n\n", flush=True)
    printed = output([sys.executable, str(FOLDER / words[0]), *words[1:]])
    RESULTS.mkdir(exist_ok=True)
    (RESULTS / f"{name}.txt").write_text("\n".join(head) + "\n\n" + printed, encoding="utf-8")


def output(command: list[str]) -> str:
    """What a command prints, shown while it runs; raises CalledProcessError where it fails."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        lines = []
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line)
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command)
    return "".join(lines)


def machine() -> str:
    """Processor, cores, memory, system, versions, date and commit in one line."""
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "numba"))
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return (
        f"{processor()}, {os.cpu_count()} cores, {memory:.0f} GiB, {platform.system()} {platform.machine()}, "
        f"Python {platform.python_version()}, {packages}, {datetime.date.today().isoformat()}, commit {commit()}"
    )


def processor() -> str:
    """The processor's name, as far as the system tells it."""
    told = Path("/proc/cpuinfo")
    lines = told.read_text().splitlines() if told.exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return (names or [platform.processor() or platform.machine()])[0]


def commit() -> str:
    """The commit that is checked out; "+ changes" where the files differ from it."""

    def git(*words: str) -> str:
        return subprocess.run(["git", *words], cwd=FOLDER, capture_output=True, text=True, check=True).stdout.strip()

    return git("rev-parse", "--short=12", "HEAD") + (" + changes" if git("status", "--porcelain", "-uno") else "")


if __name__ == "__main__":
    main()
