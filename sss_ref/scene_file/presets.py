"""Named sets of parameters: everything a scene file leaves out comes from its preset.

What every preset has in common (map sizes, Phong terms, bias) is the default of its field in `settings.py`;
here is only what tells the presets apart.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sss_ref.errors.wording import KeyPath, shown, told, written

# The paper's text, literally.
PAPER: dict[str, Any] = {
    "translucency": {"form": "ratio", "combine": "multiply", "scale": 1.0, "x": 2.0, "y": -1.0, "d_min": 0.1},
    "blur": {"kernel": "table1", "mask": "output", "pixel_scale": 1.0},
    "irradiance_map": {"mode": "paper", "image": "sqrt", "dilate": 4},
}

# What looks right on a real mesh: light from behind goes round the terminator, shadows are soft and red at their edges,
# and no colour bleeds over silhouettes. The exponent lets a sphere fall off evenly into the dark: with the paper's 0.6
# its far side is brighter again. T * scale is 0.98 at d_min: what is thin lets through what it would reflect. d_min is
# small, since behind the terminator, as long as the body is thinner, light from behind grows with its angle and T does
# not fall: with 0.1 that made a dark line. For the same reason wrap is more than 0.3, and leaves less for it to add.
ROBUST: dict[str, Any] = {
    "shadow_map": {"test": "kernel"},
    "translucency": {
        "form": "ratio",
        "combine": "transmit_wrapped",
        "wrap": 0.5,
        "scale": 0.05,
        "x": 2.0,
        "y": 0.5,
        "exponent": 0.75,
        "d_min": 0.03,
    },
    "blur": {"kernel": "hbh09", "mask": "taps", "pixel_scale": 2.0},
    "irradiance_map": {"mode": "lambert", "image": "product", "dilate": 8},
}

# What `robust` has in the place of pixels where the scene says how long its unit is.
ROBUST_IN_MM: dict[str, Any] = {"blur": {"unit": "mm", "follow_surface": True}}

# What it has with method `preintegrated`, whose own shadows go round.
ROBUST_PREINTEGRATED: dict[str, Any] = {"shadow_map": {"test": "slope"}}

# What the printed figures compute: the paper's application, maps of eight bits included (methods/published/).
PUBLISHED: dict[str, Any] = {
    "camera": {"fov_y": 45.0, "near": 0.001, "far": 1000.0, "width": 1600, "height": 900},
    "lights": {"type": "point", "target": [0.0, 0.0, 0.0], "fov_y": 90.0, "near": 0.001, "far": 1000.0},
    "shadow_map": {
        "width": 1600,
        "height": 900,
        "filter": "bilinear",
        "lookup_inset": 0.99,
        "test": "exact",
        "encoding": "unorm8",
        "lookup_stage": "vertex",
    },
    "translucency": {"form": "exponent", "combine": "add", "scale": 1.0, "x": 0.5, "y": 1.0, "d_min": 0.0},
    "blur": {"kernel": "schoenberger", "unit": "pixel", "mask": "none", "pixel_scale": 1.0, "follow_surface": False},
    "irradiance_map": {"width": 1600, "height": 900, "mode": "distance", "image": "sqrt_add", "dilate": 0},
}

PRESETS: dict[str, dict[str, Any]] = {"paper": PAPER, "robust": ROBUST, "published": PUBLISHED}

# Key -> its value in `published`, whose passes are fixed: there nothing else is possible.
FIXED: dict[str, Any] = {
    "material": None,
    "mesh.normal_map": None,
    "mesh.specular_map": None,
    "shadow_map.filter": "bilinear",
    "shadow_map.test": "exact",
    "shadow_map.encoding": "unorm8",
    "shadow_map.lookup_stage": "vertex",
    "translucency.form": "exponent",
    "translucency.combine": "add",
    "translucency.d_min": 0.0,
    "blur.unit": "pixel",
    "blur.follow_surface": False,
    "blur.mask": "none",
    "irradiance_map.mode": "distance",
    "irradiance_map.image": "sqrt_add",
    "irradiance_map.dilate": 0,
}

# The keys whose value in FIXED exists in `published` only.
ONLY_PUBLISHED = (
    "shadow_map.test",
    "shadow_map.encoding",
    "shadow_map.lookup_stage",
    "translucency.d_min",
    "irradiance_map.image",
)


def misfits(data: Mapping[str, Any]) -> Iterator[tuple[KeyPath, str]]:
    """Key path and problem of every value that does not go with the preset.

    data: the scene as parsed, with every key of its preset filled in.
    """
    name = data.get("preset")
    for key, fixed in FIXED.items():
        path = tuple(key.split("."))
        value = _at(data, path)
        if name == "published" and value != fixed:
            yield path, _misfit(path, "nothing" if fixed is None else shown(fixed), value)
        elif name != "published" and key in ONLY_PUBLISHED and fixed in _each(value):
            yield path, told(key, 'another value without preset "published"', shown(value), "choose one, or the preset")
    if name == "published":
        yield from _misfit_lights(data.get("lights"))
        if data.get("layers"):
            yield ("layers",), _misfit(("layers",), "none", "some")
        if _at(data, ("camera", "type")) == "orthographic":
            yield ("camera", "type"), _misfit(("camera", "type"), "a perspective", "orthographic")


def _each(value: Any) -> Sequence[Any]:
    """The numbers of a key that takes one or three."""
    return value if isinstance(value, list | tuple) else (value,)


def _misfit_lights(lights: Any) -> Iterator[tuple[KeyPath, str]]:
    """The figures have one light, at a point, without falloff."""
    if not isinstance(lights, list | tuple):
        return
    if len(lights) > 1:
        yield ("lights",), _misfit(("lights",), "one light", len(lights))
    for number, light in enumerate(lights):
        for key, usual in (("type", "point"), ("falloff", "none")):
            path = ("lights", number, key)
            if isinstance(light, Mapping) and light.get(key, usual) != usual:
                yield path, _misfit(path, shown(usual), light[key])


def _misfit(path: KeyPath, expected: str, value: Any) -> str:
    return told(
        written(path), f'{expected} with preset "published"', shown(value), "remove it or choose another preset"
    )


def _at(data: Any, path: KeyPath) -> Any:
    """What stands at a key path; None where nothing does."""
    for part in path:
        data = data.get(part) if isinstance(data, Mapping) else None
    return data
