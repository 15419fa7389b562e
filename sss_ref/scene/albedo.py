"""The colour of a scene's surface: one for all, one per material of the mesh file, or a texture."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.mesh.triangles import Mesh
from sss_ref.scene_file.color_texture import load_texture
from sss_ref.scene_file.settings import MeshSettings


def albedo_of(settings: MeshSettings, mesh: Mesh, folder: Path) -> dict[str, NDArray[Any]]:
    """The uniforms of the stage that computes the albedo, by name, as the `settings` of the mesh ask for it.

    `mesh_color` is float32 (3,), `albedo_map` float32 (H, W, 3) with row 0 at the bottom, `material_color` float32
    (M, 3), with `triangle_material`, int32 (T,). All are linear RGB. folder: where the picture is.
    Raises SceneError where the mesh or the picture does not allow it.
    """
    if settings.albedo == "texture":
        if mesh.uvs is None:
            remedy = "give the mesh it was painted for, or set mesh.unwrap = true if any UVs will do"
            raise SceneError(f"expected a mesh with UVs, got {mesh.name} without; {remedy}")
        return {"albedo_map": load_texture(folder / str(settings.texture))}
    if settings.albedo == "material":
        return {"material_color": _material_colors(mesh), "triangle_material": mesh.material}
    return {"mesh_color": np.array(settings.color, np.float32)}


def albedo_warnings(settings: MeshSettings, mesh: Mesh) -> list[str]:
    """What a user who asks for the file's colours may miss in the picture, and what a texture may look like."""
    if settings.texture is not None and mesh.charts:
        return ["mesh: the texture follows UVs that mesh.unwrap made, not those it was painted for"]
    named = [material.name for material in mesh.materials if material.textured]
    if settings.albedo != "material" or not named:
        return []
    return [f"mesh: textures inside the file are not read (of {', '.join(named)}); give one as mesh.texture"]


def _material_colors(mesh: Mesh) -> NDArray[np.float32]:
    missing = [number for number, material in enumerate(mesh.materials) if material.color is None]
    if missing:
        bare = int(np.isin(mesh.material, missing).sum())
        raise SceneError(
            f"expected a material with a colour for every triangle, got {bare} of {len(mesh.material)} without; "
            "give mesh.color as RGB, or put the material file beside the mesh"
        )
    return np.array([material.color for material in mesh.materials], np.float32)
