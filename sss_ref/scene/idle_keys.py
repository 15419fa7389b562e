"""Keys that change nothing beside the others of their scene file: told, since whoever sets one means something."""

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from sss_ref.scene_file.layers import filled
from sss_ref.scene_file.settings import SceneFile

Holds = Callable[[SceneFile], bool]


class Need(NamedTuple):
    """What a key needs to have an effect: in words, and whether the scene of one of its bodies has it."""

    words: str
    holds: Holds


def _adds(scene: SceneFile) -> bool:
    """Whether light that comes through is added to what is reflected, and does not only scale it."""
    if scene.method == "texture_space":
        return scene.irradiance_map.image != "sqrt"
    return scene.translucency.combine != "multiply"


def _wraps(scene: SceneFile) -> bool:
    """Whether it goes round to the lit side."""
    return scene.translucency.combine == "transmit_wrapped" and _adds(scene)


def _blurs_by(scene: SceneFile, unit: str) -> bool:
    """Whether the blur is the paper's, with offsets in this unit."""
    return scene.method in ("screen_space", "texture_space") and scene.blur.unit == unit


def _of(*methods: str) -> Need:
    """What a key needs that these methods alone read."""
    return Need(f"method = {' or '.join(methods)}", lambda scene: scene.method in methods)


BENT = Need("mesh.normal_map", lambda scene: scene.mesh.normal_map is not None)
SOFT = Need('shadow_map.test = "kernel"', lambda scene: scene.shadow_map.test == "kernel")
SLOPED = Need('shadow_map.test = "slope" or "kernel"', lambda scene: scene.shadow_map.test in ("slope", "kernel"))
WRAPPED = Need('translucency.combine = "transmit_wrapped" (in texture space with image "product")', _wraps)
ADDED = Need('a translucency.combine other than "multiply" (in texture space image "product")', _adds)
SUMMED = Need('translucency.form = "gaussians"', lambda scene: scene.translucency.form == "gaussians")
OF_BASE = Need('a translucency.form other than "gaussians"', lambda scene: scene.translucency.form != "gaussians")
OF_POWER = Need(
    'translucency.form = "ratio" or "exponent"', lambda scene: scene.translucency.form in ("ratio", "exponent")
)
IN_PIXELS = Need('blur.unit = "pixel", in screen or texture space', lambda scene: _blurs_by(scene, "pixel"))
IN_MM = Need('blur.unit = "mm", in screen or texture space', lambda scene: _blurs_by(scene, "mm"))

NEEDS = {
    ("mesh", "normal_strength"): BENT,
    ("mesh", "normal_map_green"): BENT,
    ("shadow_map", "kernel_scale"): SOFT,
    ("shadow_map", "bias_slope"): SLOPED,
    ("shadow_map", "lookup_depth"): WRAPPED,
    ("translucency", "wrap"): WRAPPED,
    ("translucency", "scale"): ADDED,
    ("translucency", "gaussians"): SUMMED,
    ("translucency", "x"): OF_BASE,
    ("translucency", "y"): OF_POWER,
    ("translucency", "exponent"): OF_POWER,
    ("translucency", "d_min"): OF_POWER,
    ("blur", "pixel_scale"): IN_PIXELS,
    ("blur", "mm_per_offset"): IN_MM,
    ("diffusion", "profile"): _of("separable", "preintegrated", "gaussian_texture"),
    ("diffusion", "reach_mm"): _of("separable"),
    ("diffusion", "taps"): _of("separable"),
    ("diffusion", "albedo"): _of("burley"),
    ("diffusion", "mean_free_path_mm"): _of("burley"),
    ("diffusion", "samples"): _of("burley"),
    ("diffusion", "sharpest_curvature"): _of("preintegrated"),
}


def idle_keys(settings: SceneFile) -> Iterator[str]:
    """One line for every key that has another value than it has by itself, and no effect. settings: with every key."""
    given = {key: getattr(settings, key) for key in ("method", "preset", "material", "mm_per_unit")}
    usual = filled(given)
    bodies = (settings, settings.inner) if settings.inner else (settings,)
    for (table, key), need in NEEDS.items():
        tables = getattr(settings, table)
        by_itself = usual.get(table, {}).get(key, type(tables).model_fields[key].default)
        if _plain(getattr(tables, key)) != _plain(by_itself) and not any(map(need.holds, bodies)):
            yield f"{table}.{key}: it changes nothing without {need.words}; set that, or remove it"


def _plain(value: Any) -> Any:
    """A value that can be compared, whether a table or a file has it."""
    return list(map(_plain, value)) if isinstance(value, list | tuple) else value
