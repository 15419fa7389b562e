"""Every method that a scene file can select."""

from functools import cache
from itertools import product
from typing import get_args

from scenes import settings_with

from sss_ref.scene.catalogue import METHODS, TECHNIQUES, method_of
from sss_ref.scene_file import scattering, settings, viewpoints
from sss_ref.scene_file.presets import FIXED, ONLY_PUBLISHED

LAYER = {"path": "any", "extinction_per_mm": [0.1, 0.2, 0.3]}


def alternatives(table, key):
    """The values of a key, but for those that only preset `published` has."""
    only_published = {FIXED[each] for each in ONLY_PUBLISHED}
    return [value for value in get_args(table.model_fields[key].annotation) if value not in only_published]


def all_methods():
    """The methods of `methods_with_settings`."""
    return [method for method, _ in methods_with_settings()]


@cache
def methods_with_settings():
    """Methods with their settings: all alternatives, three lights, a kernel in mm, maps, `published`.

    How light falls off is one stage's affair, which no other alternative touches: it is tried beside them.
    """
    choices = {
        "method": METHODS,
        "mesh.color": ((0.7, 0.4, 0.4), "material"),
        "mesh.texture": (None, "any.png"),
        "shadow_map.filter": alternatives(settings.ShadowMap, "filter"),
        "shadow_map.test": alternatives(settings.ShadowMap, "test"),
        "translucency.form": alternatives(scattering.TranslucencySettings, "form"),
        "translucency.combine": alternatives(scattering.TranslucencySettings, "combine"),
        "blur.mask": alternatives(scattering.Blur, "mask"),
        "irradiance_map.mode": alternatives(settings.IrradianceMap, "mode"),
        "irradiance_map.image": alternatives(settings.IrradianceMap, "image"),
    }
    cases = [dict(zip(choices, values, strict=True)) for values in product(*choices.values())]
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
    return [(method_of(one), one) for one in map(settings_with, cases)]
