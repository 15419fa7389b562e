"""Does `blame` name the right one? Planted faults of every class, and right pictures, which are nobody's fault.

    python benchmarks/blame.py
    python benchmarks/blame.py --elsewhere    # the dump comes from a machine that is not here

Faults of the source: a mutant of a stage in the user's files, drawn with them. Of a compiler: the files are right, and
what draws them makes such a mutant of them, or edits the SPIR-V that glslang compiles before it is translated back.
Of settings: OpenGL with a state left on, and ports that draw or store otherwise (tests/support/planted.py). Of inputs:
ports with other numbers, matrices and bindings, other meshes, and other scene files. Nobody's: the shaders of ours,
drawn by right processors of many kinds. What draws the very bits of a right picture is no fault, and only counted.
"""

import argparse
import os
import re
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from itertools import repeat
from multiprocessing import get_context
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

from stack_faults import SAME_BITS, Case, groups  # beside the tests that use them

from sss_ref.blame.blaming import COMPILER, INPUT, NOBODY, SETTING, SHADER, Blame, Suspicion
from sss_ref.blame.stacks import GLSL, stacks_here
from sss_ref.gl.shaders import shader_folder
from sss_ref.interpret.shader import array_lengths, shader_files

CLASSES = (SHADER, COMPILER, SETTING, INPUT, NOBODY)


def main() -> None:
    """Print what was said of each, and how often it was right."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=32)
    parser.add_argument("--mutants", type=int, default=14, help="of the source, of each scene")
    parser.add_argument("--edits", type=int, default=8, help="of SPIR-V, of each scene")
    parser.add_argument("--right", type=int, default=50, help="pictures that are nobody's fault")
    parser.add_argument("--only", default="", help="faults whose lines have this regular expression in them")
    parser.add_argument("--seconds", type=float, default=20.0, help="for the explanations of each")
    parser.add_argument("--elsewhere", action="store_true", help="the stack that drew is not among those here")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="groups of faults at a time")
    options = parser.parse_args()
    counts: Counter[tuple[str, str]] = Counter()
    same: Counter[str] = Counter()
    seconds = 0.0
    with ProcessPoolExecutor(options.jobs, max_tasks_per_child=1, mp_context=get_context("spawn")) as pool:
        for found in pool.map(tried, range(len(all_groups(options))), repeat(options)):
            counts, same, seconds = counts + found.counts, same + found.same, seconds + found.seconds
    summarise(counts, same)
    print(f"{seconds:.0f} s of processor time")


@dataclass(frozen=True)
class Found:
    """What was said of a group: (right class, class said) -> how often, and what was no fault."""

    counts: Counter[tuple[str, str]]
    same: Counter[str]
    seconds: float


def all_groups(options: argparse.Namespace) -> list[Iterator[Case]]:
    """The groups of the cases."""
    return groups(options.size, options.mutants, options.edits, options.right)


def tried(number: int, options: argparse.Namespace) -> Found:
    """One group, a line for each case as soon as it is told."""
    counts: Counter[tuple[str, str]] = Counter()
    for case in all_groups(options)[number]:
        if re.search(options.only, f"{case.whose}: {case.name}"):
            said = blamed(case, options.seconds, options.elsewhere)
            counts[case.whose, said.whose] += 1
            print(line(case, said), flush=True)
    return Found(counts, SAME_BITS, time.process_time())


def line(case: Case, said: Blame) -> str:
    """A line; of what is wrong a second one, with all that it is said for."""
    if said.whose == case.whose:
        return f"{case.whose}: {case.name}"
    return f"WRONG {case.whose}: {case.name}: {said.whose}\n    {'; '.join(said.because)}"


def summarise(counts: Counter[tuple[str, str]], same: Counter[str]) -> None:
    """How many of each class are told, and of all faults."""
    print()
    for whose in CLASSES:
        print(f"{whose}: {counts[whose, whose]} of {sum(n for (right, _), n in counts.items() if right == whose)}")
    faults = {pair: count for pair, count in counts.items() if pair[0] != NOBODY}
    right = sum(count for (a, b), count in faults.items() if a == b)
    print(f"{right} of {sum(faults.values())} faults in the right class, {right / max(sum(faults.values()), 1):.1%}")
    print(f"{same.total()} more draw the bits of a right picture: {dict(same)}")


def blamed(case: Case, seconds: float, elsewhere: bool) -> Blame:
    """What `blame` says of a case, with the files of its source."""
    stacks = [*stacks_here(GLSL), *([case.device] if case.device and not elsewhere else [])]
    device = None if elsewhere else (case.device or stacks[0]).name
    drawing = replace(case.drawing, device=device)
    with tempfile.TemporaryDirectory() as folder:
        files = shader_files(case.source.method, array_lengths(case.source.uniforms), registers=True)
        for name, text in files.items():
            (Path(folder) / name).write_text(text)
        shaders = shader_folder(Path(folder), case.scene.settings)
        return Suspicion(case.scene, drawing, shaders, stacks, case.profile, seconds).blame()


if __name__ == "__main__":
    main()
