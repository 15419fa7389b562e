"""The shaders of every alternative of a scene file, in any dialect."""

from functools import cache

from alternatives import LAYER, alternatives
from scenes import settings_with

from sss_ref.interpret.shader.passes import draws, fragment_shader, vertex_shader
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


CASES = [
    *({"method": method, key: value} for method in METHODS for key, values in CHOICES.items() for value in values),
    *({"method": method, **together} for method in METHODS for together in TOGETHER),
    *({"method": method, **lights} for method in TECHNIQUES for lights in ({}, {"lights.0.type": "directional"})),
    *({"layers": [LAYER], **lights} for lights in ({}, {"lights.0.type": "directional"})),
]


def shaders_of(dialect):
    """Every shader once: (suffix, source)."""
    all_lengths = (LENGTHS, {}) if dialect.longest_array else ({},)
    return sorted(
        {
            shader
            for this_pass, there in passes_in_place()
            for lengths in all_lengths
            for shader in shaders_of_pass(this_pass, there, lengths, dialect)
        }
    )


def shaders_of_pass(this_pass, there, lengths, dialect):
    """(suffix, source) of each as `shader_files` has them."""
    yield "vert", vertex_shader(this_pass, lengths, dialect)
    for outputs in draws(this_pass, this_pass.outputs, dialect).values():
        yield "frag", fragment_shader(this_pass, there, outputs, lengths, dialect)


@cache
def passes_in_place():
    """Every pass of the cases once, and the names of the buffers that are there before it: most cases share most."""
    found = {}
    for case in CASES:
        there = frozenset()
        for this_pass in method_of(settings_with(case)).passes:
            found.setdefault((told(this_pass), there), (this_pass, there))
            there |= set(this_pass.outputs)
    return [*found.values()]


def told(this_pass):
    """A pass in words: its stages with names and types, what it draws and keeps."""
    draw = this_pass.draw
    stages = [
        (stage.name, stage.reads, stage.writes, stage.parameters, stage.outputs)
        for stage in (*draw.vertex_stages, *this_pass.stages)
    ]
    drawn = [type(draw), *(value for name, value in vars(draw).items() if name != "vertex")]
    return str((this_pass.name, drawn, draw.varyings, stages, this_pass.registers))
