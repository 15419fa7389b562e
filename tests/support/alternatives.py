"""Every method that a scene file can select."""

from functools import cache
from itertools import product
from typing import get_args

from scenes import settings_with

from sss_ref.scene.catalogue import METHODS, TECHNIQUES, method_of
from sss_ref.scene_file import scattering, settings, viewpoints
from sss_ref.scene_file.presets import FIXED, ONLY_PUBLISHED

UNREAD = {("screen_space", "irradiance_map")}  # method, table
LAYER = {"path": "any", "extinction_per_mm": [0.1, 0.2, 0.3]}


def alternatives(table, key):
    """The values of a key, but for those that only preset `published` has."""
    only_published = {FIXED[each] for each in ONLY_PUBLISHED}
    return [value for value in get_args(table.model_fields[key].annotation) if value not in only_published]


@cache
def all_methods():
    """Methods of all alternatives, of three lights, a kernel in mm, maps, and preset `published`.

    How light falls off is one stage's affair, which no other alternative touches: it is tried beside them.
    """
    return [*of_all_alternatives(), *map(method_of, map(settings_with, tried_beside()))]


def of_all_alternatives():
    """The methods of every combination of alternatives.

    The settings of a table are checked once and put together with those of the others as they are. What a method does
    not read it gets none of, so that it could not.
    """
    whole, tables = settings_with({}), {name: in_table(name, choices) for name, choices in together().items()}
    for method in METHODS:
        read = {name: [None] if (method, name) in UNREAD else there for name, there in tables.items()}
        for chosen in product(*read.values()):
            yield method_of(whole.model_copy(update={"method": method, **dict(zip(read, chosen, strict=True))}))


def in_table(name, choices):
    """A table of the settings with every combination of these choices, key -> values."""
    cases = [dict(zip(choices, values, strict=True)) for values in product(*choices.values())]
    return [getattr(settings_with({f"{name}.{key}": value for key, value in case.items()}), name) for case in cases]


def together():
    """Table -> key -> the alternatives that are tried in all combinations."""
    return {
        "mesh": {"color": ((0.7, 0.4, 0.4), "material"), "texture": (None, "any.png")},
        "shadow_map": {key: alternatives(settings.ShadowMap, key) for key in ("filter", "test")},
        "translucency": {key: alternatives(scattering.TranslucencySettings, key) for key in ("form", "combine")},
        "blur": {"mask": alternatives(scattering.Blur, "mask")},
        "irradiance_map": {key: alternatives(settings.IrradianceMap, key) for key in ("mode", "image")},
    }


def tried_beside():
    """The keys of further scenes, each of which tries something else."""
    cases = []
    for method in METHODS:
        cases.append({"method": method, "lights": [{"position": [0.0, 0.0, 5.0]}] * 3})
        cases.append({"method": method, "lights.0.type": "directional"})
        cases += [
            {"method": method, "lights.0.falloff": falloff}
            for falloff in alternatives(viewpoints.PointLight, "falloff")
        ]
        cases.append({"method": method, "preset": "published"})
        for lights, mask, follow in product((1, 3), alternatives(scattering.Blur, "mask"), (False, True)):
            blur = {"unit": "mm", "mask": mask, "follow_surface": follow}
            cases.append({"method": method, "lights": [{"position": [0.0, 0.0, 5.0]}] * lights, "blur": blur})
        for lights, form in product((1, 3), alternatives(scattering.TranslucencySettings, "form")):
            colored = {"form": form, "x": [2.0, 1.5, 1.0]}
            cases.append(
                {"method": method, "lights": [{"position": [0.0, 0.0, 5.0]}] * lights, "translucency": colored}
            )
        cases.append({"method": method, "preset": "published", "translucency": {"x": [0.5, 0.4, 0.3]}})
        cases.append({"method": method, "mesh.normal_map": "any.png", "mesh.specular_map": "any.png"})
    for technique in TECHNIQUES:
        own = [
            *({"lights": [{"position": [0.0, 0.0, 5.0]}] * lights} for lights in (1, 3)),
            *({"blur.unit": unit} for unit in alternatives(scattering.Blur, "unit")),
            {"mesh.normal_map": "any.png", "mesh.specular_map": "any.png"},
            *({"shadow_map.test": "kernel"} for _ in range(technique != "preintegrated")),
            *({"layers": [LAYER]} for _ in range(technique != "gaussian_texture")),
        ]
        cases += [{"method": technique, **case} for case in own]
    cases += [{"layers": [LAYER], "lights": [{"position": [0.0, 0.0, 5.0]}] * lights} for lights in (1, 3)]
    return cases
