"""UVs for a mesh that has none: xatlas cuts its surface into charts and lays them side by side in the unit square.

Which charts those are is up to xatlas and its version, so the UVs are an input like those of a file: recorded with
their hash, not promised (rule R7). What was found for a surface is kept beside the compiled kernels.
"""

import hashlib
import os
import subprocess
import sys
from dataclasses import replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sss_ref.cache.root import cache_below
from sss_ref.errors import MeshError
from sss_ref.errors.wording import told
from sss_ref.mesh.triangles import Mesh, array_hash

TIME_LIMIT = 120  # seconds
PROCESS = Path(__file__).with_name("unwrap_process.py")
ELSEWHERE = "unwrap it in a modelling program"
UVS_KEPT = "mesh.unwrap has no effect: the file has UVs, and they are kept"


class Atlas(NamedTuple):
    """A surface cut into charts; vertices on the cuts are there once for each chart."""

    vertices: NDArray[np.int64]  # (V',): which vertex of the mesh each of them is
    triangles: NDArray[np.int32]  # (T, 3), the mesh's triangles in their order
    uvs: NDArray[np.float32]  # (V', 2), inside [0, 1]
    charts: NDArray[np.int64]  # (): how many


def unwrapped(mesh: Mesh) -> Mesh:
    """The mesh with UVs: its own if it has them, otherwise made by xatlas; the notes say which.

    Positions, normals and order of the triangles stay; so do vertices that no triangle uses, at UV 0. Raises MeshError
    where xatlas is not installed, fails, or takes longer than TIME_LIMIT.
    """
    if mesh.uvs is not None:
        return replace(mesh, notes=(*mesh.notes, UVS_KEPT))
    release = _installed_release(mesh)
    atlas = _atlas(mesh, release)
    unused = np.setdiff1d(np.arange(len(mesh.positions)), atlas.vertices)
    vertices = np.concatenate([atlas.vertices, unused])
    charts = int(atlas.charts)
    return replace(
        mesh,
        positions=mesh.positions[vertices],
        normals=mesh.normals[vertices],
        uvs=np.concatenate([atlas.uvs, np.zeros((len(unused), 2), np.float32)]),
        triangles=atlas.triangles,
        charts=charts,
        notes=(*mesh.notes, f"UVs were made by xatlas {release} ({charts} charts)"),
    )


def _installed_release(mesh: Mesh) -> str:
    try:
        return version("xatlas")
    except PackageNotFoundError:
        remedy = 'run pip install "sss_ref[unwrap]"'
        raise MeshError(told(mesh.name, "the package xatlas, which mesh.unwrap needs", "none", remedy)) from None


def _atlas(mesh: Mesh, release: str) -> Atlas:
    """The atlas that is kept for this surface; where there is none, or a damaged one, it is made anew and kept."""
    cache = cache_below("unwrapped")
    kept = cache / f"{_key(mesh, release)}.npz" if cache else None
    atlas = _read(kept, mesh) if kept else None
    if atlas is None:
        with TemporaryDirectory(dir=cache) as folder:  # in the cache, for only there a file can be renamed in one step
            made = _made(mesh, Path(folder))
            atlas = _read(made, mesh)
            if atlas is None:
                raise MeshError(told(mesh.name, "all triangles within 0 to 1 from xatlas", "others", ELSEWHERE))
            if kept:
                os.replace(made, kept)
    return atlas


def _key(mesh: Mesh, release: str) -> str:
    """A hash of all that decides an atlas: the surface, xatlas, and what it is asked for."""
    surface = [array_hash(name, getattr(mesh, name)) for name in ("positions", "triangles")]
    return hashlib.sha256("\n".join([release, *surface]).encode() + PROCESS.read_bytes()).hexdigest()


def _made(mesh: Mesh, folder: Path) -> Path:
    """The file of a fresh atlas in `folder`."""
    surface, atlas = folder / "surface.npz", folder / "atlas.npz"
    np.savez(surface, positions=mesh.positions, triangles=mesh.triangles)
    command = [sys.executable, "-P", *map(str, (PROCESS, surface, atlas))]  # -P: the files beside it are not modules
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT, check=False)
    except subprocess.TimeoutExpired:
        came = f"none after {TIME_LIMIT} seconds"
        raise MeshError(told(mesh.name, "UVs from xatlas", came, f"simplify the mesh or {ELSEWHERE}")) from None
    if done.returncode:
        reason = done.stderr.strip().rpartition("\n")[2] or f"it crashed with exit code {done.returncode}"
        raise MeshError(told(mesh.name, "UVs from xatlas", f"none ({reason})", ELSEWHERE))
    return atlas


def _read(path: Path, mesh: Mesh) -> Atlas | None:
    """The atlas of a file; None if the file is not there, damaged, or not an atlas of this mesh."""
    try:
        with np.load(path) as file:
            atlas = Atlas(*(file[name] for name in Atlas._fields))
        fits = np.array_equal(atlas.vertices[atlas.triangles], mesh.triangles)
        return atlas if fits and ((atlas.uvs >= 0) & (atlas.uvs <= 1)).all() else None
    except Exception:  # whatever a damaged file makes NumPy raise
        return None
