"""Write a shipped mesh and print the figures that PROVENANCE.md records. For generation only."""

import hashlib
from pathlib import Path

import trimesh
from bust import decoded


def write(mesh: trimesh.Trimesh, path: Path) -> None:
    """Write a GLB file with its stored normals; print its triangles, size, and hashes of file and decoded arrays."""
    mesh.export(path, include_normals=True)
    size, triangles = path.stat().st_size, len(mesh.faces)
    print(f"{path.name} {triangles} triangles {size} bytes {hashlib.sha256(path.read_bytes()).hexdigest()}")
    for name, array in decoded(path).items():
        print(f"  {name} {array.dtype.str} {array.shape} {hashlib.sha256(array.tobytes()).hexdigest()}")
