"""Reads folders of other people's files and asks other programs what they hold: python benchmarks/corpus.py FOLDER...

Meshes are held against trimesh, and against MeshLab (pymeshlab) and assimp (pyassimp) where they are installed; dumped
pictures against OpenImageIO and imageio. Each file has a process of its own, with a limit of time and of memory. Of a
mesh the number of triangles, area, volume and box are compared, of a picture the least, the largest and the mean value
of each channel. The table has a row for each suffix; below it stands what was refused, with which sentence, and what
disagrees. That another program reads a file otherwise does not say which of the two is right.
"""

import argparse
import json
import resource
import subprocess
import sys
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.dump.files import READERS as PICTURES
from sss_ref.dump.files import parts_of
from sss_ref.errors import SssRefError
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.scene_file.shipped import MESH_SUFFIXES

Facts = list[float]
TOLERANCE = 1e-4  # of a mesh's size, and of a picture's largest value
OURS = "sss_ref"
STATES = ("agrees", "alone", "refused", "differs", "broken")


def main() -> None:
    """Read all files and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=Path, help="with files at any depth")
    parser.add_argument("--seconds", type=float, default=120, help="for each file, all programs together")
    parser.add_argument("--gigabytes", type=float, default=8, help="of memory for each file")
    parser.add_argument("--one", type=Path, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        tell(given.one)
        return
    found = {path: asked(path, given.seconds, given.gigabytes) for path in files(given.folders)}
    print("\n".join([*table(found), "", *remarks(found)]))


def files(folders: list[Path]) -> list[Path]:
    """All meshes and pictures below the folders, in the order of their names."""
    known = {*MESH_SUFFIXES, *PICTURES}
    return sorted(path for folder in folders for path in folder.rglob("*") if path.suffix.lower() in known)


def asked(path: Path, seconds: float, gigabytes: float) -> dict[str, Any]:
    """Program -> facts, or a sentence where it has none; a process that ends early leaves out those that follow."""
    limit = int(gigabytes * 2**30)
    command = [sys.executable, __file__, "--one", str(path)]
    with subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
    ) as process:
        try:
            text, _ = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            text, _ = process.communicate()
    lines = [line.removeprefix("CORPUS ") for line in text.splitlines() if line.startswith("CORPUS ")]
    return dict(json.loads(line) for line in lines)


def tell(path: Path) -> None:
    """Print what each program says of a file, one line each as soon as it is known."""
    readers = MESH_READERS if path.suffix.lower() in MESH_SUFFIXES else PICTURE_READERS
    for name, read in readers.items():
        try:
            with np.errstate(all="ignore"):
                answer: Any = [float(fact) for fact in read(path)]
        except ImportError:
            continue
        except SssRefError as error:
            answer = str(error).replace(f"{path.parent}/", "")
        except Exception as error:  # another program's own words
            answer = f"{type(error).__name__}"
        print("CORPUS", json.dumps([name, answer]), flush=True)


def measured(corners: np.ndarray) -> Facts:
    """Number, area and volume of triangles (T, 3, 3), and their box; the volume is taken about the box's middle."""
    corners = np.asarray(corners, np.float64)
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    a, b, c = np.moveaxis(corners - (low + high) / 2, 1, 0)
    normals = np.cross(b - a, c - a)
    area, volume = np.sqrt((normals**2).sum(axis=1)).sum() / 2, (a * normals).sum() / 6
    return [len(corners), area, volume, *low, *high]


def ours_of_mesh(path: Path) -> Facts:
    """What the package reads."""
    mesh = load_mesh(path)
    return measured(mesh.positions[mesh.triangles])


def trimeshs(path: Path) -> Facts:
    """What trimesh reads."""
    import trimesh

    mesh = trimesh.load_scene(path, process=False).to_mesh()
    return measured(mesh.vertices[mesh.faces])


def meshlabs(path: Path) -> Facts:
    """What MeshLab reads, all layers."""
    import pymeshlab

    layers = pymeshlab.MeshSet()
    layers.load_new_mesh(str(path))
    meshes = [layer for layer in layers if layer.face_number()]
    return measured(np.concatenate([mesh.transformed_vertex_matrix()[mesh.face_matrix()] for mesh in meshes]))


def assimps(path: Path) -> Facts:
    """What assimp reads, triangulated, nodes applied."""
    import pyassimp
    from pyassimp.postprocess import aiProcess_PreTransformVertices, aiProcess_Triangulate

    with pyassimp.load(str(path), processing=aiProcess_Triangulate | aiProcess_PreTransformVertices) as scene:
        return measured(np.concatenate([mesh.vertices[mesh.faces] for mesh in scene.meshes]))


def ranged(channels: list[np.ndarray]) -> Facts:
    """Least, largest and mean of each channel, sorted, since programs order channels in their own ways."""
    rows = sorted([float(each.min()), float(each.max()), float(each.mean())] for each in channels)
    return [fact for row in rows for fact in row]


def ours_of_picture(path: Path) -> Facts:
    """What the package reads of the first part."""
    parts = parts_of(path)
    first = [part for part in parts if part.part == parts[0].part]
    return ranged([part.data[..., k].astype(np.float64) for part in first for k in range(part.data.shape[2])])


def open_image_ios(path: Path) -> Facts:
    """What OpenImageIO reads, in the type of the file."""
    import OpenImageIO

    picture = OpenImageIO.ImageInput.open(str(path))
    data = picture.read_image(OpenImageIO.TypeUnknown).astype(np.float64)
    return ranged([data[..., k] for k in range(data.shape[2])])


def imageios(path: Path) -> Facts:
    """What imageio reads."""
    import imageio.v3

    data = np.atleast_3d(imageio.v3.imread(path).astype(np.float64))
    return ranged([data[..., k] for k in range(data.shape[2])])


Readers = dict[str, Callable[[Path], Facts]]
MESH_READERS: Readers = {OURS: ours_of_mesh, "trimesh": trimeshs, "MeshLab": meshlabs, "assimp": assimps}
PICTURE_READERS: Readers = {OURS: ours_of_picture, "OpenImageIO": open_image_ios, "imageio": imageios}


def differences(ours: Facts, other: Facts) -> str:
    """What two programs say otherwise, empty if they agree."""
    if len(ours) != len(other):
        return f"{len(other)} numbers for {len(ours)}"
    size = max(1e-30, *(abs(fact) for fact in ours[1:]))
    far = [k for k in range(len(ours)) if not abs(ours[k] - other[k]) <= TOLERANCE * size]
    return ", ".join(f"{other[k]:.6g} for {ours[k]:.6g}" for k in far[:3])


def state(answers: dict[str, Any]) -> str:
    """Which of STATES a file is in: "alone" where no other program reads it, "broken" where ours said nothing."""
    ours = answers.get(OURS)
    if not isinstance(ours, list):
        return "broken" if ours is None or "; " not in ours else "refused"
    others = [answer for name, answer in answers.items() if name != OURS and isinstance(answer, list)]
    if not others:
        return "alone"
    return "agrees" if any(not differences(ours, other) for other in others) else "differs"


def table(found: dict[Path, dict[str, Any]]) -> Iterator[str]:
    """Suffix by suffix, how many files are in which state; a file agrees if one other program reads it so."""
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for path, answers in found.items():
        counts[path.suffix.lower()][state(answers)] += 1
    yield f"{'suffix':8}{'files':>7}" + "".join(f"{name:>9}" for name in STATES)
    for suffix in sorted(counts):
        row = counts[suffix]
        yield f"{suffix:8}{sum(row.values()):7}" + "".join(f"{row[name]:9}" for name in STATES)


def remarks(found: dict[Path, dict[str, Any]]) -> Iterator[str]:
    """A line for each file that is refused or broken, and for each program that reads one otherwise."""
    for path, answers in found.items():
        ours = answers.get(OURS, "no answer within the limits")
        if not isinstance(ours, list):
            yield f"{state(answers)}: {ours if isinstance(ours, str) and path.name in ours else f'{path.name}: {ours}'}"
            continue
        for name, answer in answers.items():
            if name != OURS and isinstance(answer, list) and differences(ours, answer):
                yield f"{name} has in {path.name} {differences(ours, answer)}"


if __name__ == "__main__":
    main()
