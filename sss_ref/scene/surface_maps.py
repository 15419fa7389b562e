"""The pictures of a scene's surface that are no colours: its normal map and its specular map."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.mesh.triangles import Mesh
from sss_ref.scene_file.linear_texture import load_linear

FloatArray = NDArray[np.float32]


def normal_map_of(mesh: Mesh, path: Path) -> FloatArray:
    """The texels of a normal map, from 0 to 1, float32 (H, W, 3), row 0 at the bottom.

    Raises SceneError for a picture that cannot be read, for one without a texel that points outwards, as no normal map
    is, and for a mesh without UVs.
    """
    texels = _laid_over(mesh, path)
    if texels[..., 2].max() <= 0.5:
        raise SceneError(f"expected a normal map, whose blue is above a half, got {path.name}; check the picture")
    return texels


def specular_map_of(mesh: Mesh, path: Path) -> FloatArray:
    """The texels of a specular map, as above, its channels all alike. Raises SceneError, also for a coloured one."""
    texels = _laid_over(mesh, path)
    if (texels != texels[..., :1]).any():
        raise SceneError(f"expected a grey picture, got {path.name} with colours; save it as grey")
    return texels


def _laid_over(mesh: Mesh, path: Path) -> FloatArray:
    if mesh.uvs is None:
        remedy = "give the mesh it was made for, or set mesh.unwrap = true if any UVs will do"
        raise SceneError(f"expected a mesh with UVs, got {mesh.name} without; {remedy}")
    return load_linear(path)
