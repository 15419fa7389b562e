"""The shipped scenes at a size that renders in a moment, with the reader's own head in them."""

from pathlib import Path
from typing import Any

import sss_ref
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.scene_file.shipped import find_mesh, mesh_names
from sss_ref.view.light_fit import Bounds

SHIPPED_HEAD = "bust"
BY_THE_TEXT = {  # not as preset robust: hard shadows, light from behind on the shaded side only, and the exponent
    "shadow_map.test": "slope",
    "translucency.combine": "transmit",
    "translucency.d_min": 0.1,
    "translucency.exponent": 0.6,
    "translucency.scale": 0.2,
}


def load(name: str, head: str = "", size: int = 384, **overrides: Any) -> sss_ref.Scene:
    """A shipped scene, `size` pixels wide and high, with a shadow map of twice that.

    head: a mesh to put in place of the scene's own, by path or shipped name; nothing keeps it.
    overrides: as in `sss_ref.load_scene`.
    """
    tables = {"camera": size, "shadow_map": 2 * size}
    sizes = {f"{table}.{side}": each for table, each in tables.items() for side in ("width", "height")}
    return sss_ref.load_scene(name, **(sizes | (placed(head) if head else {}) | overrides))


def placed(head: str) -> dict[str, Any]:
    """The overrides that put a mesh where the shipped head stands, as large as it is, with UVs if it has none.

    Its size matters, for d^0.6 depends on the unit of length: fitted to the same bounds, materials keep their look.
    """
    if head == SHIPPED_HEAD:
        return {"mesh.path": head}
    mesh, model = (load_mesh(_found(path)) for path in (head, SHIPPED_HEAD))
    own, wanted = (Bounds.around(each.positions.astype(float)) for each in (mesh, model))
    scale = wanted.radius / own.radius
    return {
        "mesh.path": str(_found(head).resolve()),
        "mesh.scale": scale,
        "mesh.translate": (wanted.centre - own.centre * scale).tolist(),
        "mesh.unwrap": mesh.uvs is None,
    }


def _found(path: str) -> Path:
    """The file of a mesh. Raises MeshError where there is none."""
    found = find_mesh(path, Path.cwd())
    if found is None:
        known = ", ".join(mesh_names())
        raise sss_ref.MeshError(f"HEAD: expected a mesh file or a shipped mesh ({known}), got {path!r}; check the path")
    return found
