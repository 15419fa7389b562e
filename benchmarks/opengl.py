"""Times our kernels beside a software OpenGL that draws the same: python benchmarks/opengl.py --size 1024.

Mesa's llvmpipe draws the shaders that the stages translate to: the same mesh, filters, mask, buffers and number of
threads. Its programs, vertices and textures are made before the clock runs. Both take turns; what is printed is the
median of each, in milliseconds that pass and in milliseconds of processor time, and how many times as long OpenGL took.

final: the image alone, and what it depends on; of OpenGL it is not read back. all: every buffer, read back into arrays.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from render import bumpy_sphere

import sss_ref
from sss_ref.gl.canvas import Canvas
from sss_ref.gl.context import device_name, open_context
from sss_ref.gl.shaders import ShaderPair, own_shaders
from sss_ref.gl.uploads import downloaded, filled
from sss_ref.language.layout import dtype_of
from sss_ref.language.pipeline import Pass
from sss_ref.scene.scene import Scene

DISTANCE = 2.9
LIGHT = [2.0 * DISTANCE, DISTANCE, DISTANCE]


def main() -> None:
    """Run every combination in a process of its own: the number of llvmpipe's threads is read when it is loaded."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--triangles", type=int, default=100_000)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--presets", nargs="+", default=["paper", "robust"])
    parser.add_argument("--methods", nargs="+", default=["screen_space", "texture_space"])
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--mesh", help="the sphere, already written")
    asked = parser.parse_args()
    if asked.mesh:
        measure(asked)
        return
    print(f"{asked.triangles} triangles, all maps {asked.size}^2, medians of {asked.runs} turns")
    print(device_name())
    print(f"{'':52s}{'OpenGL':>8s}{'ours':>8s}{'ratio':>7s}{'processor':>15s}{'ratio':>7s}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sphere.obj"
        path.write_text(bumpy_sphere(asked.triangles))
        for threads in asked.threads:
            environment = os.environ | {
                "LP_NUM_THREADS": str(threads if threads > 1 else 0),
                "GALLIUM_DRIVER": "llvmpipe",
            }
            own = ["--mesh", str(path), "--threads", str(threads)]
            subprocess.run([sys.executable, *sys.argv, *own], env=environment, check=True)


def measure(asked: argparse.Namespace) -> None:
    """All presets and methods with one number of threads."""
    (threads,) = asked.threads
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:threads])
    for preset in asked.presets:
        for method in asked.methods:
            scene = sss_ref.load_scene(document(asked, preset, method))
            for keep in ("final", "all"):
                peer = Peer(scene, keep)
                ours = compared(peer, sss_ref.render(scene, threads=threads, keep=keep).buffers)
                turns = taken_in_turns(peer.draw, lambda: sss_ref.render(scene, threads=threads, keep=keep), asked.runs)  # noqa: B023
                peer.context.release()
                print(
                    f"{preset:7s}{method:14s}{keep:6s}{threads} thread{'s'[: threads > 1]:2s} {ours:16s}{turns}",
                    flush=True,
                )


def document(asked: argparse.Namespace, preset: str, method: str) -> dict[str, object]:
    """The scene: the bumpy sphere, all maps of the picture's size."""
    size = {"width": asked.size, "height": asked.size}
    return {
        "preset": preset,
        "method": method,
        "mesh": {"path": asked.mesh},
        "camera": {"type": "orbit", "distance": DISTANCE, **size},
        "lights": [{"position": LIGHT}],
        "shadow_map": size,
        "irradiance_map": {**size, "overlap": "first"},
    }


class Peer:
    """The same scene in OpenGL: everything that a program would make once is made here, `draw` draws one picture."""

    def __init__(self, scene: Scene, keep: str) -> None:
        self.scene, self.context, self.keep = scene, open_context(), scene.kept(keep)
        self.canvas = Canvas(self.context, scene.uniforms)
        self.read_back = keep == "all"
        self.textures: dict[str, Any] = {}
        self.rounds: list[list[Draw]] = [self.prepared(*each) for each in scene.method.only(self.keep).in_order()]

    def prepared(self, this_pass: Pass, read_later: set[str]) -> "list[Draw]":
        """The draws of a pass, round after round."""
        draws = []

        def one_round(read: Mapping[str, Any]) -> dict[str, Any]:
            written: dict[str, Any] = {}
            wanted = set(this_pass.fed_back) or self.keep | read_later
            for pair in own_shaders(this_pass, self.textures, wanted, self.canvas.lengths):
                kinds, size = this_pass.values, self.scene.size(this_pass)
                targets = {
                    name: filled(self.context, kinds[name], size, self.scene.clear(name)) for name in pair.outputs
                }
                draws.append(Draw(self, this_pass, pair, dict(read), targets))
                written |= targets
            return written

        self.textures |= this_pass.folded(self.textures, one_round)
        return draws

    def draw(self) -> dict[str, np.ndarray]:
        """Draw one picture; what is read back."""
        for draw in (draw for draws in self.rounds for draw in draws):
            draw.run()
        if self.read_back:
            return self.buffers()
        self.context.finish()
        return {}

    def buffers(self) -> dict[str, np.ndarray]:
        """All that is kept, as arrays."""
        values = self.scene.method.values
        kept = [name for name in values if name in self.keep and name in self.textures]
        return {name: downloaded(self.textures[name], values[name]) for name in kept}


class Draw:
    """One program with its targets, ready to be drawn again and again."""

    def __init__(self, peer: Peer, this_pass: Pass, pair: ShaderPair, read: dict[str, Any], targets: dict[str, Any]):
        self.peer, self.read, self.name = peer, read, pair.name
        context, mesh = peer.context, peer.scene.mesh
        self.program = pair.compiled(context)
        self.backgrounds = [
            Background(context, texture, this_pass.values[name], peer.scene.clear(name))
            for name, texture in targets.items()
        ]
        self.of_mesh = bool(this_pass.draw.vertex_stages)
        colors = [*targets.values()]
        depth = context.depth_texture(colors[0].size) if self.of_mesh else None
        self.target = context.framebuffer(colors, depth)
        self.depth_only = context.framebuffer([], depth) if self.of_mesh else None
        if self.of_mesh:
            self.vertices = peer.canvas.vertices(self.program, mesh.attributes, mesh.triangles)
        else:
            self.vertices = context.vertex_array(self.program, [])

    def run(self) -> None:
        """Clear and draw."""
        context = self.peer.context
        for background in self.backgrounds:
            background.clear()
        self.peer.canvas.hand_over(self.program, self.read, self.name)
        if self.depth_only:
            self.depth_only.clear(depth=1.0)
            self.target.use()
            context.enable_only(context.DEPTH_TEST)
            context.depth_func = "<"
            self.vertices.render(context.TRIANGLES)
        else:
            self.target.use()
            context.enable_only(context.NOTHING)
            self.vertices.render(context.TRIANGLE_STRIP, vertices=4)


class Background:
    """What a target holds before it is drawn into: cleared, or written where it holds integers."""

    def __init__(self, context: Any, texture: Any, kind: Any, value: Any) -> None:
        self.texture, self.whole = texture, None
        if dtype_of(kind) == np.float32:
            self.target = context.framebuffer([texture])
            self.values = tuple(float(each) for each in np.broadcast_to(value, 4 if np.ndim(value) == 0 else 3))
        else:
            self.whole = np.full(texture.size[::-1], value, dtype_of(kind)).tobytes()

    def clear(self) -> None:
        """Put the background everywhere."""
        if self.whole is None:
            self.target.clear(*self.values)
        else:
            self.texture.write(self.whole, alignment=1)


def compared(peer: Peer, ours: Mapping[str, np.ndarray]) -> str:
    """The share of pixels at which the two pictures agree: within 1 % of the picture's largest value."""
    peer.draw()
    difference = np.abs(peer.buffers()["image"].astype(float) - ours["image"])
    return f"{(difference.max(axis=-1) <= 0.01 * ours['image'].max()).mean():.1%} alike"


def taken_in_turns(theirs: Callable[[], object], ours: Callable[[], object], runs: int) -> str:
    """A line: both medians and their ratio, of the time that passed and of the processor time of all threads."""
    ours()
    theirs()
    walls, processors = [], []
    for _ in range(runs):
        pairs = [timed(theirs), timed(ours)]
        walls.append([pair[0] for pair in pairs])
        processors.append([pair[1] for pair in pairs])
    return "".join(ratio(each) for each in (walls, processors))


def timed(run: Callable[[], object]) -> tuple[float, float]:
    """Milliseconds that pass, and of processor time."""
    wall, processor = time.perf_counter(), time.process_time()
    run()
    return 1e3 * (time.perf_counter() - wall), 1e3 * (time.process_time() - processor)


def ratio(turns: list[list[float]]) -> str:
    """The medians of both, and how many times as long the first takes."""
    theirs, ours = (statistics.median(each) for each in zip(*turns, strict=True))
    return f"{theirs:8.1f}{ours:8.1f}{theirs / ours:7.2f}"


if __name__ == "__main__":
    main()
