"""How long `sss-ref validate` takes from process start to end: a right dump, a wrong blur, a large one.

    python benchmarks/validate.py --size 256 --large 1024 --runs 3
    python benchmarks/validate.py --other ../before      # in turns with another checkout; prints this one's share of it

Each run is a process of its own; the kernels are compiled before. Told are the least seconds of processor time, user
and system, and of wall time of all runs: on a shared machine the first is the one to compare. The dumps are a
checkout's own buffers, for its rules may be others, of the scene itself or of one whose taps are 1 % too far out.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).parents[1]
SCENE = "figure3_with"
SCALE, TOO_FAR = {"blur.pixel_scale": 2.0}, {"blur.pixel_scale": 2.02}  # in pixels, which every checkout has
Seconds = tuple[float, float]  # processor, wall


def main() -> None:
    """Time every case in turns."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=256, help="of camera and shadow map, of the right and wrong dumps")
    parser.add_argument(
        "--large", type=int, default=0, help="of the camera of a large right dump; its map is twice that"
    )
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--other", type=Path, help="another checkout of the project")
    parser.add_argument("options", nargs="*", help="for this checkout's validate, after --, such as --quick")
    given = parser.parse_args()
    cases = {"right": (given.size, given.size, {}), "wrong blur": (given.size, given.size, TOO_FAR)}
    if given.large:
        cases["large, right"] = given.large, 2 * given.large, {}
    checkouts = [HERE, *([given.other.resolve()] if given.other else [])]
    print(f"{'case':<14}{'processor':>12}{'wall':>10}   {'share of the other' if given.other else ''}")
    for name, (camera, shadow_map, changes) in cases.items():
        with tempfile.TemporaryDirectory() as folder:
            size, commands = sizes(camera, shadow_map), {}
            for number, checkout in enumerate(checkouts):
                there = Path(folder, str(number))
                dump(checkout, there, size | changes)
                options = given.options if checkout == HERE else []
                commands[checkout] = [*arguments(there, size), *options]
            print(line(name, in_turns(commands, given.runs)), flush=True)


def sizes(camera: int, shadow_map: int) -> dict[str, float]:
    """The overrides of the scene for a camera and a shadow map of these sides."""
    named = {"camera": camera, "shadow_map": shadow_map}
    return SCALE | {f"{table}.{side}": size for table, size in named.items() for side in ("width", "height")}


DUMP = """
import json, pathlib, sys, numpy, sss_ref
scene, folder, overrides = sys.argv[1], pathlib.Path(sys.argv[2]), json.loads(sys.argv[3])
folder.mkdir()
for name, buffer in sss_ref.render(sss_ref.load_scene(scene, **overrides)).buffers.items():
    if name != "uv":  # of no use here
        numpy.save(folder / f"{name}.npy", buffer)
"""


def dump(checkout: Path, folder: Path, overrides: dict[str, float]) -> None:
    """Have a checkout write all buffers of the scene but one."""
    environment = os.environ | {"PYTHONPATH": str(checkout)}
    command = [sys.executable, "-c", DUMP, SCENE, str(folder), json.dumps(overrides)]
    subprocess.run(command, env=environment, cwd=checkout, check=True)


def arguments(folder: Path, overrides: dict[str, float]) -> list[str]:
    """What the command line is given."""
    return [
        "validate",
        SCENE,
        str(folder),
        *(part for each in overrides.items() for part in ("--set", "{}={}".format(*each))),
    ]


def in_turns(commands: dict[Path, list[str]], runs: int) -> list[Seconds]:
    """The least seconds of each checkout; the first turn compiles and is not counted."""
    turns = [[timed(checkout, command) for checkout, command in commands.items()] for _ in range(runs + 1)]
    return [(min(p for p, _ in own), min(w for _, w in own)) for own in zip(*turns[1:], strict=True)]


def timed(checkout: Path, command: list[str]) -> Seconds:
    """The processor and wall time of the command line of a checkout."""
    environment = os.environ | {"PYTHONPATH": str(checkout)}
    before, start = os.times(), time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-m", "sss_ref.cli", *command], env=environment, cwd=checkout, capture_output=True, text=True
    )
    wall, after = time.perf_counter() - start, os.times()
    if done.returncode not in (0, 1):
        raise SystemExit(done.stdout + done.stderr)
    spent = after.children_user + after.children_system - before.children_user - before.children_system
    return spent, wall


def line(name: str, seconds: list[Seconds]) -> str:
    """A row of the table."""
    (processor, wall), *others = seconds
    shares = [
        f"{processor / other:.0%} of the processor time, {wall / there:.0%} of the wall" for other, there in others
    ]
    return f"{name:<14}{processor:>10.2f} s{wall:>8.2f} s   {''.join(shares)}"


if __name__ == "__main__":
    main()
