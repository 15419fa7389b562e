"""A scene in layers: the preset at the bottom, the material on it, then the file, the overrides on top."""

from collections.abc import Mapping
from typing import Any

from sss_ref.errors.wording import KeyPath, told
from sss_ref.scene_file.presets import PRESETS, ROBUST_IN_MM, ROBUST_PREINTEGRATED
from sss_ref.scene_file.substances import layer_of
from sss_ref.scene_file.viewpoints import ORBIT

DEFAULT_PRESET = "paper"


def filled(data: Mapping[str, Any]) -> dict[str, Any]:
    """`data` on top of the material and the preset it names; what nobody knows is left for validation to report.

    What a preset has of lights lies below every light, and what it has of a perspective only below one; what
    the scene has of phong and translucency lies below those of every layer and its material.
    """
    name = data.get("preset", DEFAULT_PRESET)
    preset = PRESETS.get(name if isinstance(name, str) else DEFAULT_PRESET, PRESETS[DEFAULT_PRESET])
    in_mm = _is_in_mm(data)
    if name == "robust" and in_mm:
        preset = laid(preset, ROBUST_IN_MM)
    if name == "robust" and data.get("method") == "preintegrated":
        preset = laid(preset, ROBUST_PREINTEGRATED)
    if name != "published":  # which has no materials; `misfits` will say so
        preset = laid(preset, layer_of(data.get("material"), in_mm))
    camera, lights = data.get("camera"), data.get("lights")
    if isinstance(camera, Mapping) and camera.get("type") == "orthographic":
        lens = {key: value for key, value in preset.get("camera", {}).items() if key != "fov_y"}
        preset = {**preset, "camera": lens}
    if isinstance(lights, list | tuple):
        data = {**data, "lights": [laid(preset.get("lights", {}), light) for light in lights]}
    below = laid(preset, data)
    layers = data.get("layers")
    if isinstance(layers, list | tuple):
        below["layers"] = [laid(_below_layer(layer, below, in_mm), layer) for layer in layers]
    return {key: value for key, value in below.items() if key in data or key != "lights"}


def _below_layer(layer: Any, scene: Mapping[str, Any], in_mm: bool) -> dict[str, Any]:
    """What lies below one of [[layers]]: its own material, and below that what the scene has. scene: filled."""
    own = layer_of(layer.get("material"), in_mm) if isinstance(layer, Mapping) else {}
    tables = {key: laid(scene.get(key, {}), own.get(key, {})) for key in ("phong", "translucency")}
    return {**tables, **own.get("mesh", {})}


def _is_in_mm(data: Mapping[str, Any]) -> bool:
    """Whether a scene's kernel is in mm: by its own word, or, without a word on pixels, for it knows its unit."""
    blur = data.get("blur")
    given = blur if isinstance(blur, Mapping) else {}
    if "unit" in given:
        return bool(given["unit"] == "mm")
    return "mm_per_unit" in data and "pixel_scale" not in given


def laid(lower: Any, upper: Any) -> Any:
    """`upper` on top of `lower`: tables key by key, all else whole.

    A table that names another `type` than the one below replaces it: the keys of an orbit mean nothing to a free
    camera.
    """
    if not (isinstance(lower, Mapping) and isinstance(upper, Mapping)):
        return upper
    if lower.get("type", upper.get("type")) != upper.get("type", lower.get("type")):
        return dict(upper)
    return {**lower, **{key: laid(lower.get(key), value) for key, value in upper.items()}}


def overridden(data: Mapping[str, Any], overrides: Mapping[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """`data` with each override laid on it, and the problems found on the way.

    overrides: key path -> value, such as "camera.width", "lights.0.intensity" or a table under its name. A light that
    they place on an orbit loses the position that it has in `data`, and the other way round.
    """
    result, problems = _without_old_places(data, override_paths(overrides)), []
    for key, value in overrides.items():
        try:
            result = _placed(result, key.split("."), value)
        except LookupError as error:
            problems.append(told(key, error.args[0], error.args[1], "correct it"))
    return result, problems


def _without_old_places(data: Mapping[str, Any], paths: set[KeyPath]) -> dict[str, Any]:
    """`data`, of its lights only the keys of a place that go with the places that overrides of these paths give."""
    lights = data.get("lights")
    if not isinstance(lights, list | tuple):
        return dict(data)
    kept = [
        _without_old_place(light, {path[2] for path in paths if path[:2] == ("lights", number) and len(path) > 2})
        for number, light in enumerate(lights)
    ]
    return {**data, "lights": kept}


def _without_old_place(light: Any, given: set[str | int]) -> Any:
    replaced: set[str] = set()
    if "position" in given and not given & set(ORBIT):
        replaced = set(ORBIT)
    elif given & {"azimuth", "elevation"} and "position" not in given:
        replaced = {"position"}
    return {key: value for key, value in light.items() if key not in replaced} if isinstance(light, Mapping) else light


def override_paths(overrides: Mapping[str, Any]) -> set[KeyPath]:
    """The key paths of all single values in `overrides`."""
    paths: set[KeyPath] = set()
    for key, value in overrides.items():
        head = tuple(int(part) if _is_index(part) else part for part in key.split("."))
        inner = override_paths(value) if isinstance(value, Mapping) else set()
        paths |= {head + path for path in inner} or {head}
    return paths


def is_overridden(path: KeyPath, paths: set[KeyPath]) -> bool:
    """Whether the value at `path` holds an override, or is part of one."""
    return any(path[: len(other)] == other[: len(path)] for other in paths)


def _is_index(part: str) -> bool:
    """Whether a part of a key stands for a place in an array; Python refuses to read numbers of thousands of digits."""
    return part.isdecimal() and len(part) < 10


def _placed(base: Any, path: list[str], value: Any) -> Any:
    """A copy of `base` with `value` laid on what is at `path`."""
    if not path:
        return laid(base, value)
    head, *rest = path
    if isinstance(base, (list, tuple)):
        if not (_is_index(head) and int(head) < len(base)):
            raise LookupError(f"an index below {len(base)}", head)
        index = int(head)
        return [*base[:index], _placed(base[index], rest, value), *base[index + 1 :]]
    table = base if isinstance(base, Mapping) else {}
    return {**table, head: _placed(table.get(head), rest, value)}
