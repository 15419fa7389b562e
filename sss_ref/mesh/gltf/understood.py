"""Which glTF a file needs: its version, and the extensions that it cannot be read without."""

import re
from typing import Any

from sss_ref.errors.wording import shown
from sss_ref.mesh.gltf.gltf_document import GltfDocument
from sss_ref.mesh.part import refused

APPLIED = {
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_node_visibility",
    "EXT_mesh_gpu_instancing",
    "KHR_draco_mesh_compression",  # read where there is uncompressed data too; else refused at the primitive
    "EXT_meshopt_compression",  # likewise, at the buffer view
    "KHR_meshopt_compression",
}

# About how things look, sound, move or are described; the triangles are the same without them.
LOOKS = {
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_techniques_webgl",
    "KHR_texture_basisu",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "EXT_materials_bump",
    "EXT_texture_webp",
    "EXT_texture_avif",
    "EXT_texture_astc",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_instance_features",
    "EXT_structural_metadata",
    "EXT_feature_metadata",
    "ADOBE_materials_clearcoat_specular",
    "ADOBE_materials_clearcoat_tint",
    "ADOBE_materials_thin_transparency",
    "AGI_articulations",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "FB_geometry_metadata",
    "FB_ngon_encoding",
    "GODOT_single_root",
    "MSFT_lod",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
    "MSFT_texture_dds",
    "NV_materials_mdl",
    "SPB_PBR_materials",
    "VRM",
    "VRMC_materials_mtoon",
    "VRMC_springBone",
    "VRMC_vrm",
}
LOOKS_PREFIX = "KHR_materials_"

VERSION = re.compile(r"(\d{1,9})\.(\d{1,9})")


def refuse_first_version(path: object, content: dict[str, Any]) -> None:
    """Raise MeshError if a document is of glTF 1.0, whose tables are objects."""
    asset = content.get("asset")
    version = asset.get("version") if isinstance(asset, dict) else None
    if str(version).startswith(("0.", "1.")) or (version is None and isinstance(content.get("meshes"), dict)):
        raise refused(path, "glTF 2.0", f"glTF {version or '1.0'}", "convert it to glTF 2.0")


def check_understood(document: GltfDocument) -> None:
    """Raise MeshError if a document is of a later version, or needs an extension that would change the mesh."""
    asset = document.top.asset
    major, _ = _version(document, "asset.version", asset.version)
    if major != 2 or (asset.minVersion and _version(document, "asset.minVersion", asset.minVersion) > (2, 0)):
        came = f"glTF {asset.minVersion or asset.version}"
        raise refused(document.path, "glTF 2.0", came, "export it as glTF 2.0")
    for name in document.top.extensionsRequired:
        if name not in APPLIED | LOOKS and not name.startswith(LOOKS_PREFIX):
            expected = "extensions that are known here"
            raise document.refused("extensionsRequired", expected, shown(name), "export the mesh without it")


def _version(document: GltfDocument, place: str, text: str) -> tuple[int, int]:
    match = VERSION.fullmatch(text)
    if not match:
        raise document.refused(place, 'a version such as "2.0"', shown(text))
    return int(match[1]), int(match[2])
