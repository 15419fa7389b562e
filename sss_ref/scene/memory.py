"""The memory that a rendering takes, known from the scene file alone, before any work.

Counted is what lasts: every buffer of the method, as keep="all" holds them, and the decoded texture (preset `published`
has a few buffers less). What a pass needs while it runs comes on top, at most half as much again.
"""

from collections.abc import Mapping
from typing import Any

from sss_ref.errors.wording import KeyPath, unmet_at

MEMORY_LIMIT = 4 * 2**30  # bytes
TEXTURE_BYTES = 12  # per texel: linear RGB, float32

# Bytes per pixel or texel, by method and by the table with the size: of the buffers that there are once, and of those
# that each light has for itself.
BUFFER_BYTES = {
    "screen_space": {"camera": (89, 58), "shadow_map": (0, 12)},
    "texture_space": {"camera": (77, 66), "shadow_map": (0, 20), "irradiance_map": (1, 37)},
}
PHONG_SUM_BYTES = 12  # per pixel: several lights have a `phong` each, and one together


def bytes_per_pixel(method: str, table: str, lights: int) -> int:
    """Bytes of all buffers that have the size of a table ("camera", "shadow_map" ...), for one pixel or texel."""
    once, each = BUFFER_BYTES[method][table]
    return once + each * lights + (PHONG_SUM_BYTES if table == "camera" and lights > 1 else 0)


def check_memory(tables: Mapping[str, Any], texture_size: tuple[int, int]) -> None:
    """Raise an error under the key that takes most if all buffers and the texture need more than MEMORY_LIMIT.

    tables: key of the scene file -> validated value; a table that is wrong, and so not there, counts nothing.
    texture_size: width and height in texels.
    """
    method, lights = tables.get("method", "screen_space"), len(tables.get("lights", "1"))
    sized = {name: tables[name] for name in BUFFER_BYTES[method] if name in tables}
    needed: dict[KeyPath, int] = {
        (name,): bytes_per_pixel(method, name, lights) * t.width * t.height for name, t in sized.items()
    }
    needed["mesh", "texture"] = TEXTURE_BYTES * texture_size[0] * texture_size[1]
    total, largest = sum(needed.values()), max(needed, key=lambda key: needed[key])
    if total > MEMORY_LIMIT:
        fewer = " or use fewer lights" if lights > 1 else ""
        remedy = "scale the picture down" if len(largest) > 1 else f"make width and height smaller{fewer}"
        came = f"{_gibibytes(total)}, {_gibibytes(needed[largest])} of them here"
        raise unmet_at(largest, "at most 4 GiB of buffers and textures", came, remedy)


def _gibibytes(size: int) -> str:
    return f"{size / 2**30:.2f} GiB"
