"""The memory that a rendering takes, known from the scene file alone, before any work.

Counted is what lasts: every buffer of the method, as keep="all" holds them, and the decoded texture. What a pass needs
while it runs comes on top, at most half as much again.
"""

from collections import Counter
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from sss_ref.errors.wording import KeyPath, unmet_at
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.scene.catalogue import method_of
from sss_ref.scene_file import scattering, settings, viewpoints
from sss_ref.scene_file.presets import PRESETS

MEMORY_LIMIT = 4 * 2**30  # bytes
DECIDE = {"translucency": ["combine"], "blur": ["unit"], "irradiance_map": ["image"]}  # which buffers there are
TEXTURE_BYTES = 12  # per texel: linear RGB, float32


def bytes_per_pixel(tables: Mapping[str, Any]) -> Mapping[str, int]:
    """Scene table -> bytes of all buffers that have its size, as keep="all" holds them, for one pixel or texel.

    tables: key of the scene file -> validated value, as in `check_memory`; what is missing counts as its default.
    """
    return _counted(_plainest(tables))


@lru_cache(maxsize=64)  # for many scenes of one kind
def _counted(plainest: settings.SceneFile) -> Mapping[str, int]:
    counted = Counter[str]()
    for each in method_of(plainest).passes:
        kinds = [] if each.on_demand else each.outputs.values()
        counted[each.target] += sum(CHANNELS[kind] * dtype_of(kind).itemsize for kind in kinds)
    return counted


def check_memory(tables: Mapping[str, Any], pictures: Mapping[KeyPath, tuple[int, int]]) -> None:
    """Raise an error under the key that takes most if all buffers and pictures need more than MEMORY_LIMIT.

    tables: key of the scene file -> validated value; a table that is wrong, and so not there, counts nothing.
    pictures: key -> width and height in texels.
    """
    lights = len(tables.get("lights", "1"))
    counted = bytes_per_pixel(tables)
    sized = {name: tables[name] for name in counted if name in tables}
    needed: dict[KeyPath, int] = {(name,): counted[name] * each.width * each.height for name, each in sized.items()}
    needed |= {key: TEXTURE_BYTES * width * height for key, (width, height) in pictures.items()}
    total = sum(needed.values())
    if total > MEMORY_LIMIT:
        largest = max(needed, key=lambda key: needed[key])
        fewer = " or use fewer lights" if lights > 1 else ""
        remedy = "scale the picture down" if len(largest) > 1 else f"make width and height smaller{fewer}"
        came = f"{_gibibytes(total)}, {_gibibytes(needed[largest])} of them here"
        raise unmet_at(largest, "at most 4 GiB of buffers and textures", came, remedy)


def _plainest(tables: Mapping[str, Any]) -> settings.SceneFile:
    """Settings with what decides which buffers there are, and all else as the preset has it."""
    chosen = tables.get("preset", "paper")
    preset = {name: dict(PRESETS[chosen][name]) for name in DECIDE}
    for name in DECIDE.keys() & tables.keys() if chosen != "published" else ():
        preset[name] |= {key: getattr(tables[name], key) for key in DECIDE[name]}
    if "translucency" in tables:
        preset["translucency"]["scale"] = (1.0,) * 3 if tables["translucency"].by_channel else 1.0
    soft = "shadow_map" in tables and tables["shadow_map"].test == "kernel"
    return settings.SceneFile.model_construct(
        method=tables.get("method", "screen_space"),
        preset=chosen,
        mesh=tables.get("mesh", settings.MeshSettings.model_construct(path="")),
        layers=tables.get("layers", ()),
        camera=viewpoints.OrbitCamera.model_construct(type="orbit"),
        lights=(viewpoints.PointLight.model_construct(),) * len(tables.get("lights", "1")),
        shadow_map=settings.ShadowMap(test="kernel" if soft else "slope"),
        translucency=scattering.TranslucencySettings.model_construct(**preset["translucency"]),
        blur=scattering.Blur.model_construct(**preset["blur"]),
        irradiance_map=settings.IrradianceMap.model_construct(**preset["irradiance_map"]),
    )


def _gibibytes(size: int) -> str:
    return f"{size / 2**30:.2f} GiB"
