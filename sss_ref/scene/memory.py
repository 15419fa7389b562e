"""The memory that a rendering takes, known from the scene file alone, before any work.

Counted is what lasts: every buffer of the method, as keep="all" holds them, and the decoded texture. What a pass needs
while it runs comes on top, at most half as much again.
"""

from collections import Counter
from collections.abc import Mapping
from typing import Any

from sss_ref.errors.wording import KeyPath, unmet_at
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.scene.catalogue import method_of
from sss_ref.scene_file import settings, viewpoints
from sss_ref.scene_file.presets import PRESETS

MEMORY_LIMIT = 4 * 2**30  # bytes
TEXTURE_BYTES = 12  # per texel: linear RGB, float32


def bytes_per_pixel(method: str, preset: str, lights: int) -> Mapping[str, int]:
    """Scene table -> bytes of all buffers that have its size, as keep="all" holds them, for one pixel or texel.

    No other key of a scene file changes which buffers there are.
    """
    counted = Counter[str]()
    for each in method_of(_plainest(method, preset, lights)).passes:
        kinds = [] if each.on_demand else each.outputs.values()
        counted[each.target] += sum(CHANNELS[kind] * dtype_of(kind).itemsize for kind in kinds)
    return counted


def check_memory(tables: Mapping[str, Any], texture_size: tuple[int, int]) -> None:
    """Raise an error under the key that takes most if all buffers and the texture need more than MEMORY_LIMIT.

    tables: key of the scene file -> validated value; a table that is wrong, and so not there, counts nothing.
    texture_size: width and height in texels.
    """
    lights = len(tables.get("lights", "1"))
    counted = bytes_per_pixel(tables.get("method", "screen_space"), tables.get("preset", "paper"), lights)
    sized = {name: tables[name] for name in counted if name in tables}
    needed: dict[KeyPath, int] = {(name,): counted[name] * each.width * each.height for name, each in sized.items()}
    needed["mesh", "texture"] = TEXTURE_BYTES * texture_size[0] * texture_size[1]
    total, largest = sum(needed.values()), max(needed, key=lambda key: needed[key])
    if total > MEMORY_LIMIT:
        fewer = " or use fewer lights" if lights > 1 else ""
        remedy = "scale the picture down" if len(largest) > 1 else f"make width and height smaller{fewer}"
        came = f"{_gibibytes(total)}, {_gibibytes(needed[largest])} of them here"
        raise unmet_at(largest, "at most 4 GiB of buffers and textures", came, remedy)


def _plainest(method: str, preset: str, lights: int) -> settings.SceneFile:
    """Settings that choose these three and leave all else to the preset."""
    chosen = {name: PRESETS[preset][name] for name in ("translucency", "blur", "irradiance_map")}
    return settings.SceneFile.model_construct(
        method=method,
        preset=preset,
        mesh=settings.MeshSettings.model_construct(path=""),
        lights=(viewpoints.LightSettings.model_construct(),) * lights,
        translucency=settings.TranslucencySettings.model_construct(**chosen["translucency"]),
        blur=settings.Blur.model_construct(**chosen["blur"]),
        irradiance_map=settings.IrradianceMap.model_construct(**chosen["irradiance_map"]),
    )


def _gibibytes(size: int) -> str:
    return f"{size / 2**30:.2f} GiB"
