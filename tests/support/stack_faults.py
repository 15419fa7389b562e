"""Faults of every class, each a picture with what it was drawn from, by whom and with which source.

`benchmarks/blame.py` tries them all; SAME_BITS counts those that draw the bits of a right picture, and so are none.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import cache
from itertools import chain, islice, takewhile
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType

import gl_states
import numpy as np
import spirv
from planted import PLANTED, scene_of
from planted_newer import NEWER
from right_devices import drawn_by_chance

from sss_ref.blame.blaming import COMPILER, INPUT, NOBODY, SETTING, SHADER
from sss_ref.blame.stacks import GLSL, Stack
from sss_ref.gl.drawing import draw_pass
from sss_ref.gl.shaders import shader_folder
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.mutants import mutants
from sss_ref.validation.witness.situation import unbound

SCENES = ("bust", "texture space", "two lights", "wax")
SAME_BITS: Counter[str] = Counter()
STATES_LEFT = (("bust", "camera"), ("two lights", "shadow_map_2"), ("texture space", "irradiance_map"))
PARTS = 4  # of the tables
DEVICE = "the device that drew it"
CHANGES = {  # scene -> keys of another scene file, each of which some engine might have set instead
    "bust": (
        {"phong.shininess": 20.0},
        {"camera.fov_y": 32.0},
        {"camera.azimuth": 131.0},
        {"lights.0.intensity": 1.3},
        {"lights.0.position": [2.5, 1.5, 1.5]},
        {"phong.ambient": 0.11},
        {"mesh.scale": [1.0, 1.0, 1.0]},
        {"mesh.rotate_degrees": [0.0, 21.0, 0.0]},
    ),
    "wax": ({"camera.distance": 4.1}, {"phong.specular": 0.3}, {"lights.0.color": [1.0, 0.9, 0.8]}),
    "texture space": ({"phong.diffuse": 0.8}, {"camera.azimuth": 10.0}),
}


@dataclass(frozen=True)
class Case:
    """A picture of a scene, and whose fault it is.

    source: the scene whose shaders the user has. device: the stack that drew it; None for this machine's.
    """

    name: str
    whose: str
    scene: Scene
    drawing: Drawing
    source: Scene
    device: Stack | None = None
    profile: Profile | str = "vulkan"


@cache
def scene_at(name: str, side: int) -> Scene:
    """A scene of the tables, once."""
    return scene_of(name, side)


@cache
def right(name: str, side: int) -> "Buffers":
    """What this machine's OpenGL draws of one, registers too."""
    return drawn(scene_at(name, side))


Texts = dict[str, str]  # file -> shader, as `shader_files` gives them
Buffers = Mapping[str, np.ndarray]
Painter = Callable[..., dict[str, np.ndarray]]  # as `draw_pass`


def texts_of(scene: Scene) -> Texts:
    """Our shaders of a scene, which write registers too."""
    return shader_files(scene.method, array_lengths(scene.uniforms), registers=True)


def painting(texts: Texts) -> Painter:
    """Draws with these shaders, whatever it is told to draw with."""

    def paint(scene, this_pass, buffers, shaders=()):
        with TemporaryDirectory() as folder:
            for name, text in texts.items():
                (Path(folder) / name).write_text(text)
            files = shader_folder(Path(folder), scene.settings)
            return draw_pass(scene, this_pass, buffers, {this_pass.name: files[this_pass.name]})

    return paint


def drawn(scene: Scene, paint: Painter | None = None, there: Buffers = MappingProxyType({})) -> Buffers:
    """The buffers of a scene, pass by pass, by a painter or with our shaders.

    there: the buffers of the passes that are drawn already.
    """
    buffers, paint = dict(there), paint or painting(texts_of(scene))
    for each in scene.method.passes:
        if not each.on_demand and not set(each.outputs) <= there.keys():
            buffers |= paint(scene, each, {name: buffers[name] for name in each.needs if name in buffers})
    return buffers


def before(name: str, side: int, where: str) -> Buffers:
    """What a right drawing of a scene holds before a pass."""
    values = [each.values for each in takewhile(lambda each: each.name != where, scene_at(name, side).method.passes)]
    return {each: right(name, side)[each] for each in chain(*values) if each in right(name, side)}


def device_with(texts: Texts) -> Stack:
    """A device whose compiler makes these of any shaders."""
    return Stack(DEVICE, GLSL, painting(texts))


def same_bits(buffers: Buffers, others: Buffers, kind: str) -> bool:
    """Whether nothing differs, which is counted."""
    same = all(np.array_equal(buffer, others[name], equal_nan=True) for name, buffer in buffers.items())
    SAME_BITS[kind] += same
    return same


def groups(side: int, mutants_of_each: int, edits_of_each: int, right_count: int) -> list[Iterator[Case]]:
    """All of them, and the right ones, in groups that may be drawn side by side."""
    edited = SCENES if spirv.are_there() else ()
    return [
        *(islice(mutated(name, side), mutants_of_each) for name in SCENES),
        *(islice(miscompiled(name, side), edits_of_each) for name in edited),
        *(states_left(*place, side) for place in STATES_LEFT),
        *(ported(side, part) for part in range(PARTS)),
        other_meshes(side),
        other_scenes(side),
        right_ones(side, right_count),
    ]


def mutated(name: str, side: int) -> Iterator[Case]:
    """Mutants of stages, some of all: in turn the user's own, and what a compiler makes of a right one."""
    scene = scene_at(name, side)
    drawn_always = [each for each in scene.method.passes if not each.on_demand]
    stages = {stage.name: unbound(stage) for each in drawn_always for stage in each.stages}
    first = {stage.name: each.name for each in reversed(drawn_always) for stage in each.stages}
    found = [(stage, mutant) for stage in stages.values() for mutant in mutants(stage)]
    np.random.default_rng(5).shuffle(found)
    number = 0
    for stage, mutant in found:
        own = replace(scene, own_stages={stage.name: replace(stage, body=mutant.body)})
        if own.forms != scene.forms:
            continue
        buffers = drawn(own, there=before(name, side, first[stage.name]))
        if same_bits(buffers, right(name, side), "mutants"):
            continue
        told = f"{name}: {stage.name}: {mutant.description}"
        if number % 2:
            yield Case(told, SHADER, scene, Drawing(buffers), own)
        else:
            yield Case(f"{told}, by a compiler", COMPILER, scene, Drawing(buffers), scene, device_with(texts_of(own)))
        number += 1


def miscompiled(name: str, side: int) -> Iterator[Case]:
    """What an edit of the SPIR-V of one shader draws."""
    scene, rng = scene_at(name, side), np.random.default_rng(7)
    with TemporaryDirectory() as folder:
        texts = texts_of(scene)
        of_passes = {file: each for each, files in _files(texts, scene).items() for file in files}  # none on demand
        binaries = _binaries({file: texts[file] for file in of_passes}, Path(folder))
        found = [(file, edit) for file, binary in binaries.items() for edit in spirv.edits(binary)]
        for index in rng.permutation(len(found)):
            file, edit = found[index]
            text = spirv.glsl(edit.applied(binaries[file]))
            if text is None:  # which is not valid
                continue
            device = device_with(texts | {file: text})
            buffers = drawn(scene, device.draw, before(name, side, of_passes[file]))
            if not same_bits(buffers, right(name, side), "edits of SPIR-V"):
                yield Case(f"{name}: {file}: {edit.told}", COMPILER, scene, Drawing(buffers), scene, device)


def _files(texts: Texts, scene: Scene) -> dict[str, list[str]]:
    """Pass -> the names of its shaders."""
    with TemporaryDirectory() as folder:
        for name in texts:
            (Path(folder) / name).touch()
        found = shader_folder(Path(folder), scene.settings)
        return {name: [path.name for path in paths] for name, paths in found.items()}


def _binaries(texts: Texts, folder: Path) -> dict[str, bytes]:
    """The SPIR-V of each shader."""
    found = {}
    for file, text in texts.items():
        (folder / file).write_text(text)
        found[file] = spirv.compiled(folder / file, folder)
    return found


def states_left(name: str, where: str, side: int) -> Iterator[Case]:
    """Draws of a mesh with a state of OpenGL that was left on in a pass."""
    scene = scene_at(name, side)
    for told, state in gl_states.STATES.items():
        buffers = drawn(scene, _left_in(where, state, painting(texts_of(scene))), before(name, side, where))
        if not same_bits(buffers, right(name, side), "states"):
            yield Case(f"{name}: {where}: {told}", SETTING, scene, Drawing(buffers), scene)


def _left_in(where: str, state: gl_states.State, paint: Painter) -> Painter:
    """Draws one pass in a state."""

    def in_state(scene, this_pass, buffers):
        with gl_states.left(state) if this_pass.name == where else nullcontext():
            return paint(scene, this_pass, buffers)

    return in_state


def ported(side: int, part: int) -> Iterator[Case]:
    """A part of the mistakes of the tables that are no stage's."""
    for each in (*PLANTED, *NEWER)[part::PARTS]:
        mistake = each.mistake
        if not mistake.stages and mistake.draws is None:
            scene = scene_at(each.scene, side)
            given = bool(mistake.uniforms or mistake.reads)
            yield Case(each.name, INPUT if given else SETTING, scene, Drawing(each.drawn(scene)), scene)


def other_meshes(side: int) -> Iterator[Case]:
    """Meshes with some vertices or normals elsewhere, with fewer triangles and with other UVs."""
    scene = scene_at("bust", side)
    mesh, rng = scene.mesh, np.random.default_rng(3)
    changed = {}
    for turn in range(6):
        chosen = rng.random(len(mesh.positions)) < 0.3
        positions, normals = mesh.positions.copy(), mesh.normals.copy()
        if turn % 2:
            normals[chosen] = -normals[chosen]
        else:
            positions[chosen] *= np.float32(1.02 + 0.01 * turn)
        changed[f"mesh {turn}"] = {"positions": positions, "normals": normals}
    changed["every tenth triangle is missing"] = {"triangles": mesh.triangles[np.arange(len(mesh.triangles)) % 10 > 0]}
    changed["positions in 10 bits"] = {"positions": np.rint(mesh.positions * 256).astype(np.float32) / 256}
    changed["normals of half the length"] = {"normals": mesh.normals * np.float32(0.5)}
    changed["mirrored"] = {"positions": mesh.positions * np.array([-1, 1, 1], np.float32)}
    for name, data in changed.items():
        buffers = drawn(replace(scene, mesh=replace(mesh, **data)))
        if not same_bits(buffers, right("bust", side), "meshes"):
            yield Case(name, INPUT, scene, Drawing(buffers), scene)


def other_scenes(side: int) -> Iterator[Case]:
    """What the scene file says otherwise, drawn all through."""
    for name, keys in CHANGES.items():
        scene = scene_at(name, side)
        for each in keys:
            buffers = drawn(scene_of(name, side, each))
            if not same_bits(buffers, right(name, side), "scene files"):
                yield Case(f"{name}: {each}", INPUT, scene, Drawing(buffers), scene)


def right_ones(side: int, count: int) -> Iterator[Case]:
    """Nobody's fault: what right devices of many kinds draw."""
    for seed in range(count):
        rng = np.random.default_rng(seed)
        scene = scene_at(("bust", "texture space", "two lights", "wax", "close")[seed % 5], side)
        found = drawn_by_chance(scene, rng)
        yield Case(
            f"right: {found.told}", NOBODY, scene, Drawing(found.buffers, found.stored), scene, None, found.profile
        )
