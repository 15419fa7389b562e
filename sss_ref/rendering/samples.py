"""Anti-aliased reference pictures: the average of exact renderings whose pictures are moved by parts of a pixel.

Sample (i, j) of n x n moves the picture by ((i + 0.5)/n - 0.5, (j + 0.5)/n - 0.5) pixels, to the right and upwards, so
the pixel's centre sees what lies as far to its left and below: together the samples see the middles of n x n equal
parts of the pixel. Every rendering is a whole one, so the average is over the final image and not over its stages; the
blur of each sample is that of the image's own pixels.
"""

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.rendering.fold import render
from sss_ref.rendering.memory import check_memory
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.view.matrices import Matrix, product, translation
from sss_ref.view.views import View

LAYERED = ("coverage", "image")
SUMMING_BYTES = 3 * 7 * 4  # a pixel: the layers of one sample, those of all before it, and their sum
FloatArray = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class MovedView(View):
    """A view whose picture is moved by `offset` (x, y) pixels, to the right and upwards."""

    offset: tuple[float, float]

    @cached_property
    def projection(self) -> Matrix:
        """clip_from_view, 4 x 4: x += (2 * offset_x / width) * w after the projection, y likewise; float64."""
        x, y = self.offset
        return product(translation(np.array([2 * x / self.width, 2 * y / self.height, 0])), super().projection)


@dataclass(frozen=True, eq=False)
class SampledResult(Result):
    """The averaged `image`, its only buffer, and what a picture with transparency needs besides."""

    samples: int  # n: the average is over n x n renderings
    coverage: FloatArray  # (H, W), share of the samples that see the model, 0 to 1
    foreground: FloatArray  # (H, W, 3), linear RGB: average of those samples alone; the image where there are none


def render_samples(
    scene: Scene,
    n: int,
    interpreter: str = "kernel",
    threads: int | None = None,
    on_pass: Callable[[str], None] | None = None,
) -> SampledResult:
    """Render a scene n x n times, its picture moved by `offsets(n)`, and average the images.

    image = (((image_0 + image_1) + image_2) + ...) / (n * n), in float32, in the order of `offsets`.
    n: 1 gives the bits of `render`. interpreter, threads: as in `render`. on_pass: called with the pass and the sample
    before it runs. Raises SceneError for n < 1 and as `render` does.
    """
    if n < 1:
        raise SceneError(f"samples: expected at least 1, got {n}; 4 makes smooth edges")
    check_memory(scene, {*LAYERED}, SUMMING_BYTES)
    layers, timings = None, Counter[str]()
    for number, offset in enumerate(offsets(n), start=1):
        told = _naming(f"sample {number} of {n * n}", on_pass)
        result = render(moved(scene, offset), interpreter, threads, LAYERED, told)
        layers = _layers(result) if layers is None else layers + _layers(result)  # from the first one, or -0 became 0
        timings.update(result.timings)
    assert layers is not None
    image, covered, count = np.split(layers, (3, 6), axis=-1)
    mean, share = image / np.float32(n * n), count[..., 0] / np.float32(n * n)
    foreground = np.where(count > 0, covered / np.maximum(count, np.float32(1)), mean)
    return SampledResult(scene, {"image": mean}, timings, n, share, foreground, notes=result.notes)


def offsets(n: int) -> Iterator[tuple[float, float]]:
    """The offsets (x, y) of the n x n samples in pixels, above -0.5 and below 0.5: row by row upwards, x fastest."""
    steps = [(k + 0.5) / n - 0.5 for k in range(n)]
    return ((x, y) for y in steps for x in steps)


def moved(scene: Scene, offset: tuple[float, float]) -> Scene:
    """A scene whose picture is moved by `offset` pixels; the lights see what they saw."""
    view = {field.name: getattr(scene.camera, field.name) for field in fields(View)}
    return replace(scene, camera=MovedView(**view, offset=offset))


def _layers(result: Result) -> FloatArray:
    """What is summed of a sample, float32 (H, W, 7): the image, the image where it is covered, and coverage."""
    coverage = result["coverage"][..., np.newaxis].astype(np.float32)
    return np.concatenate((result.image, result.image * coverage, coverage), axis=-1)


def _naming(sample: str, on_pass: Callable[[str], None] | None) -> Callable[[str], None] | None:
    """`on_pass`, told the sample along with the pass."""
    return on_pass and (lambda name: on_pass(f"{name}, {sample}"))
