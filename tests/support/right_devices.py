"""Devices that are right in every way that a profile allows, drawn at random; and what they would dump of a scene."""

from dataclasses import dataclass, replace

import numpy as np
from devices import Device, ExactVertices, as_it_is, cut_off, other_first_vertex, to_any_side, uncut
from random_processor import Processor
from scenes import around, cube, sphere, two_slabs, written

from sss_ref.interpret import arrays
from sss_ref.interpret.arrays import draw_values, in_chunks, stage_input
from sss_ref.interpret.intervals.profile import PROFILES, Profile
from sss_ref.interpret.work import store
from sss_ref.language.types import Vector
from sss_ref.rendering.draw import Machine
from sss_ref.rendering.fold import render, shaded
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

F = np.float32
COARSE = ("light_distance", "light_uv", "irradiance", "irradiance_filled", "scattered_irradiance", "lit", "scattered")
BYTES = ("irradiance", "irradiance_filled", "scattered_irradiance", "lit", "scattered", "image", "albedo")


class RandomStages:
    """An interpreter that runs every stage on a random processor."""

    run_vertices = staticmethod(arrays.run_vertices)

    def __init__(self, rng):
        self.processor = Processor(rng)

    def run_fragments(self, work, pool):
        for name, buffer in work.outputs.items():
            buffer[...] = work.backgrounds[name] if buffer.ndim == 3 else work.backgrounds[name][0]
        for at in in_chunks(work.fragments.where):
            values = draw_values(work, *at)
            for stage in work.this_pass.stages:
                kinds = stage.parameters.items()
                inputs = {own: stage_input(work, values, stage.reads[own], kind, at) for own, kind in kinds}
                values |= {name: single(value) for name, value in self.processor.run(stage, inputs).items()}
            for name, buffer in work.outputs.items():
                store(buffer, *at, values[name])


def single(value):
    """Float64 that holds float32, as float32."""
    if isinstance(value, Vector):
        return type(value)(*map(single, value))
    value = np.asarray(value)
    return value.astype(F) if value.dtype == np.float64 else value


def kept(buffer, storage, rng):
    """What a texture may keep of a buffer: of each number one of its neighbours, by chance."""
    up = rng.random(buffer.shape) < 0.5
    if storage == "unorm8":
        codes = np.clip(buffer, 0, 1).astype(np.float64) * 255
        codes = np.where(np.abs(codes - np.rint(codes)) < 1e-4, np.rint(codes), codes)  # n/255 is not a float32
        return (np.where(up, np.ceil(codes), np.floor(codes)) / 255).astype(F)
    near = buffer.astype(np.float16)
    beyond = np.where(near < buffer, np.inf, -np.inf).astype(np.float16)
    other = np.nextafter(near, beyond)
    return np.where(up | (near == buffer) | ~np.isfinite(other), near, other).astype(F)


@dataclass(frozen=True)
class Drawn:
    """What a device drew, as `validate` takes it."""

    buffers: dict
    stored: dict
    profile: Profile
    told: str


CHANGES = {"ours": as_it_is, "another first vertex": other_first_vertex}
ANYWHERE = {"cutting off": cut_off, "to any side": to_any_side(7)}


def drawn_by_chance(scene, rng, arithmetic="vulkan"):
    """A scene as one of all right devices draws it. arithmetic: the profile that its stages keep to."""
    bits = int(rng.choice([4, 8]))
    snap = "any" if rng.random() < 0.4 else "nearest"
    tricks = CHANGES | (ANYWHERE if snap == "any" else {})
    if snap == "nearest" and rng.random() < 0.3:
        tricks = {"guard band": uncut(scene.mesh.triangles)}
    trick = str(rng.choice(list(tricks)))
    profile = replace(PROFILES[arithmetic], subpixel_bits=bits, snap=snap)
    if arithmetic == "ieee":
        trick = trick if snap == "any" and trick in ANYWHERE else "ours"
        profile = replace(PROFILES["ieee"], subpixel_bits=bits, snap=snap)
    kind = ExactVertices if arithmetic != "ieee" and rng.random() < 0.3 else Device
    device = kind(scene, {**CHANGES, **tricks}[trick], bits)
    random = arithmetic != "ieee" and rng.random() < 0.5
    if random:
        device.machine = Machine(RandomStages(rng), None, bits, stops=False)
    storages = storages_by_chance(scene, rng) if rng.random() < 0.5 else {}
    told = f"{arithmetic} {bits} bits {snap}, {trick}, {kind.__name__}, {'random' if random else 'plain'}, {storages}"
    return Drawn(buffers_of(device, storages, rng), storages, profile, told)


def storages_by_chance(scene, rng):
    """Buffer -> the storage of its texture, of some of those for which that may be less than float32."""
    found = {}
    for name in scene.method.outputs:
        own = name.rstrip("0123456789").rstrip("_")
        choices = ["float16"] * (own in COARSE) + ["unorm8"] * (own in BYTES)
        if choices and rng.random() < 0.4:
            found[name] = str(rng.choice(choices))
    return found


def buffers_of(device, storages, rng):
    """Every buffer of the method, as a device draws it into textures of these storages."""
    scene, wanted, buffers = device.scene, set(device.scene.method.outputs), {}
    for one in scene.method.only(wanted).passes:
        sketch = device.draw(one, buffers)
        written = sketch.written | shaded(scene, one, sketch, buffers, wanted, device.machine)
        for name, buffer in written.items():
            buffers[name] = kept(buffer, storages[name], rng) if name in storages else buffer
    return {name: buffers[name] for name in scene.method.outputs}


def scene_by_chance(folder, rng):
    """The tables of a small scene of any method and preset, and what it is in words."""

    def extent():
        return {side: int(rng.integers(16, 65)) for side in ("width", "height")}

    preset = str(rng.choice(["paper", "robust", "published"]))
    method = str(rng.choice(["screen_space", "texture_space"]))
    bodies = {"sphere": (*sphere(int(rng.integers(3, 12))),), "slabs": two_slabs(), "cube": cube()}
    body = "sphere" if method == "texture_space" else str(rng.choice(list(bodies)))
    flat = body != "sphere"
    path = written(folder / f"{body}{rng.integers(1 << 30)}.obj", *bodies[body], flat=flat)
    tables = {"preset": preset, "method": method, "irradiance_map": extent(), "shadow_map": extent(), "blur": {}}
    if preset != "published":
        tables["shadow_map"]["filter"] = str(rng.choice(["nearest", "bilinear"]))
        tables["blur"]["mask"] = str(rng.choice(["none", "output", "taps"]))
        tables["irradiance_map"] |= {"mode": str(rng.choice(["paper", "lambert", "distance"]))}
        tables["irradiance_map"] |= {"dilate": int(rng.integers(0, 5))}
        form = str(rng.choice(["ratio", "exponent", "beer"]))
        combine = str(rng.choice(["multiply", "add", "transmit", "transmit_wrapped"]))
        tables["translucency"] = {"form": form, "combine": combine}
    scene = around(path, 64, **tables)
    scene["camera"] |= extent() | {"azimuth": int(rng.integers(0, 360)), "elevation": int(rng.integers(-60, 60))}
    scene["camera"] |= {"distance": float(rng.choice([0.5, 3.0, 4.5])) if body == "sphere" else 5.5, "near": 0.05}
    count = 1 if preset == "published" else int(rng.integers(1, 4))
    scene["lights"] = [{"position": [float(x) for x in _direction(rng) * rng.uniform(3.5, 6)]} for _ in range(count)]
    words = f"{method} {preset} {body} {count} lights {scene['camera']['width']}x{scene['camera']['height']}"
    return scene, f"{words} {tables['shadow_map']} {tables['irradiance_map']} {tables['blur']}"


def _direction(rng):
    v = rng.normal(size=3)
    return v / np.sqrt((v * v).sum())


def subset_by_chance(names, rng):
    """Some of the names, at least one: now and then all but one, or one alone."""
    names = list(names)
    dropped = rng.integers(len(names))
    way = rng.random()
    if way < 0.3:
        return [name for k, name in enumerate(names) if k != dropped]
    if way < 0.4:
        return [names[dropped]]
    share = rng.uniform(0.2, 0.9)
    return [name for k, name in enumerate(names) if rng.random() < share or k == dropped]


def trial(folder, seed):
    """One scene, one device, one subset of what it dumps: what was tried, and the report."""
    rng = np.random.default_rng(seed)
    tables, words = scene_by_chance(folder, rng)
    oracle = render(load_scene(tables), interpreter="arrays")
    arithmetic = str(rng.choice(["vulkan", "vulkan", "gl", "ieee"]))
    drawn = drawn_by_chance(oracle.scene, rng, arithmetic)
    names = subset_by_chance(drawn.buffers, rng)
    told = f"{words}; {drawn.told}; dumped {', '.join(names)}"
    given = {name: drawn.buffers[name] for name in names}
    return told, validate(oracle, given, drawn.stored, profile=drawn.profile, explain=False)
