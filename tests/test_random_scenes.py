"""Scenes that nobody chose: arrays and kernels have the same bits, and what they draw passes in every profile.

`benchmarks/random_scenes.py` tries as many as one likes.
"""

from collections import defaultdict
from typing import Literal

import numpy as np
import pytest
import scenes_by_chance
from opengl import needs_mesa
from scenes_by_chance import drawn_by_opengl, given, judged, rendered_alike, tables_by_chance, trial

from sss_ref.errors import SceneError, ShaderError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.quantities import Table
from sss_ref.scene_file.settings import SceneFile

SMALL = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}
SEEDS = range(20)


@pytest.mark.parametrize("seed", SEEDS)
def test_everything_holds_of_a_scene_by_chance(seed, tmp_path):
    outcome = trial(tmp_path, seed)
    assert not outcome.faults, outcome.tables


@needs_mesa
def test_what_opengl_draws_of_one_passes(tmp_path):
    outcome = trial(tmp_path, 3, opengl=True)
    assert not outcome.blank and not outcome.faults, outcome.tables


def test_every_value_with_a_name_is_drawn(tmp_path):
    """As the schema of scene files has them, which pydantic writes: table -> key -> values."""
    rng, drawn = np.random.default_rng(1), defaultdict(set)
    for _ in range(1500):
        collect("", tables_by_chance(tmp_path, rng), drawn)
    expected = defaultdict(set)
    for key, values in named_in_schema(SceneFile.model_json_schema()):
        expected[key] |= values
    assert {"method", "blur.mask", "lights.type", "camera.type", "mesh.unwrap"} < set(expected)
    assert {key: values - drawn[key] for key, values in expected.items() if values - drawn[key]} == {}


def named_in_schema(schema):
    """Key and named values of every setting that has some, by the schema alone."""
    keys = list(schema["properties"].items())
    for key, described in schema["properties"].items():
        for table in referred(described, schema["$defs"]):
            keys += [(f"{key}.{own}", inner) for own, inner in table["properties"].items()]
    for key, described in keys:
        if values_of(described):
            yield key, values_of(described)


def collect(name, value, drawn):
    if isinstance(value, dict):
        for key, inner in value.items():
            collect(f"{name}.{key}".removeprefix("."), inner, drawn)
    elif isinstance(value, list) and value and isinstance(value[0], dict):
        for inner in value:
            collect(name, inner, drawn)
    elif isinstance(value, str | bool):
        drawn[name].add(value)


def referred(described, definitions):
    """The tables that a key of the scene may hold, one by one."""
    if "$ref" in described:
        return [definitions[described["$ref"].rpartition("/")[2]]]
    inner = [described["items"]] if "items" in described else described.get("oneOf", [])
    return [table for each in inner for table in referred(each, definitions)]


def values_of(described):
    """The values of a key that have names."""
    found = {described["const"]} if "const" in described else set(described.get("enum", ()))
    return found.union({False, True} if described.get("type") == "boolean" else (), *map(values_of, choices(described)))


def choices(described):
    return described.get("anyOf", []) + described.get("oneOf", [])


def test_a_new_setting_is_drawn_by_itself():
    class Newer(Table):
        sharpness: Literal["low", "high"] | None = None
        folded: bool = False
        name: str = "any"

    drawn = [given(Newer, np.random.default_rng(seed), 0.9) for seed in range(100)]
    assert {each.get("sharpness") for each in drawn} == {None, "low", "high"}
    assert {each.get("folded") for each in drawn} == {None, False, True}
    assert not any("name" in each for each in drawn)


def test_other_bits_are_named(monkeypatch):
    """As if the arrays had more light from everywhere."""
    scene = load_scene("wedge", **SMALL)

    def off(asked, interpreter):
        other = load_scene("wedge", **SMALL, **{"phong.ambient": 0.2})
        return render(other if interpreter == "arrays" else asked, interpreter=interpreter)

    monkeypatch.setattr(scenes_by_chance, "render", off)
    _, wrong = rendered_alike(scene)
    assert wrong[0].startswith("kernel and arrays differ in ")


def test_a_refusal_of_one_alone_is_named(monkeypatch):
    def off(scene, interpreter):
        if interpreter == "arrays":
            raise SceneError("camera: expected a camera, got none")
        return render(scene)

    monkeypatch.setattr(scenes_by_chance, "render", off)
    ours, (wrong,) = rendered_alike(load_scene("wedge", **SMALL))
    assert ours is None and "arrays: camera: expected a camera, got none" in wrong


def test_a_wrong_buffer_is_named():
    ours = render(load_scene("wedge", **SMALL))
    wrong = {**ours.buffers, "image": ours["image"] + np.float32(0.5)}
    (line,) = judged(ours, wrong, ["mediump"])
    assert line.startswith("profile mediump: fail")


@pytest.mark.parametrize("came", ["40; draw fewer lights", "a linker's words"])
def test_only_too_many_textures_may_be_refused_by_opengl(monkeypatch, came):
    def refusing(scene):
        units = "camera_5: expected at most 32 textures, as this OpenGL has units for, got "
        raise ShaderError((units if "fewer" in came else "camera_5: expected shaders that link, got ") + came)

    monkeypatch.setattr("sss_ref.gl.draw", refusing)
    scene = load_scene("wedge", **SMALL)
    if "fewer" in came:
        assert drawn_by_opengl(scene) is None
    else:
        with pytest.raises(ShaderError, match="linker"):
            drawn_by_opengl(scene)


def test_an_error_without_its_form_is_noticed():
    scenes_by_chance.check_wording(SceneError("a: expected b, got c\nd: expected e, got f; g"), {})
    with pytest.raises(AssertionError, match="broken"):
        scenes_by_chance.check_wording(SceneError("a: expected b, got c\nbroken"), {})
