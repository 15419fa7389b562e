"""Times first runs of `sss-ref render`, for which nothing is compiled: python benchmarks/first_run.py --against OLD.

The default scene, here and in another checkout of the project, OLD, cold and then warm; the same with more lights, the
image alone; then a second scene with other options, and what of it was compiled that the first had not. Processor time
is that of the program and the system together; memory is the most that the process had.
"""

import argparse
import tempfile
from collections.abc import Iterable
from pathlib import Path

from command import HERE, Run, run

SECOND = ["default", "--method", "texture_space", "--preset", "paper"]
LIGHT = """
[[lights]]
position = [{x:.3f}, 1.1, {z:.3f}]
color = [1.0, 0.9, 0.8]
intensity = 0.1
"""


def main() -> None:
    """All three."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", type=Path, help="another checkout")
    parser.add_argument("--lights", type=int, nargs="*", default=[4, 8, 16])
    asked = parser.parse_args()
    busy = {name: default_scene(name, checkout) for name, checkout in checkouts(asked.against).items()}
    if asked.against:
        print(f"  here / there: processors {busy['here'] / busy['there']:.2f}")
    with tempfile.TemporaryDirectory() as folder:
        for count in asked.lights:
            scene = with_lights(Path(folder), count)
            cold, warm = cold_and_warm(HERE, [str(scene), "--keep", "final"])
            print(f"{count} lights\n{line('cold', cold)}\n{line('warm', warm)}")
    second_scene()


def checkouts(against: Path | None) -> dict[str, Path]:
    """Name -> checkout."""
    return {"here": HERE} | ({"there": against.resolve()} if against else {})


def default_scene(name: str, checkout: Path) -> float:
    """Print what the default scene takes in a checkout; the processor time of the first run, in seconds."""
    cold, warm = cold_and_warm(checkout, [])
    print(f"the default scene, {name}\n{line('cold', cold)}\n{line('warm', warm)}", flush=True)
    return cold.program + cold.system


def cold_and_warm(checkout: Path, words: list[str]) -> tuple[Run, Run]:
    """The first run and the second."""
    with tempfile.TemporaryDirectory() as cache:
        return run(checkout, cache, words), run(checkout, cache, words)


def line(name: str, each: Run) -> str:
    """A run as it is printed."""
    busy = each.program + each.system
    return f"  {name}  wall {each.wall:6.2f} s   processors {busy:6.2f} s   memory {each.memory / 1e9:.2f} GB"


def with_lights(folder: Path, count: int) -> Path:
    """The default scene with so many lights, those that it has not behind one another beside the head."""
    own = (HERE / "data" / "scenes" / "default.toml").read_text(encoding="utf-8")
    added = [LIGHT.format(x=2.5 - 0.1 * k, z=2.5 + 0.1 * k) for k in range(count - own.count("[[lights]]"))]
    path = folder / f"{count}.toml"
    path.write_text(own + "".join(added), encoding="utf-8")
    return path


def second_scene() -> None:
    """Print what a second scene compiles after the default one."""
    with tempfile.TemporaryDirectory() as cache:
        run(HERE, cache, [])
        before = compiled(cache)
        first = run(HERE, cache, SECOND)
        after, again = compiled(cache), run(HERE, cache, SECOND)
    print(f"after the default scene, which keeps {len(before)} files: {' '.join(SECOND)}")
    print(f"{line('cold', first)}\n{line('warm', again)}\n  compiled: {listed(after - before)}")


def compiled(cache: str) -> set[str]:
    """The names of what is kept in a cache."""
    return {path.name for suffix in ("kernel", "code") for path in Path(cache).rglob(f"*.{suffix}")}


def listed(files: Iterable[str]) -> str:
    """What the files are of."""
    return ", ".join(sorted(name.rpartition("-")[0] for name in files))


if __name__ == "__main__":
    main()
