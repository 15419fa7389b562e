"""What scenes that say next to nothing are filled with; as a program it prints it.

python tests/support/filled_scenes.py > tests/scene_file/filled.txt
"""

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from sss_ref.scene_file.profiles import PROFILES
from sss_ref.scene_file.reading import Document, validated
from sss_ref.scene_file.substances import SUBSTANCES

LEAST = {"camera": {"type": "orbit", "distance": 3}, "lights": [{"position": [0, 0, 4]}]}
FLYING = {"camera": {"type": "free", "position": [0, 0, 4]}}
PARALLEL = {"camera": {"type": "orthographic", "eye": [0, 0, 4], "view_height": 3}}
SUN = {"lights": [{"type": "directional", "position": [0, 0, 4]}]}
PRESETS: dict[str, dict[str, Any]] = {
    "paper": {},
    "robust": {"preset": "robust"},
    "robust in mm": {"preset": "robust", "mm_per_unit": 100},
    "robust, preintegrated": {"preset": "robust", "mm_per_unit": 100, "method": "preintegrated"},
    "published": {"preset": "published", "lights": [{"position": [0, 0, 4], "type": "point"}]},
}
VIEWPOINTS = {
    "look_at": {"camera": {"type": "look_at", "eye": [0, 0, 4]}},
    "free": FLYING,
    "orthographic": PARALLEL,
    "directional": SUN,
}
LAYER: dict[str, Any] = {"path": "model.obj", "extinction_per_mm": [0.1, 0.2, 0.3]}
LAYERS: dict[str, dict[str, Any]] = {
    "a layer": {"mm_per_unit": 100, "layers": [LAYER]},
    "a material on a layer": {"mm_per_unit": 100, "layers": [{**LAYER, "material": "enamel"}]},
}
MATERIALS = {f"material {name}": {"material": name, "mm_per_unit": 100} for name in SUBSTANCES}
SCENES = {**PRESETS, **VIEWPOINTS, **LAYERS, **MATERIALS}
EXPECTED = Path(__file__).parents[1] / "scene_file" / "filled.txt"


def are_filled_as_ever(names: Iterable[str], folder: Path) -> None:
    """Hold parts to what scene files were written for: where a default is meant to change, the head of this says how.

    folder: an empty one.
    """
    expected = dict(zip(parts(), EXPECTED.read_text("utf-8").split("\n\n"), strict=True))
    for name in names:
        assert part(name, folder) == expected[name].strip()


def parts() -> list[str]:
    """The names of all parts: the scenes, and the materials' sums of Gaussians."""
    return [*SCENES, "profiles"]


def part(name: str, folder: Path) -> str:
    """Every key of the first scene; of each other one the keys that it has otherwise. folder: an empty one."""
    if name == "profiles":
        return "\n".join(["[profiles]", *(f"{each} = {brief(rows)}" for each, rows in PROFILES.items())])
    (folder / "model.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    found, before = keys_of(SCENES[name], folder), keys_of({}, folder) if SCENES[name] else {}
    lines = [f"{key} = {value}" for key, value in found.items() if before.get(key) != value]
    return "\n".join([f"[{name}]", *lines, *(f"no {key}" for key in before if key not in found)])


def keys_of(changes: Mapping[str, Any], folder: Path) -> dict[str, str]:
    """Key -> value, as text."""
    data = {"mesh": {"path": "model.obj"}, **LEAST, **changes}
    settings = validated(Document(data, "scene", folder), {})
    return {key: brief(value) for key, value in flat(settings.model_dump(), "") if not key.endswith("path")}


def flat(value: Any, key: str) -> Iterator[tuple[str, Any]]:
    """The keys of tables inside each other, joined by dots."""
    inner = value.items() if isinstance(value, Mapping) else ()
    if isinstance(value, tuple | list) and value and isinstance(value[0], Mapping):
        inner = ((str(number), each) for number, each in enumerate(value))
    for name, each in inner:
        yield from flat(each, f"{key}.{name}" if key else name)
    if not inner:
        yield key, value


def brief(value: Any) -> str:
    """A value; of many rows of numbers how many, and their sums, in which a digit more or less shows."""
    if isinstance(value, tuple) and value and isinstance(value[0], tuple) and len(value) > 1:
        return f"{len(value)} rows, {' '.join(f'{sum(column):.6g}' for column in zip(*value, strict=True))}"
    return repr(value)


if __name__ == "__main__":
    from tempfile import TemporaryDirectory

    with TemporaryDirectory() as folder:
        print("\n\n".join(part(name, Path(folder)) for name in parts()))
