"""Whether everything holds of scenes that nobody chose: python benchmarks/random_scenes.py --count 500.

    python benchmarks/random_scenes.py [--count N] [--first SEED] [--gl]

Each seed chooses a mesh, one to four lights, a camera, sizes from 1x1 to 97x61, and a value of any setting whose values
have names. A scene that is refused, in whole lines, gives way to the next. Of one that is not, the arrays must have the
bits of the compiled kernels, and its own buffers must pass in every profile; with --gl, what OpenGL draws too. Every
seed of which something does not hold is named.
"""

import argparse
import collections
import sys
import tempfile
import time
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

from scenes_by_chance import trial


def main() -> None:
    """Print every fault and the counts; exit 1 if there is a fault."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--gl", action="store_true", help="draw each with OpenGL too")
    asked = parser.parse_args()
    seen: collections.Counter[str] = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(asked.first, asked.first + asked.count):
            seen.update(tried(Path(folder), seed, asked.gl))
    print(
        f"{asked.count} scenes, {seen['blank']} of them blank, {seen['refused']} others refused, in {seconds():.0f} s"
    )
    print(", ".join(f"{seen[key]} {key}" for key in sorted(set(seen) - {"blank", "refused", "faults"})))
    print(f"{seen['faults']} faults")
    sys.exit(bool(seen["faults"]))


def tried(folder: Path, seed: int, opengl: bool) -> dict[str, int]:
    """What there is to count of a seed; its faults are printed."""
    try:
        outcome = trial(folder, seed, opengl)
    except Exception:  # whatever it is, the next seeds are tried too
        print(f"{seed}: {traceback.format_exc()}", flush=True)
        return {"faults": 1}
    for fault in outcome.faults:
        print(f"{seed}: {fault}\n    {outcome.tables}", flush=True)
    counts = {"blank": int(outcome.blank), "refused": outcome.refused, "faults": len(outcome.faults)}
    counts |= {"with more textures than this OpenGL takes": 1} if outcome.beyond else {}
    return counts | {outcome.tables["method"]: 1, outcome.tables["preset"]: 1}


def seconds() -> float:
    """Processor time of all threads so far."""
    return time.process_time()


if __name__ == "__main__":
    main()
