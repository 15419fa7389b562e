"""Random scenes, of every setting that has named values, and what must hold of each that is not refused."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from types import UnionType
from typing import Annotated, Literal, Union, get_args, get_origin

import numpy as np
from PIL import Image
from pydantic import BaseModel
from scenes import sphere, written

from sss_ref.errors import ShaderError, SssRefError
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.settings import SceneFile
from sss_ref.scene_file.shipped import mesh_names, mesh_path
from sss_ref.validation.stage_by_stage import validate

LARGEST_FILE = 100_000  # bytes of a shipped mesh that is drawn many times
WIDEST, HIGHEST = 97, 61
LARGEST_MAP = 48
SHARES = (0.0, 0.1, 0.4)  # of the settings with named values that a scene gives
MOST_TRIES = 1000
TOO_MANY = "textures, as this OpenGL has units for"
A_PROBLEM = re.compile(r".+: expected .+, got .+")  # a line of an error


@dataclass(frozen=True)
class Outcome:
    """What came of one seed: the scene, how many before it were refused, whether nothing is drawn, what is wrong.

    beyond: whether it has more textures than this OpenGL takes.
    """

    tables: dict
    refused: int
    blank: bool
    faults: tuple[str, ...]
    beyond: bool = False


def trial(folder, seed, opengl=False):
    """A scene by chance, and whether everything holds of it that must hold of every scene.

    opengl: whether this machine's OpenGL draws it too. What raises anything but a SssRefError goes through.
    """
    rng = np.random.default_rng(seed)
    tables, scene, refused = accepted(folder, rng)
    ours, faults = rendered_alike(scene)
    blank = ours is None or not ours["coverage"].any()
    if not blank:
        faults += judged(ours, ours.buffers, PROFILES)
    drawn = drawn_by_opengl(scene) if opengl and not blank else {}
    if drawn:
        faults += [f"OpenGL: {each}" for each in judged(ours, drawn, ["vulkan"])]
    return Outcome(tables, refused, blank, tuple(faults), beyond=drawn is None)


def accepted(folder, rng):
    """The first scene that is not refused, and how many were: each in whole lines."""
    for refused in range(MOST_TRIES):
        tables = tables_by_chance(folder, rng)
        try:
            return tables, load_scene(tables), refused
        except SssRefError as error:
            check_wording(error, tables)
    raise AssertionError(f"{MOST_TRIES} scenes refused, one after the other")


def check_wording(error, tables):
    """Raise AssertionError unless every line of an error says where, what was expected and what came."""
    unworded = [line for line in str(error).splitlines() if not A_PROBLEM.fullmatch(line)]
    assert not unworded, f"{unworded} of {tables}"


def rendered_alike(scene):
    """The rendering by compiled kernels, None where one is refused; and in what that of arrays differs, in a line."""
    (kernel, refusal), (arrays, other) = (rendered(scene, interpreter) for interpreter in ("kernel", "arrays"))
    if refusal or other:
        return None, [f"kernel: {refusal or 'drawn'}; arrays: {other or 'drawn'}"] if refusal != other else []
    names = [name for name, digest in kernel.hashes.items() if digest != arrays.hashes[name]]
    return kernel, [f"kernel and arrays differ in {', '.join(names)}"] if names else []


def rendered(scene, interpreter):
    """The rendering, or why it is refused."""
    try:
        return render(scene, interpreter=interpreter), None
    except SssRefError as error:
        check_wording(error, scene.settings)
        return None, str(error)


def drawn_by_opengl(scene):
    """What this machine's OpenGL draws; None for a scene of more textures than it takes, which is refused in a line."""
    from sss_ref.gl import draw

    try:
        return draw(scene)
    except ShaderError as error:
        if TOO_MANY not in str(error):
            raise
        check_wording(error, scene.settings)
        return None


def judged(ours, buffers, profiles):
    """A line for each of the profiles in which buffers of a right device fail."""
    reports = {name: validate(ours, buffers, profile=name, explain=False) for name in profiles}
    return [f"profile {name}: {report.summary}" for name, report in reports.items() if not report.passed]


def tables_by_chance(folder, rng):
    """The tables of a scene file; most keys are left to the preset, and the scene may be one that is refused."""
    share = pick(rng, SHARES)
    tables = given(SceneFile, rng, share) | {"camera": camera_by_chance(rng, share), "lights": []}
    for key in ("method", "preset"):
        tables[key] = pick(rng, named(SceneFile.model_fields[key].annotation))
    for _ in range(pick(rng, (1, 1, 2, 3, 4))):
        tables["lights"].append(light_by_chance(rng, share))
    tables["mesh"] |= mesh_by_chance(folder, rng)
    if rng.random() < 0.1:
        tables["layers"] = [layer_by_chance(rng, share)]
    if rng.random() < 0.4:
        tables["mm_per_unit"] = float(rng.uniform(0.5, 20))
    for key in ("shadow_map", "irradiance_map"):
        tables[key] |= {side: size(rng, LARGEST_MAP) for side in ("width", "height")}
    if tables["preset"] != "published":
        tables["irradiance_map"]["dilate"] = int(rng.integers(0, 5))
        tables["diffusion"] |= {"samples": int(rng.integers(1, 17)), "taps": pick(rng, (3, 5, 9))}
    return tables


def given(table, rng, share):
    """The tables in a table, and of its settings with named values a share; arrays and choices of tables are not."""
    found = {}
    for key, field in table.model_fields.items():
        values = named(field.annotation)
        if isinstance(field.annotation, type) and issubclass(field.annotation, BaseModel):
            found[key] = given(field.annotation, rng, share)
        elif values and key != "type" and rng.random() < share:
            found[key] = pick(rng, values)
    return {key: value for key, value in found.items() if value is not None}


def named(annotation):
    """The values of a type that have names, false and true among them, and None where it may be left out too."""
    return [value for kind in alternatives(annotation) for value in _named(kind)]


def _named(kind):
    return get_args(kind) if get_origin(kind) is Literal else (False, True) if kind is bool else ()


def alternatives(annotation) -> Iterator[object]:
    """The types that a type is a choice of, itself where it is none."""
    if get_origin(annotation) is Annotated:
        yield from alternatives(annotation.__origin__)
    elif get_origin(annotation) in (Union, UnionType):
        for each in get_args(annotation):
            yield from alternatives(each)
    else:
        yield annotation


def camera_by_chance(rng, share):
    """A camera of any type that mostly looks at the middle."""
    kind = pick(rng, list(alternatives(SceneFile.model_fields["camera"].annotation)))
    eye = direction(rng) * rng.uniform(2.5, 6)
    level, up = float(np.hypot(eye[0], eye[2])), float(eye[1])
    values = {
        "eye": eye.tolist(),
        "position": eye.tolist(),
        "yaw": float(np.degrees(np.arctan2(eye[0], eye[2]))),
        "pitch": float(np.degrees(np.arctan2(-up, level))),
        "azimuth": float(rng.uniform(-360, 360)),
        "elevation": float(rng.uniform(-90, 90)),
        "distance": float(rng.uniform(0.5, 6)),
        "view_height": float(rng.uniform(0.5, 5)),
    }
    return placed(kind, values, rng, share) | {"width": size(rng, WIDEST), "height": size(rng, HIGHEST)}


def light_by_chance(rng, share):
    """A light of any type, at a place or on an orbit, with a fitted view or one of its own."""
    (tables, _) = get_args(SceneFile.model_fields["lights"].annotation)
    kind = pick(rng, list(alternatives(tables)))
    orbit = {"azimuth": float(rng.uniform(-360, 360)), "elevation": float(rng.uniform(-90, 90)), "distance": 5.0}
    values = orbit if rng.random() < 0.3 else {"position": (direction(rng) * rng.uniform(2.5, 6)).tolist()}
    if rng.random() < 0.3:
        values |= {"fov_y": float(rng.uniform(5, 120)), "view_height": float(rng.uniform(0.5, 5)), "near": 0.1}
    values |= {"target": rng.normal(size=3).tolist()} if rng.random() < 0.3 else {}
    values |= {"color": rng.uniform(0, 1, 3).tolist(), "intensity": float(rng.uniform(0, 2))}
    return placed(kind, values, rng, share)


def placed(kind, values, rng, share):
    """A table of a kind that has a type: of the values those whose keys it has, and a share of its named ones."""
    own = {key: value for key, value in values.items() if key in kind.model_fields}
    return {"type": pick(rng, named(kind.model_fields["type"].annotation)), **given(kind, rng, share), **own}


def layer_by_chance(rng, share):
    """A body inside the mesh."""
    (table, _) = get_args(SceneFile.model_fields["layers"].annotation)
    return given(table, rng, share) | {"path": "teaching", "extinction_per_mm": rng.uniform(0, 2, 3).tolist()}


def mesh_by_chance(folder, rng):
    """A shipped mesh or one written for the purpose, placed, now and then with pictures on it."""
    small = [name for name in mesh_names() if mesh_path(name).stat().st_size <= LARGEST_FILE]
    body = pick(rng, [*small, "tetrahedron", "sphere", "soup"])
    table = {"path": body if body in small else body_by_chance(folder, body, rng)}
    if rng.random() < 0.5:
        table["rotate_degrees"] = rng.uniform(-180, 180, 3).tolist()
        table["scale"] = (rng.uniform(0.3, 1.5, 3) * rng.choice([-1, 1], 3)).tolist()
    for key in ("texture", "normal_map", "specular_map"):
        if rng.random() < 0.1:
            table[key] = picture_by_chance(folder, key, rng)
    return table


def body_by_chance(folder, body, rng):
    """The path of an OBJ file: a tetrahedron, a sphere or triangles in disorder, by name."""
    if body == "sphere":
        arrays = sphere(int(rng.integers(3, 9)))
    else:
        count = 4 if body == "tetrahedron" else 3 * int(rng.integers(1, 20))
        corners = np.array([(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)]) if body == "tetrahedron" else disorder(count)
        arrays = rng.normal(size=(count, 3)), corners, rng.uniform(-0.2, 1.2, (count, 2))
    return written(folder / f"{body}{rng.integers(1 << 30)}.obj", *arrays)


def disorder(count):
    """Triangles that share no vertex."""
    return np.arange(count).reshape(-1, 3)


def picture_by_chance(folder, key, rng):
    """The path of a PNG file of a few texels, grey where it must be."""
    shape = (int(rng.integers(1, 9)), int(rng.integers(1, 9)), *([] if key == "specular_map" else [3]))
    path = folder / f"{key}{rng.integers(1 << 30)}.png"
    Image.fromarray(rng.integers(0, 256, shape, np.uint8)).save(path)
    return str(path)


def size(rng, largest):
    """Pixels of a side: the extremes more often than others."""
    return pick(rng, (1, largest, *rng.integers(1, largest + 1, 4).tolist()))


def direction(rng):
    """A unit vector."""
    v = rng.normal(size=3)
    return v / np.sqrt((v * v).sum())


def pick(rng, values):
    """One of several values, each as likely."""
    return values[int(rng.integers(len(values)))]
