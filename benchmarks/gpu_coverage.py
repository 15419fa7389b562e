"""Compares which pixels show which triangles with what OpenGL and WebGL draw: python benchmarks/gpu_coverage.py.

Shipped scenes and, below --meshes, every mesh file; each as its scene shows it, with the near plane through its middle,
and from inside. Three targets at a time: the camera's view, the light's and, with UVs, their layout. One row per view
and device: covered pixels, then how many are covered in only one of the two, and how many show another triangle.
"""

import argparse
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref import gl, webgl
from sss_ref.errors import MeshError, SceneError
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.shipped import scene_names

Buffers = Mapping[str, np.ndarray]
DEVICES: dict[str, tuple[int, Callable[[Scene, list[str]], Buffers]]] = {  # name -> subpixel bits, what draws
    "opengl": (8, lambda scene, names: gl.draw(scene)),
    "webgl": (4, webgl.draw),
}
SUFFIXES = {".obj", ".ply", ".stl", ".off", ".glb", ".gltf"}
LAYOUT = "irradiance_mask"


def around(path: Path) -> dict[str, Any]:
    """A scene that sees a mesh file as a whole."""
    mesh = load_mesh(path)
    low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
    centre, radius = ((low + high) / 2).tolist(), float(np.linalg.norm(high - low)) / 2
    camera = {"type": "orbit", "target": centre, "distance": 3 * radius, "azimuth": 25.0, "elevation": 15.0}
    light = [c + radius * offset for c, offset in zip(centre, (2.0, 1.5, 2.5), strict=True)]
    return {
        "method": "screen_space" if mesh.uvs is None else "texture_space",
        "mesh": {"path": str(path)},
        "camera": camera | {"near": 0.01 * radius, "far": 10 * radius},
        "lights": [{"position": light}],
    }


def views(scene: Any, sizes: Mapping[str, int]) -> Iterator[tuple[str, Scene]]:
    """A scene as it is, cut by its near plane, and seen from inside."""
    whole = load_scene(scene, **sizes)
    yield "whole", whole
    camera = whole.settings.camera
    if camera.type == "orbit":
        yield "near", load_scene(scene, **sizes, **{"camera.near": 0.97 * camera.distance, "camera.fov_y": 20.0})
        inside = {"camera.distance": 0.05 * camera.distance, "camera.near": 0.01 * camera.distance}
        yield "inside", load_scene(scene, **sizes, **inside)


def compared(got: Buffers, expected: Buffers) -> tuple[int, int, int]:
    """Covered pixels; those covered in only one of the two; those that show another triangle."""
    covered = {name: buffer > (0 if name == LAYOUT else -1) for name, buffer in expected.items()}
    apart = {name: mask != (got[name] > (0 if name == LAYOUT else -1)) for name, mask in covered.items()}
    other = sum(int((got[name] != expected[name]).sum()) for name in expected if name != LAYOUT)
    return sum(int(mask.sum()) for mask in covered.values()), sum(int(mask.sum()) for mask in apart.values()), other


def main() -> None:
    """Draw, compare and print, row by row."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--meshes", type=Path, help="a folder of mesh files, those in its folders too")
    parser.add_argument("--devices", nargs="+", default=list(DEVICES), choices=DEVICES)
    asked = parser.parse_args()
    sizes = {
        f"{table}.{side}": asked.size
        for table in ("camera", "shadow_map", "irradiance_map")
        for side in ("width", "height")
    }
    paths = sorted(path for path in asked.meshes.rglob("*") if path.suffix in SUFFIXES) if asked.meshes else []
    for source in [*scene_names(), *paths]:
        try:
            for view, scene in views(source if isinstance(source, str) else around(source), sizes):
                names = [n for n in scene.method.outputs if "triangle" in n or n == LAYOUT]
                for device in asked.devices:
                    bits, draw = DEVICES[device]
                    got = draw(scene, names)
                    row = compared(got, render(scene, keep=names, subpixel_bits=bits).buffers)
                    name = source if isinstance(source, str) else source.name
                    print(f"{name:32s} {view:7s} {device:7s} {row[0]:8d} {row[1]:4d} {row[2]:5d}", flush=True)
        except (MeshError, SceneError) as error:
            print(f"{source}: not drawn: {str(error).splitlines()[0][:120]}", flush=True)


if __name__ == "__main__":
    main()
