"""The scenes and meshes that come with the package, found by name."""

import os
from pathlib import Path

from sss_ref.errors import SceneError
from sss_ref.errors.wording import told

PACKAGE = Path(__file__).parents[1]
MESH_SUFFIXES = (".obj", ".ply", ".stl", ".off", ".glb", ".gltf")


def data_folder() -> Path:
    """Where the shipped files are: inside the installed package, or beside it in a checkout."""
    installed = PACKAGE / "data"
    return installed if installed.is_dir() else PACKAGE.parent / "data"


def scene_names() -> tuple[str, ...]:
    """The names of the shipped scenes, sorted."""
    return tuple(sorted(path.stem for path in (data_folder() / "scenes").glob("*.toml")))


def mesh_names() -> tuple[str, ...]:
    """The names of the shipped meshes, sorted."""
    return tuple(sorted(path.stem for path in (data_folder() / "meshes").glob("*") if path.suffix in MESH_SUFFIXES))


def scene_path(name: str) -> Path:
    """The file of a shipped scene. Raises SceneError for another name."""
    if name not in scene_names():
        raise SceneError(f"{name}: expected a shipped scene ({', '.join(scene_names())}), got another name")
    return data_folder() / "scenes" / f"{name}.toml"


def mesh_path(name: str) -> Path:
    """The file of a shipped mesh. Raises SceneError for another name."""
    found = _shipped_mesh(name)
    if found is None:
        raise SceneError(f"{name}: expected a shipped mesh ({', '.join(mesh_names())}), got another name")
    return found


def find_mesh(path: str, folder: Path) -> Path | None:
    """The mesh that a scene in `folder` means by `path`; None if there is none.

    A file there, or a bundle's folder of arrays (see `sss_ref.mesh.array_folder`), or else a shipped mesh.
    """
    if any(map(os.path.isfile, (folder / path, folder / path / "mesh.json"))):  # unlike Path.is_file it takes any text
        return folder / path
    return _shipped_mesh(path)


def given_mesh(name: str) -> Path:
    """The file of the mesh that a command is given: one there, or else a shipped one.

    Raises SceneError for a name without suffix that is neither; what else cannot be read its reader will say.
    """
    path = find_mesh(name, Path())
    if path is None and not Path(name).suffix and not os.path.exists(name):
        remedy = f"choose one ({', '.join(mesh_names())})"
        raise SceneError(told(name or '""', "a mesh file or a shipped mesh's name", "neither", remedy))
    return path or Path(name)


def _shipped_mesh(name: str) -> Path | None:
    """The file of a shipped mesh, None for another name; the folder is not listed, which many scenes would wait for."""
    folder = data_folder() / "meshes"
    files = (folder / f"{name}{suffix}" for suffix in MESH_SUFFIXES)
    return next((file for file in files if file.stem == name and os.path.isfile(file)), None)
