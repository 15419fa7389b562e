"""Times a warm rendering, every buffer kept: python benchmarks/render.py --size 1024 --triangles 100000.

Prints per pass the median and the fastest of several renderings, in milliseconds.
"""

import argparse
import os
import statistics
import tempfile
import time
from pathlib import Path

import numpy as np

import sss_ref


def bumpy_sphere(triangles: int) -> str:
    """An OBJ of a sphere with gentle bumps and UVs, about as many triangles as asked."""
    rows = round((triangles / 4) ** 0.5)
    polar, around = np.meshgrid(np.linspace(0, np.pi, rows + 1), np.linspace(0, 2 * np.pi, 2 * rows + 1), indexing="ij")
    radius = 1 + 0.1 * np.sin(5 * around) * np.sin(polar) * np.sin(4 * polar)
    x, y, z = radius * np.sin(polar) * np.sin(around), radius * np.cos(polar), radius * np.sin(polar) * np.cos(around)
    lines = [f"v {a:.6f} {b:.6f} {c:.6f}" for a, b, c in zip(x.flat, y.flat, z.flat, strict=True)]
    lines += [f"vt {u:.6f} {v:.6f}" for u, v in zip((around / (2 * np.pi)).flat, (1 - polar / np.pi).flat, strict=True)]
    wide = 2 * rows + 1
    for row in range(rows):
        for column in range(2 * rows):
            a = row * wide + column + 1
            if row > 0:
                lines.append(face(a, a + wide, a + 1))
            if row < rows - 1:
                lines.append(face(a + 1, a + wide, a + wide + 1))
    return "\n".join(lines) + "\n"


def face(*vertices: int) -> str:
    """A line of an OBJ: a triangle whose corners have a position and a UV of the same number."""
    return "f " + " ".join(f"{vertex}/{vertex}" for vertex in vertices)


def main() -> None:
    """Render once to compile, then `--runs` times."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--triangles", type=int, default=100_000)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--runs", type=int, default=9)
    parser.add_argument("--preset", default="paper")
    parser.add_argument("--mesh", help="a mesh file instead of the sphere")
    parser.add_argument("--distance", type=float, default=2.9)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(asked.mesh) if asked.mesh else Path(folder) / "sphere.obj"
        if not asked.mesh:
            path.write_text(bumpy_sphere(asked.triangles))
        camera = {"type": "orbit", "distance": asked.distance, "width": asked.size, "height": asked.size}
        light = {"position": [2.0 * asked.distance, asked.distance, asked.distance]}
        document = {"preset": asked.preset, "mesh": {"path": str(path)}, "camera": camera, "lights": [light]}
        scene = sss_ref.load_scene(document)
        result = sss_ref.render(scene, threads=asked.threads)
        runs, walls = [], []
        for _ in range(asked.runs):
            start = time.perf_counter()
            result = sss_ref.render(scene, threads=asked.threads)
            walls.append(time.perf_counter() - start)
            runs.append(result.timings)
    covered = float(result["coverage"].mean())
    print(f"{len(scene.mesh.triangles)} triangles, {asked.size}^2, {covered:.0%} covered")
    print(f"{asked.threads} threads, {asked.runs} runs")
    for name in runs[0]:
        times = [1e3 * run[name] for run in runs]
        print(f"  {name:12s} median {statistics.median(times):7.1f} ms   fastest {min(times):7.1f} ms")
    print(f"  {'total':12s} median {1e3 * statistics.median(walls):7.1f} ms   fastest {1e3 * min(walls):7.1f} ms")


if __name__ == "__main__":
    main()
