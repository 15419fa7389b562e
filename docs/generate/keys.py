"""One key of a scene file or of a mapping file: its type in words, its default in each preset, its explanation."""

import json
from types import NoneType
from typing import Any, Literal, get_args, get_origin

from markup import directive, prose
from pydantic.fields import FieldInfo

from sss_ref.dump import mapping
from sss_ref.scene_file import diffusion, quantities, scattering, settings
from sss_ref.scene_file.key_texts import key_texts
from sss_ref.scene_file.presets import PRESETS
from sss_ref.scene_file.profiles import PROFILES
from sss_ref.scene_file.quantities import Table

WORDS = {  # how a reader calls the type of a value
    str: "text",
    bool: "`true` or `false`",
    quantities.Number: "number",
    quantities.NonNegative: "number ≥ 0",
    quantities.Positive: "number > 0",
    quantities.PositiveOrZero: "number ≥ 0",
    quantities.OneOrThree[quantities.Number]: "number, or three: `[r, g, b]`",
    quantities.OneOrThree[quantities.NonNegative]: "number ≥ 0, or three: `[r, g, b]`",
    quantities.OneOrThree[quantities.Positive]: "number > 0, or three: `[r, g, b]`",
    quantities.OneOrThree[quantities.PositiveOrZero]: "number ≥ 0, or three: `[r, g, b]`",
    quantities.Inset: "number > 0 and ≤ 1",
    quantities.Share: "number from 0 to 1",
    quantities.Strength: f"number from 0 to {quantities.STRONGEST}",
    quantities.Texels: f"number from 0 to {quantities.LARGEST_SIZE}",
    quantities.Stops: f"number from -{quantities.MOST_STOPS} to {quantities.MOST_STOPS}",
    quantities.FieldOfView: "angle between 0 and 180 degrees",
    quantities.Size: f"whole number from 1 to {quantities.LARGEST_SIZE}",
    quantities.Count: f"whole number from 0 to {quantities.LARGEST_SIZE}",
    quantities.Vector: "`[x, y, z]`",
    quantities.Direction: "`[x, y, z]`, not all zero",
    quantities.Color: "`[r, g, b]`, each ≥ 0",
    quantities.Scale: "number or `[x, y, z]`, none zero",
    settings.MeshPath: "text",
    settings.PhongSettings: "table",
    scattering.TranslucencySettings: "table",
    settings.MeshColor: '`[r, g, b]`, each ≥ 0, or `"material"`',
    scattering.Kernel: "one of "
    + ", ".join(f'`"{name}"`' for name in get_args(get_args(scattering.KernelName)[0]))
    + ", or an array of `[X, Y, r, g, b]`",
    scattering.Profile: "one of " + ", ".join(f'`"{name}"`' for name in PROFILES) + ", or an array of `[v, r, g, b]`",
    diffusion.Samples: f"whole number from 1 to {diffusion.MOST_TAPS}",
    diffusion.ChannelShares: "`[r, g, b]`, each from 0 to 1",
    diffusion.ChannelLengths: "`[r, g, b]`, each > 0",
    diffusion.Taps: f"odd whole number from 3 to {diffusion.MOST_TAPS}",
    mapping.Part: "text or whole number",
    mapping.ChannelNames: "text of single letters, or an array of names",
    mapping.Shape: "`[height, width]` or `[height, width, channels]`",
    mapping.Factor: "number, not 0, or one for each channel",
    mapping.Summand: "number, or one for each channel",
}


def entry(name: str, model: type[Table], key: str, hint: Any, more: list[tuple[str, str]]) -> str:
    """One key of a model; more: options of its directive."""
    dotted = f"{name}.{key}" if name else key
    field, text = model.model_fields[key], key_texts(model)[key]
    assert text, f"{dotted}: expected a docstring below the field, got none; add it"
    options = [("type", words(hint)), ("default", default(name, key, field)), *more]
    return directive("confval", dotted, prose(text), options)


def words(hint: Any) -> str:
    """A type for the reader."""
    if get_origin(hint) is Literal:
        return "one of " + ", ".join(f'`"{value}"`' for value in get_args(hint))
    if NoneType in get_args(hint):
        return words(next(each for each in get_args(hint) if each is not NoneType))
    return WORDS[hint]


def default(name: str, key: str, field: FieldInfo) -> str:
    """What a key is if the file does not say: one value, or one for each preset."""
    values = {preset: preset_value(preset, name, key, field) for preset in PRESETS}
    if len(set(values.values())) == 1:
        return values["paper"]
    common = [value for value in values.values() if list(values.values()).count(value) > 1][:1]
    told = [f"{value} in `{preset}`" for preset, value in values.items() if value not in common]
    return "; ".join([*common, *told])


def preset_value(preset: str, name: str, key: str, field: FieldInfo) -> str:
    """A key's default with a preset, as TOML has it."""
    given = PRESETS[preset].get(name, {})
    if key in given:
        return f"`{json.dumps(given[key])}`"
    if field.is_required():
        return "must be given"
    return "not set" if field.default is None else f"`{json.dumps(field.default)}`"
