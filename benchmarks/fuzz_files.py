"""Whether files of every kind that is read may hold anything: python benchmarks/fuzz_files.py --count 20000.

    python benchmarks/fuzz_files.py [--count N] [--first SEED]

Each seed takes a valid scene, mesh, dump, mapping, profile, manifest, sweep or bundle and changes a few places of one
of its files, or of it something that must not matter. It must be read, with finite numbers, or refused in lines of
ours, in at most 5 s of processor time and 2 GiB; after a harmless change what is read must be the same. Every seed of
which that is not so is named.
"""

import argparse
import collections
import resource
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

from fuzzing import trials


def main() -> None:
    """Print every fault and a table of counts; exit 1 if there is a fault."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    asked = parser.parse_args()
    seen: collections.Counter[tuple[str, str]] = collections.Counter()
    faults = 0
    for trial in trials(range(asked.first, asked.first + asked.count)):
        seen[trial.kind, trial.came] += 1
        if trial.fault:
            faults += 1
            print(f"{trial.seed}: {trial.kind}: {trial.how}: {trial.fault[-2000:]}", flush=True)
    print(f"{'':10} {'read':>7} {'refused':>7} {'same':>7}")
    for kind in sorted({kind for kind, _ in seen}):
        print(f"{kind:10} " + " ".join(f"{seen[kind, came]:7}" for came in ("read", "refused", "same")))
    print(f"{asked.count} files in {seconds():.0f} s of processor time, {faults} faults")
    sys.exit(bool(faults))


def seconds() -> float:
    """Processor time of the processes that read."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


if __name__ == "__main__":
    main()
