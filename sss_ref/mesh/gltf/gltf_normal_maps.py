"""What to set in a scene for a normal map that a glTF material names, for pictures in a mesh file are not read.

Nothing of it is needed for the mesh, so nothing is refused here: of a broken reference the note says less.
"""

from collections.abc import Iterator
from typing import Any
from urllib.parse import unquote

from sss_ref.errors.wording import shown
from sss_ref.mesh.gltf.gltf_document import GltfDocument


def normal_map_notes(document: GltfDocument, texture: Any, uv_set: int, has_tangents: bool) -> Iterator[str]:
    """The notes on a material's normalTexture. uv_set: the n of the TEXCOORD_n that the mesh is read with.

    has_tangents: whether the file has tangents for it, which are not used either.
    """
    info = texture if isinstance(texture, dict) else {}
    source = _entry(document.top.textures, info.get("index")).get("source")
    uri = _entry(document.top.images, source).get("uri")
    if isinstance(uri, str) and not uri.startswith("data:"):
        told = f"the normal map {shown(unquote(uri))} is not read by itself; set mesh.normal_map to its path"
    else:
        place = f"images[{source}]" if isinstance(source, int) else "an image"
        told = f"the normal map inside the file ({place}) is not read; save it and give it as mesh.normal_map"
    yield told + _strength(info)
    own_set = info.get("texCoord", 0)
    if own_set != uv_set:
        yield f"the normal map lies over UV set {shown(own_set)}, but the mesh is read with set {uv_set}"
    if has_tangents:
        yield "the file's tangents are not used; a normal map gets those of rule R11"


def _strength(info: dict[str, Any]) -> str:
    """What else to set where the file makes the map weaker or stronger (glTF 2.0, normalTextureInfo.scale)."""
    scale = info.get("scale", 1)
    return "" if scale == 1 or not isinstance(scale, int | float) else f" and mesh.normal_strength = {scale:g}"


def _entry(table: Any, number: Any) -> dict[str, Any]:
    """An entry of a table; an empty one where there is none."""
    is_there = isinstance(table, list) and isinstance(number, int) and 0 <= number < len(table)
    entry = table[number] if is_there else None
    return entry if isinstance(entry, dict) else {}
