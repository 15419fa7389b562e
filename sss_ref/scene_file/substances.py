"""Named materials: what `material` fills in, above the preset and below the scene file's own keys."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from sss_ref.errors.wording import KeyPath, told, written
from sss_ref.scene_file.kernels import HBH09, Tap
from sss_ref.scene_file.profiles import Channels


class Substance(NamedTuple):
    """A material as keys of a scene file; where its figures come from stands in the rules (Materials)."""

    color: Channels  # mesh.color: its diffuse reflectance
    scale: Channels  # translucency.scale: 1/color where the sum of Gaussians has the colour in it already
    mm_per_offset: float  # blur.mm_per_offset
    spread: Channels | None  # of each kernel the share of hbh09's red, the widest; the rest is its blue; None: hbh09
    specular: float  # phong.specular, by eye
    shininess: float  # phong.shininess, by eye


def _measured(color: Channels, mm_per_offset: float, spread: Channels, specular: float, shininess: float) -> Substance:
    """A material whose sum of Gaussians is that of a medium: `lit` multiplies by the colour, which is in it already."""
    red, green, blue = (round(1 / each, 3) for each in color)
    return Substance(color, (red, green, blue), mm_per_offset, spread, specular, shininess)


SUBSTANCES: dict[str, Substance] = {
    "skin": Substance((0.63, 0.44, 0.34), (1.0, 1.0, 1.0), 1.2, None, 0.2, 32.0),
    "marble": _measured((0.83, 0.79, 0.75), 1.41, (1.0, 0.7, 0.51), 0.35, 60.0),
    "milk": _measured((0.91, 0.88, 0.76), 1.23, (1.0, 0.66, 0.33), 0.3, 80.0),
    "wax": _measured((0.88, 0.74, 0.48), 1.6, (1.0, 0.55, 0.17), 0.25, 20.0),
    "jade": _measured((0.3, 0.55, 0.36), 1.36, (0.33, 1.0, 0.46), 0.6, 90.0),
    "enamel": _measured((0.82, 0.79, 0.72), 1.63, (1.0, 0.68, 0.4), 0.6, 80.0),
    "dentine": _measured((0.74, 0.58, 0.38), 1.26, (1.0, 0.53, 0.18), 0.1, 16.0),
}


def layer_of(name: Any, in_mm: bool) -> dict[str, Any]:
    """What a material fills in; nothing for no material, and for one that nobody knows, which validation reports.

    in_mm: whether the scene's kernel is in mm.
    """
    if not isinstance(name, str) or name not in SUBSTANCES:
        return {}
    material = SUBSTANCES[name]
    kernel = kernel_of(material.spread) if material.spread else "hbh09"
    unit = {"unit": "mm"} if in_mm else {}
    return {
        "mesh": {"color": material.color},
        "phong": {"specular": material.specular, "shininess": material.shininess},
        "translucency": {"form": "gaussians", "gaussians": name, "scale": material.scale},
        "blur": {"kernel": kernel, "mm_per_offset": material.mm_per_offset, **unit},
    }


def kernel_of(spread: Channels) -> tuple[Tap, ...]:
    """The taps of hbh09 with weights that lie between its red, which goes farthest, and its blue."""
    red, green, blue = spread

    def between(share: float, tap: Tap) -> float:
        return share * tap[2] + (1 - share) * tap[4]

    return tuple((tap[0], tap[1], between(red, tap), between(green, tap), between(blue, tap)) for tap in HBH09)


def without_unit(data: Mapping[str, Any]) -> Iterator[tuple[KeyPath, str]]:
    """Key path and problem of every material in a scene without `mm_per_unit`. data: as the file has it."""
    if data.get("mm_per_unit") is not None:
        return
    for path, name in materials_in(data).items():
        if name is not None:
            expected = "mm_per_unit beside it, since light comes through so many mm of a material"
            yield path, told(written(path), expected, "nothing", "say how many mm a unit of the scene is")


def materials_in(data: Mapping[str, Any]) -> dict[KeyPath, Any]:
    """Key path -> what stands there, for every key of a scene that names a material. data: as the file has it."""
    layers = data.get("layers")
    listed = enumerate(layers) if isinstance(layers, list | tuple) else ()
    inside: dict[KeyPath, Any] = {
        ("layers", k, "material"): each.get("material") for k, each in listed if isinstance(each, Mapping)
    }
    return {("material",): data.get("material"), **inside}
