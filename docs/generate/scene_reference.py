"""The scene file's keys, from the models that check it: type, default in each preset, explanation."""

import inspect
from collections.abc import Iterator
from typing import Any, get_type_hints

from keys import entry, preset_value
from markup import directive, prose, table

from sss_ref.scene_file import viewpoints
from sss_ref.scene_file.presets import PRESETS
from sss_ref.scene_file.quantities import Table
from sss_ref.scene_file.reading import TABLES

HEAD = """# Scene file reference

A scene file is TOML. It names a mesh, a camera and at least one light; every other key has a default, which may depend
on the preset. Unknown keys, wrong types and values out of range are errors, all of them reported at once. Any key can
be overridden on the command line, `--set translucency.y=1.5`, and in Python,
`load_scene(name, **{"translucency.y": 1.5})`. World space is right-handed with +Y up; lengths are scene units, angles
degrees, colours linear RGB.

```toml
preset = "robust"

[mesh]
path = "head.obj"

[camera]
type = "orbit"
azimuth = 25.0
distance = 14.0

[[lights]]
position = [-9.0, 5.0, -9.0]
```
"""


def page() -> str:
    """The page: the presets side by side, then every table of the file."""
    parts = [HEAD, "## The presets side by side", presets_table(), *sections()]
    return "\n\n".join(parts) + "\n"


def sections() -> Iterator[str]:
    """Every table with its keys; what all types of camera have comes before the types."""
    for path, model in DESCRIBED.items():
        if path == ("camera", "orbit"):
            yield from section("[camera]", viewpoints.Picture, "camera", choice("camera", "must be given"), set())
        if path == ("lights", "point"):
            yield from section("[[lights]]", viewpoints.LightTable, "lights", choice("lights", '`"point"`'), set())
        if path[:1] in SHARED:
            without = set(SHARED[path[:1]].model_fields) | {"type"}
            yield from section(f'type = "{path[1]}"', model, path[0], "", without)
        else:
            yield from section(title(path), model, ".".join(path), "", set(TABLES_AT_TOP) if not path else set())


# What all types of a table have, which stands before them.
SHARED: dict[tuple[Any, ...], type[Table]] = {("camera",): viewpoints.Picture, ("lights",): viewpoints.LightTable}

# The keys of a type that a type before it has: described once more, but indexed once.
REPEATED: dict[type[Table], set[str]] = {
    viewpoints.LookAtCamera: set(viewpoints.OrbitCamera.model_fields),
    viewpoints.FreeCamera: {"fov_y"},
    viewpoints.OrthographicCamera: set(viewpoints.LookAtCamera.model_fields),
    viewpoints.DirectionalLight: set(viewpoints.PointLight.model_fields),
}
# The tables but for those of a layer that have the keys of tables at the top.
DESCRIBED = {path: model for path, model in TABLES.items() if path[0:1] != ("layers",) or len(path) == 1}
TABLES_AT_TOP = [path[0] for path in TABLES if path]


def title(path: tuple[Any, ...]) -> str:
    """The heading of a table, as TOML writes it."""
    if not path:
        return "Top of the file"
    return "[[layers]]" if path[0] == "layers" else f"[{path[0]}]"


def dotted_keys() -> list[str]:
    """Every key of a scene file with the table it stands in: method, camera.azimuth, lights.position."""
    found = [(path[0], model) if path else ("", model) for path, model in DESCRIBED.items()]
    dotted = [f"{name}.{key}".strip(".") for name, model in found for key in model.model_fields]
    return list(dict.fromkeys(key for key in dotted if key not in TABLES_AT_TOP))


def section(heading: str, model: type[Table], name: str, first: str, without: set[str]) -> Iterator[str]:
    """A table: its heading, what it is, and its keys but for some that stand elsewhere."""
    level = "###" if heading.startswith("type") else "##"
    yield f"{level} `{heading}`" if heading[0] in "[t" else f"{level} {heading}"
    yield prose(summary(model)) if name else "Keys that stand before the first table."
    if first:
        yield first
    hints = get_type_hints(model, include_extras=True)
    for key in model.model_fields:
        if key not in without:
            repeated = key in REPEATED.get(model, ())
            yield entry(name, model, key, hints[key], [("no-index", "")] if repeated else [])


def summary(model: type[Table]) -> str:
    """A model's docstring without the name of the table it begins with."""
    text = " ".join((inspect.getdoc(model) or "").split())
    told = text.split(": ", 1)[-1] if text.startswith("[") else text
    return told[0].upper() + told[1:]


def choice(table: str, default: str) -> str:
    """The key that chooses between the models of a camera, or of a light."""
    types = {path[1]: model for path, model in TABLES.items() if path[:1] == (table,)}
    told = "\n".join(f"- `{name}`: {prose(summary(model))}" for name, model in types.items())
    choices = ", ".join(f'`"{name}"`' for name in types)
    content = f"Which further keys the table has.\n\n{told}"
    return directive("confval", f"{table}.type", content, [("type", f"one of {choices}"), ("default", default)])


def presets_table() -> str:
    """The keys that tell the presets apart."""
    tables = [(path[0], model) for path, model in DESCRIBED.items() if path]
    fields = {(name, key): field for name, model in tables for key, field in model.model_fields.items()}
    rows = []
    for (name, key), field in fields.items():
        values = [preset_value(preset, name, key, field) for preset in PRESETS]
        if len(set(values)) > 1:
            rows.append([f"{{confval}}`{name}.{key}`", *values])
    return table(["key", *(f"`{preset}`" for preset in PRESETS)], rows)
