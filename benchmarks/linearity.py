"""Shows that time grows as pixels and triangles do, and what a second thread saves: python benchmarks/linearity.py.

The image alone of a bumpy sphere, all maps of the picture's size. Processor time of one thread, the least of several
renderings, and the straight line through them by least squares of the relative error; for the threads the time that
passes, both in turns. Sizes and numbers of triangles can be given.
"""

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from opengl import document
from render import bumpy_sphere

import sss_ref
from sss_ref.scene.scene import Scene

METHODS = ("screen_space", "texture_space")


def main() -> None:
    """Both lines and the threads, of both methods."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", type=int, nargs="+", default=[512, 1024, 2048, 4096])
    parser.add_argument("--triangles", type=int, nargs="+", default=[10_000, 100_000, 500_000, 2_000_000])
    parser.add_argument("--size", type=int, default=1024, help="while the triangles change")
    parser.add_argument("--preset", default="paper")
    parser.add_argument("--runs", type=int, default=3)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        meshes = {count: written(Path(folder), count) for count in sorted({100_000, *asked.triangles})}
        for method in METHODS:
            print(f"{method}, preset {asked.preset}, the image alone", flush=True)
            of_sizes = {size * size: scene(asked, method, meshes[100_000], size) for size in asked.sizes}
            show({pixels: processor(drawn, asked.runs) for pixels, drawn in of_sizes.items()}, "pixel")
            of_meshes = {count: scene(asked, method, meshes[count], asked.size) for count in asked.triangles}
            show({count: processor(drawn, asked.runs) for count, drawn in of_meshes.items()}, "triangle")
            show_threads(scene(asked, method, meshes[100_000], asked.size), asked.runs)


def written(folder: Path, triangles: int) -> str:
    """The path of the sphere."""
    path = folder / f"{triangles}.obj"
    path.write_text(bumpy_sphere(triangles))
    return str(path)


def scene(asked: argparse.Namespace, method: str, mesh: str, size: int) -> Scene:
    """The scene of `opengl.py`."""
    return sss_ref.load_scene(document(argparse.Namespace(mesh=mesh, size=size), asked.preset, method))


def processor(drawn: Scene, runs: int) -> float:
    """Milliseconds of processor time that one thread takes at least; once before to compile."""
    render(drawn, 1)
    return min(timed(time.process_time, drawn, 1) for _ in range(runs))


def render(drawn: Scene, threads: int) -> None:
    """The image alone."""
    sss_ref.render(drawn, threads=threads, keep="final")


def timed(clock: Callable[[], float], drawn: Scene, threads: int) -> float:
    """Milliseconds by a clock."""
    start = clock()
    render(drawn, threads)
    return 1e3 * (clock() - start)


def show(times: dict[int, float], what: str) -> None:
    """A line for each time beside the straight line, and its slope."""
    counts, took = np.array([*times], float), np.array([*times.values()])
    (slope, start), *_ = np.linalg.lstsq(
        np.stack([counts, np.ones_like(counts)], 1) / took[:, None], np.ones_like(took)
    )
    print(f"  {1e6 * slope:.1f} ns a {what} and {start:.1f} ms")
    for count, each in times.items():
        fitted = slope * count + start
        print(f"    {count:10,d} {what}s {each:9.1f} ms   line {fitted:9.1f} ms   {each / fitted - 1:+.0%}", flush=True)


def show_threads(drawn: Scene, runs: int) -> None:
    """How many times as fast two threads are, by the time that passes."""
    turns = [[timed(time.perf_counter, drawn, threads) for threads in (1, 2)] for _ in range(2 * runs + 1)]
    one, two = np.median(turns, axis=0)
    print(f"  1 to 2 threads: {one:.1f} to {two:.1f} ms, {one / two:.2f} times as fast", flush=True)


if __name__ == "__main__":
    main()
