"""Meshes that were read a moment ago, given again while the file and all that it refers to are as they were."""

from dataclasses import fields, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from sss_ref.cache.recent import Recent, file_hash
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.mesh.triangles import Mesh
from sss_ref.mesh.untrusted import References, referred_to, unchanged


class Kept(NamedTuple):
    """A mesh, and how the files were that it was read with."""

    mesh: Mesh
    references: References


MESHES: Recent[Kept] = Recent()


def recent_mesh(path: Path) -> Mesh:
    """The mesh of a file, as `load_mesh` gives it, with arrays of its own; raises MeshError as that does."""
    key = str(path.absolute()), file_hash(path)
    kept = MESHES.get(key)
    if kept and unchanged(path, kept.references):
        return _copied(kept.mesh)
    with referred_to() as references:
        mesh = load_mesh(path)
    if None not in key and file_hash(path) == key[1]:
        MESHES.keep(key, Kept(_copied(mesh), references), sum(array.nbytes for array in _arrays(mesh).values()))
    return mesh


def _copied(mesh: Mesh) -> Mesh:
    copies: dict[str, Any] = {name: array.copy() for name, array in _arrays(mesh).items()}
    return replace(mesh, **copies)


def _arrays(mesh: Mesh) -> dict[str, np.ndarray]:
    named = ((field.name, getattr(mesh, field.name)) for field in fields(mesh))
    return {name: value for name, value in named if isinstance(value, np.ndarray)}
