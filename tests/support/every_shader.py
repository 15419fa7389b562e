"""The shaders of every alternative of a scene file, in any dialect."""

from alternatives import LAYER, alternatives
from scenes import settings_with

from sss_ref.interpret.shader import shader_files
from sss_ref.scene.catalogue import METHODS, TECHNIQUES, method_of
from sss_ref.scene_file import scattering, settings

LENGTHS = {"tap_offset": 13, "tap_weight": 13, "material_color": 2, "gaussian_weight": 6, "gaussian_variance": 6}
CHOICES = {
    "preset": alternatives(settings.SceneFile, "preset"),
    "mesh.color": ("material",),
    "mesh.texture": ("any.png",),
    "shadow_map": tuple(
        {"filter": filtering, "test": test}
        for filtering in alternatives(settings.ShadowMap, "filter")
        for test in alternatives(settings.ShadowMap, "test")
    ),
    "translucency.form": alternatives(scattering.TranslucencySettings, "form"),
    "translucency.combine": alternatives(scattering.TranslucencySettings, "combine"),
    "blur.mask": alternatives(scattering.Blur, "mask"),
    "blur": tuple(
        {"unit": "mm", "mask": mask, "follow_surface": follow}
        for mask in alternatives(scattering.Blur, "mask")
        for follow in (False, True)
    ),
    "mesh.normal_map": ("any.png",),
    "mesh.specular_map": ("any.png",),
    "lights.0.type": ("directional",),
    "translucency": tuple(
        {"combine": combine, "scale": [0.2, 0.3, 0.4]}
        for combine in alternatives(scattering.TranslucencySettings, "combine")
    )
    + tuple({"form": form, "x": [2.0, 1.5, 1.0]} for form in alternatives(scattering.TranslucencySettings, "form"))
    + tuple(
        {"form": form, "combine": "transmit_wrapped"} for form in alternatives(scattering.TranslucencySettings, "form")
    ),
    "lights": ([{"position": [0.0, 0.0, 5.0]}] * 2, [{"position": [0.0, 0.0, 5.0], "falloff": "inverse_square"}]),
    "irradiance_map.mode": alternatives(settings.IrradianceMap, "mode"),
    "irradiance_map.image": alternatives(settings.IrradianceMap, "image"),
}
WRAPPED = {"irradiance_map.image": "product", "translucency.combine": "transmit_wrapped"}
SOFT = {"shadow_map.test": "kernel", "irradiance_map": {"image": "product", "mode": "lambert"}}
TOGETHER = (
    WRAPPED,
    *({**SOFT, "translucency.combine": way} for way in alternatives(scattering.TranslucencySettings, "combine")),
)


def shaders_of(dialect):
    """Every shader once: (suffix, source)."""
    cases = [
        {"method": method, key: value} for method in METHODS for key, values in CHOICES.items() for value in values
    ]
    cases += [{"method": method, **together} for method in METHODS for together in TOGETHER]
    cases += [
        {"method": method, **lights} for method in TECHNIQUES for lights in ({}, {"lights.0.type": "directional"})
    ]
    cases += [{"layers": [LAYER], **lights} for lights in ({}, {"lights.0.type": "directional"})]
    methods = [method_of(settings_with(case)) for case in cases]
    files = [
        item
        for method in methods
        for lengths in ((LENGTHS, {}) if dialect.longest_array else ({},))
        for item in shader_files(method, lengths, dialect).items()
    ]
    return sorted({(name.rpartition(".")[2], source) for name, source in files})
