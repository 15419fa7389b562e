"""How many correct devices `validate` fails: random scenes, drawn as a profile allows, dumped in part.

    python benchmarks/correct_devices.py [--count N] [--first SEED]

Each seed chooses a scene (method, preset, body, lights, sizes of 16 to 64), a device (subpixel bits, snap, first
vertex, guard band, exact vertices, a processor that rounds as it likes within Vulkan's bounds, textures of half floats
or bytes rounded either way) and a subset of the buffers. No report may fail. Every one that does is named.
"""

import argparse
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

from right_devices import trial


def main() -> None:
    """Print every failure and the count."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    given = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(given.first, given.first + given.count):
            told, report = trial(Path(folder), seed)
            if report.culprit:
                failed += 1
                print(f"{seed}: {told}\n    {report.summary}", flush=True)
    print(f"{failed} of {given.count} correct devices failed")


if __name__ == "__main__":
    main()
