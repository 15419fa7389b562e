"""The sweep file: a scene, what is set in it for all items, and what its keys take in turn. Every key explained here.

scene = "bust.toml"
outputs = ["png"]
[set]
camera.width = 256
[vary]
camera.azimuth = {first = 0, last = 330, count = 12}
lights.0.intensity = [0.5, 1.0]
"""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, Field, ValidationError, ValidationInfo, field_validator

from sss_ref.batch import draws
from sss_ref.batch.light_stage import LightStage
from sss_ref.errors import SceneError
from sss_ref.errors.text_file import toml_of
from sss_ref.errors.wording import described, unmet
from sss_ref.scene_file.layers import laid
from sss_ref.scene_file.quantities import Table, requiring
from sss_ref.scene_file.shipped import scene_names

OutputName = Literal["png", "npz", "exr", "zarr"]
Outputs = Annotated[
    tuple[OutputName, ...],
    Field(strict=False),
    requiring(lambda names: len(set(names)) == len(names) > 0, "one or several outputs, each once"),
]
Names = Annotated[tuple[str, ...], Field(strict=False), requiring(len, "at least one name")]
OLAT = {  # what a light stage has unless the file says otherwise
    "outputs": ["png", "npz"],
    "keep": ["image", "coverage", "position_world", "normal_world", "albedo", "thickness"],
    "cameras": True,
}


class Sweep(Table):
    """The whole file. In [set] and [vary] keys are written as in a scene file; lights.0 is the first light."""

    scene: str = "default"
    """A scene file or a bundle, relative to the sweep file, or the name of a shipped scene."""
    combine: Literal["grid", "zip"] = "grid"
    """grid: every value of a key with every value of the others, the last key fastest; zip: the first value of all
    keys, then the second, and so on. Random keys are drawn anew for every item."""
    repeat: Annotated[int, requiring(lambda n: 1 <= n <= 10**9, "a whole number from 1 to 10^9")] = 1
    """How often the grid is gone through, for keys that are drawn at random."""
    seed: Annotated[int, requiring(lambda n: n >= 0, "a whole number >= 0")] = 0
    """Of the random keys."""
    olat: LightStage | None = None
    """One light at a time, instead of the scene's; its values become those of the key `lights`, the fastest."""
    outputs: Outputs = ("png",)
    """png: image.png. npz: buffers.npz, row 0 at the bottom. exr: buffers.exr, a part for each buffer.
    zarr: one store for all items, an array for each buffer."""
    keep: Names = ("final",)
    """Names of the buffers that are kept and hashed, or "final", the image, or "all"."""
    cameras: bool = False
    """Whether transforms.json is written: the cameras in the form that nerfstudio reads."""
    set: dict[str, draws.SceneValue] = Field(default_factory=dict)
    """One value for all items."""
    vary: dict[str, draws.Values] = Field(default_factory=dict)
    """Of each key an array of values; or {first, last, count}, evenly spaced; or {random = "uniform", low, high},
    "log_uniform" or "integer" likewise, {random = "choice", values}, {random = "sphere", radius, center}."""

    @field_validator("cameras")
    @classmethod
    def _of_pictures(cls, cameras: bool, info: ValidationInfo) -> bool:
        if cameras and "png" not in info.data.get("outputs", ("png",)):
            raise unmet('false without the output "png"', "add it to outputs")
        return cameras

    @field_validator("vary")
    @classmethod
    def _with_lights(cls, vary: dict[str, Any], info: ValidationInfo) -> dict[str, Any]:
        stage = info.data.get("olat")
        if stage is None:
            return _not_empty(vary, info)
        given = [key for key in (*info.data.get("set", {}), *vary) if key.partition(".")[0] == "lights"]
        if given:
            raise unmet(f"no {given[0]} beside olat", "remove one of the two", "both")
        return {**vary, "lights": stage.lights(info.data.get("seed", 0))}


def _not_empty(vary: dict[str, Any], info: ValidationInfo) -> dict[str, Any]:
    if not vary and "olat" in info.data:  # otherwise it is wrong, which is told
        raise unmet("at least one key to vary", "add it")
    return vary


TABLES: dict[str, type[BaseModel]] = {
    "spaced": draws.Spaced,
    "uniform": draws.Uniform,
    "log_uniform": draws.LogUniform,
    "integer": draws.Whole,
    "choice": draws.Choice,
    "sphere": draws.OnSphere,
}


def read_sweep(path: Path, lights: int | None = None) -> Sweep:
    """The sweep in a file, its scene's path made absolute. Raises SceneError, which lists all that is wrong.

    lights: olat.count, instead of what the file has.
    """
    data = toml_of(path, "a sweep file", SceneError)
    if lights is not None:
        data["olat"] = laid(data.get("olat", {}), {"count": lights})
    sweep = checked_sweep(data, str(path))
    if sweep.scene in scene_names():
        return sweep
    return sweep.model_copy(update={"scene": str((path.parent / sweep.scene).absolute())})


def checked_sweep(data: Mapping[str, Any], source: str) -> Sweep:
    """The sweep in tables as a file has them. source: what messages call it. Raises SceneError."""
    given = {**OLAT, **data} if "olat" in data else dict(data)
    for name, is_whole in (("set", _is_plain), ("vary", _is_values)):
        if isinstance(given.get(name), Mapping):
            given[name] = dict(_dotted(given[name], is_whole))
    try:
        return Sweep.model_validate(given)
    except ValidationError as error:
        raise SceneError("\n".join(f"{source}: {problem}" for problem in _problems(error))) from None


def _dotted(table: Mapping[str, Any], is_whole: Any, prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Dotted key and value of everything in nested tables, down to what is whole."""
    for key, value in table.items():
        if isinstance(value, Mapping) and not is_whole(value):
            yield from _dotted(value, is_whole, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value


def _is_plain(table: Mapping[str, Any]) -> bool:
    """Whether a table can be laid on the scene as it is: nothing in it is the place of a light."""
    return not any(
        key.isdecimal() or (isinstance(value, Mapping) and not _is_plain(value)) for key, value in table.items()
    )


def _is_values(table: Mapping[str, Any]) -> bool:
    """Whether a table says which values a key takes: no key of a scene has such a name."""
    return bool({"random", "first", "last", "count"} & set(table))


def _problems(error: ValidationError) -> Iterator[str]:
    for details in error.errors():
        place, known = details["loc"], Sweep.model_fields
        if len(place) > 3 and place[0] == "vary" and place[2] in TABLES:  # pydantic inserts the name of the form
            known = TABLES[str(place[2])].model_fields
        elif place[0] in ("vary", "olat"):
            known = LightStage.model_fields if place[0] == "olat" else {}
        shortened = details.copy()
        shortened["loc"] = (*place[:2], *place[3:]) if place[0] == "vary" else place
        yield described(shortened, known)[1]
