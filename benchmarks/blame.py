"""Does `blame` name the right one? Planted faults of every class, and right pictures, which are nobody's fault.

    python benchmarks/blame.py --size 48 --every 8

Faults of the source: a mutant of a stage in the user's files, drawn with them. Of a compiler: the same kind of mutants
drawn, while the files are right, as they would be had a compiler made one of the other. Of settings and inputs: ports
that draw otherwise or with other numbers (tests/support/planted.py), and meshes with vertices elsewhere. Nobody's: the
shaders of ours written otherwise, drawn by right processors of many kinds.
"""

import argparse
import re
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

from planted import PLANTED, scene_of  # the tables are beside the tests that use them
from planted_newer import NEWER
from right_devices import drawn_by_chance

from sss_ref.blame.blaming import COMPILER, INPUT, NOBODY, SETTING, SHADER, Suspicion
from sss_ref.blame.stacks import GLSL, stacks_here
from sss_ref.gl.drawing import draw
from sss_ref.gl.shaders import shader_folder
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.language.pipeline import REGISTERS
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.mutants import mutants
from sss_ref.validation.witness.situation import unbound

KEPT = ("all", REGISTERS)
SCENES = ("bust", "texture space")


@dataclass(frozen=True)
class Case:
    """A picture, what it was drawn with, and whose fault it is."""

    name: str
    whose: str
    scene: Scene
    drawing: Drawing
    source: Scene  # whose shaders the user has
    profile: Profile | str = "vulkan"


def main() -> None:
    """Print what was said of each, and how often it was right."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=48)
    parser.add_argument("--every", type=int, default=8, help="every n-th mutant")
    parser.add_argument("--right", type=int, default=50, help="pictures that are nobody's fault")
    parser.add_argument("--only", default="", help="faults whose names have this regular expression in them")
    parser.add_argument("--seconds", type=float, default=5.0, help="for the explanations of each")
    options = parser.parse_args()
    counts: Counter[tuple[str, str]] = Counter()
    for case in cases(options.size, options.every, options.right):
        if not re.search(options.only, case.name):
            continue
        start = time.perf_counter()
        said = blamed(case, options.seconds)
        counts[case.whose, said.whose] += 1
        mark = "" if said.whose == case.whose else "WRONG "
        print(f"{mark}{case.whose}: {case.name}: {said.whose}, {time.perf_counter() - start:.1f} s", flush=True)
        if mark:
            print(f"    {'; '.join(said.because)}")
    for whose in (SHADER, COMPILER, SETTING, INPUT, NOBODY):
        total = sum(count for (right, _), count in counts.items() if right == whose)
        print(f"{whose}: {counts[whose, whose]} of {total}")
    faults = {pair: count for pair, count in counts.items() if pair[0] != NOBODY}
    right = sum(count for (a, b), count in faults.items() if a == b)
    print(f"{right} of {sum(faults.values())} faults in the right class")


def blamed(case: Case, seconds: float):
    """What `blame` says of a case, with the files of its source."""
    with tempfile.TemporaryDirectory() as folder:
        files = shader_files(case.source.method, array_lengths(case.source.uniforms), registers=True)
        for name, text in files.items():
            (Path(folder) / name).write_text(text)
        shaders = shader_folder(Path(folder), case.scene.settings)
        return Suspicion(case.scene, case.drawing, shaders, stacks_here(GLSL), case.profile, seconds).blame()


def cases(side: int, every: int, right: int) -> Iterator[Case]:
    """All of them."""
    for number, (name, scene, own) in enumerate(each for shipped in SCENES for each in mutated(shipped, side, every)):
        yield Case(name, SHADER if number % 2 else COMPILER, scene, drawn(own), own if number % 2 else scene)
    yield from ported(side)
    yield from other_meshes(side)
    yield from right_ones(side, right)


def mutated(name: str, side: int, every: int) -> Iterator[tuple[str, Scene, Scene]]:
    """Every n-th mutant of the stages of a scene that draws other bits."""
    scene = scene_of(name, side)
    right = drawn(scene).buffers
    stages = {stage.name: unbound(stage) for one in scene.method.passes for stage in one.stages if not one.on_demand}
    found = [(stage, mutant) for stage in stages.values() for mutant in mutants(stage)]
    for stage, mutant in found[::every]:
        own = replace(scene, own_stages={stage.name: replace(stage, body=mutant.body)})
        if own.forms == scene.forms and any(
            not np.array_equal(buffer, right[each], equal_nan=True) for each, buffer in drawn(own).buffers.items()
        ):
            yield f"{stage.name}: {mutant.description}", scene, own


def drawn(scene: Scene) -> Drawing:
    """What this machine's OpenGL draws."""
    return Drawing(draw(scene, keep=KEPT))


@cache
def scene_at(name: str, side: int) -> Scene:
    """A scene of the tables, once."""
    return scene_of(name, side)


def ported(side: int) -> Iterator[Case]:
    """The mistakes of the tables that are no stage's."""
    for each in (*PLANTED, *NEWER):
        mistake = each.mistake
        if not mistake.stages and mistake.draws is None:
            scene = scene_at(each.scene, side)
            given = bool(mistake.uniforms or mistake.reads)
            yield Case(each.name, INPUT if given else SETTING, scene, Drawing(each.drawn(scene)), scene)


def other_meshes(side: int) -> Iterator[Case]:
    """Meshes with some vertices or normals elsewhere, and colours that are others."""
    scene = scene_at("bust", side)
    rng = np.random.default_rng(3)
    for turn in range(6):
        moved = scene.mesh.positions.copy()
        normals = scene.mesh.normals.copy()
        chosen = rng.random(len(moved)) < 0.3
        if turn % 2:
            normals[chosen] = -normals[chosen]
        else:
            moved[chosen] *= np.float32(1.02 + 0.01 * turn)
        other = replace(scene, mesh=replace(scene.mesh, positions=moved, normals=normals))
        yield Case(f"mesh {turn}", INPUT, scene, drawn(other), scene)


def right_ones(side: int, count: int) -> Iterator[Case]:
    """Nobody's fault: what right devices of many kinds draw."""
    for seed in range(count):
        rng = np.random.default_rng(seed)
        scene = scene_at(("bust", "texture space", "two lights", "wax", "close")[seed % 5], side)
        found = drawn_by_chance(scene, rng)
        yield Case(f"right: {found.told}", NOBODY, scene, Drawing(found.buffers, found.stored), scene, found.profile)


if __name__ == "__main__":
    main()
