"""The page's menu, from the tables and keys of the scene file: a new key has its control by itself."""

from types import NoneType
from typing import Annotated, Any, Literal, get_args, get_origin, get_type_hints

from sss_ref.errors.wording import KeyPath
from sss_ref.scene_file import diffusion, quantities, scattering, settings
from sss_ref.scene_file.key_texts import key_texts
from sss_ref.scene_file.profiles import PROFILES
from sss_ref.scene_file.reading import TABLES
from sss_ref.scene_file.shipped import mesh_names

LARGEST, STOPS = quantities.LARGEST_SIZE, quantities.MOST_STOPS
RANGES: dict[Any, tuple[float | None, float | None]] = {  # type of a number -> least and largest
    quantities.Number: (None, None),
    quantities.NonNegative: (0, None),
    quantities.Positive: (0, None),
    quantities.PositiveOrZero: (0, None),
    quantities.Strength: (0, quantities.STRONGEST),
    quantities.Texels: (0, LARGEST),
    quantities.Inset: (0, 1),
    quantities.Share: (0, 1),
    quantities.FieldOfView: (0, 180),
    quantities.Stops: (-STOPS, STOPS),
    quantities.Size: (1, LARGEST),
    quantities.Count: (0, LARGEST),
    diffusion.Samples: (1, diffusion.MOST_TAPS),
    diffusion.Taps: (3, diffusion.MOST_TAPS),
}
WHOLE = (quantities.Size, quantities.Count, diffusion.Samples, diffusion.Taps)
ONE_OR_THREE: Any = quantities.OneOrThree
CHANNELS = {ONE_OR_THREE[kind]: limits for kind, limits in RANGES.items() if kind not in WHOLE}
KINDS: dict[Any, dict[str, Any]] = {
    bool: {"kind": "switch"},
    str: {"kind": "text"},
    int: {"kind": "number", "range": (None, None), "whole": True},
    float: {"kind": "number", "range": (None, None), "whole": False},
    quantities.Vector: {"kind": "vector"},
    quantities.Direction: {"kind": "vector"},
    quantities.Scale: {"kind": "vector"},
    diffusion.ChannelShares: {"kind": "vector"},
    diffusion.ChannelLengths: {"kind": "vector"},
    quantities.Color: {"kind": "color"},
    settings.MeshColor: {"kind": "color", "names": ["material"]},
    scattering.Kernel: {"kind": "choice", "choices": [*get_args(get_args(scattering.KernelName)[0])]},
    scattering.Profile: {"kind": "choice", "choices": [*PROFILES]},
    **{kind: {"kind": "number", "range": limits, "whole": kind in WHOLE} for kind, limits in RANGES.items()},
    **{kind: {"kind": "channels", "range": limits} for kind, limits in CHANNELS.items()},
}
ANYTHING = {"kind": "value"}  # what no control is made for is typed as JSON


def menu() -> list[dict[str, Any]]:
    """Every table of a scene file with the control of each key, in the order of the reference.

    Of a table `path`, the type behind its name where it has several; of a key what it means (`help`), what sets it
    (`kind`, with `range`, `choices` or `names` of the values there are), and whether it may be left open (`optional`).
    """
    return [{"path": path, "controls": _controls(path, model)} for path, model in TABLES.items()]


def _controls(path: KeyPath, model: type[quantities.Table]) -> list[dict[str, Any]]:
    hints = get_type_hints(model, include_extras=True)
    texts = key_texts(model)
    inner = {other[len(path)] for other in TABLES if len(other) > len(path) and other[: len(path)] == path}
    return [
        {"key": key, "help": " ".join(texts[key].split()), **control(path, key, hints[key])}
        for key in model.model_fields
        if key not in inner
    ]


def control(path: KeyPath, key: str, hint: Any) -> dict[str, Any]:
    """What sets a key of this type in the table at `path`."""
    members = get_args(hint)
    if NoneType in members:
        (own,) = (each for each in members if each is not NoneType)
        return control(path, key, own) | {"optional": True}
    if hint is settings.MeshPath:
        return {"kind": "mesh", "choices": mesh_names()}
    if key == "type":
        return {"kind": "choice", "choices": [other[1] for other in TABLES if other[:1] == path[:1] and other[1:]]}
    if get_origin(hint) is Literal:
        return {"kind": "choice", "choices": [*members]}
    return _of_type(hint)


def _of_type(hint: Any) -> dict[str, Any]:
    """The control of a type, or of the plain number that it is without what is required of it."""
    if hint in KINDS:
        return KINDS[hint]
    return _of_type(get_args(hint)[0]) if get_origin(hint) is Annotated else ANYTHING
