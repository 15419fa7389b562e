"""The project: the screen-space method written by the reader in NumPy, each stage judged by `sss_ref.validate`.

What the rasterizer gives is there. What a stage of the reader's gives is a buffer of a dump, like another renderer's.
"""

import inspect
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np

import sss_ref
from sss_ref.course import small_scenes
from sss_ref.validation.scope import Scope

SIZE = 64  # pixels a side
WORDS = {  # one light, hard shadows, the kernel in pixels, the stencil on output
    **small_scenes.BY_THE_TEXT,
    "blur.unit": "pixel",
    "blur.follow_surface": False,
    "blur.mask": "output",
}
MILESTONES = (  # the buffers to write, in the order of the method
    *("stored_distance", "directly_lit", "phong", "thickness"),
    *("translucency", "lit", "scattered", "image"),
)
Written = Mapping[str, Callable[..., Any]]


@cache
def oracle(size: int = SIZE) -> sss_ref.Result:
    """The rendering that the reader's is held against."""
    return sss_ref.render(small_scenes.load("figure3_with", "bust", size, **WORDS), interpreter="arrays")


def stage_of(buffer: str) -> str:
    """The stage that writes a buffer."""
    stages = oracle().scene.method.stages
    return next(name for name, stage in stages.items() if buffer in stage.outputs)


def readable(buffer: str, size: int = SIZE) -> dict[str, Any]:
    """What the stage of a buffer may read, by name: the uniforms, and the buffers that are written before it."""
    result = oracle(size)
    stages = [stage for each in result.scene.method.passes for stage in each.stages]
    first = next(number for number, stage in enumerate(stages) if buffer in stage.outputs)
    later = {name for stage in stages[first:] for name in stage.writes.values()}
    return {**result.scene.uniforms, **{name: each for name, each in result.buffers.items() if name not in later}}


def as_buffer(buffer: str, value: np.ndarray, size: int = SIZE) -> np.ndarray:
    """A reader's array as the buffer: its type, and beside the model what stands there."""
    right = oracle(size)[buffer]
    drawn = oracle(size)["coverage"] != 0
    if buffer in ("scattered", "image"):
        return value.astype(right.dtype)
    where = drawn if right.ndim == 2 else drawn[..., None]
    return np.where(where, value, right).astype(right.dtype)


def judged(buffer: str, drawn: np.ndarray) -> Any:
    """The verdict on one buffer of the reader's, alone."""
    scope = Scope(stage=stage_of(buffer), causes=False, power=False)
    report = sss_ref.validate(oracle(), {buffer: drawn}, profile="gl", explain=scope)
    (verdict,) = (each for each in report.verdicts if each.buffer == buffer)
    return verdict


def chained(written: Written, size: int = 192) -> dict[str, np.ndarray]:
    """The reader's whole method as a dump: each stage is given what the ones before it gave.

    written: buffer -> function; it ends before the first that gives nothing, or asks for what there is not.
    """
    dump: dict[str, np.ndarray] = {}
    for buffer in MILESTONES:
        values = readable(buffer, size) | dump
        names = list(inspect.signature(written[buffer]).parameters)
        got = written[buffer](*map(values.get, names)) if set(names) <= set(values) else None
        if got is None:
            break
        dump[buffer] = as_buffer(buffer, np.asarray(got), size)
    return dump
