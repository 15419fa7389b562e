"""Runs one stage by itself: on one fragment as plain Python, or on a picture by an interpreter or naively."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any, get_origin

import numpy as np

from sss_ref.interpret.work import Fragments, Work, uniform_value
from sss_ref.language import Array, Stage, Texture, ivec2
from sss_ref.language.layout import CHANNELS, dtype_of, shape_of
from sss_ref.language.pipeline import PIXEL, Pass, ScreenDraw
from sss_ref.language.types import components
from sss_ref.methods.stages import stage_modules


def stages_by_module() -> dict[str, list[Stage]]:
    """Every module that may define stages -> those defined in it."""
    return {name: _stages_of(module) for name, module in stage_modules().items()}


def _stages_of(module: ModuleType) -> list[Stage]:
    stages = [value for value in vars(module).values() if isinstance(value, Stage)]
    return [stage for stage in stages if stage.python.__module__ == module.__name__]


def call(stage: Stage, **inputs: Any) -> tuple[Any, ...]:
    """The values a stage returns for one fragment, vectors as tuples; each is float32, a truth value or a literal."""
    arguments = [_value(kind, inputs.pop(name)) for name, kind in stage.parameters.items()]
    assert not inputs, f"{stage.name} does not read {', '.join(inputs)}"
    with np.errstate(all="ignore"):  # as the interpreters: both sides of a select are computed
        results = [components(value) for value in stage(*arguments)]
    computed = [np.asarray(part) for parts in results for part in parts if type(part) is not float]
    assert all(part.dtype in (np.float32, np.bool_) for part in computed)
    return tuple(tuple(map(float, parts)) if len(parts) > 1 else parts[0] for parts in results)


def _value(kind: Any, raw: Any) -> Any:
    if kind is ivec2:
        return ivec2(*raw)
    if get_origin(kind) is Texture:
        return Texture(np.asarray(raw))
    if kind == Array[int]:
        return Array(np.asarray(raw, np.int32))
    return uniform_value(kind, raw if kind in (bool, int) else np.asarray(raw, np.float32))


@dataclass(frozen=True)
class Inputs:
    """What a stage may read: buffers (H, W) or (H, W, C), those of the stage's own size and others, and uniforms."""

    width: int
    height: int
    buffers: Mapping[str, np.ndarray]
    uniforms: Mapping[str, Any]


def run(interpreter: Any, stage: Stage, inputs: Inputs) -> dict[str, np.ndarray]:
    """The buffers a stage writes when `interpreter`, a module of sss_ref.interpret, runs it on every pixel."""
    one = Pass(stage.name, "", ScreenDraw(), (stage,))
    outputs = _empty(stage, inputs)
    backgrounds = {name: np.zeros(CHANNELS[kind]) for name, kind in one.outputs.items()}
    fragments = Fragments(inputs.width, inputs.height)
    interpreter.run_fragments(Work(one, fragments, inputs.uniforms, inputs.buffers, outputs, backgrounds), None)
    return outputs


def run_naively(naive: Callable[..., tuple[Any, ...]], stage: Stage, inputs: Inputs) -> dict[str, np.ndarray]:
    """The same buffers by a loop over the pixels, from a naive form of the stage."""
    outputs = _empty(stage, inputs)
    with np.errstate(all="ignore"):
        for row in range(inputs.height):
            for column in range(inputs.width):
                kinds = stage.parameters.items()
                arguments = {own: _plain(inputs, stage.reads[own], kind, row, column) for own, kind in kinds}
                for buffer, value in zip(outputs.values(), naive(**arguments), strict=True):
                    buffer[row, column] = value
    return outputs


def _empty(stage: Stage, inputs: Inputs) -> dict[str, np.ndarray]:
    """Buffers for the outputs, filled with a value that is seldom right."""
    return {
        stage.writes[own]: np.full(shape_of(kind, inputs.width, inputs.height), 77, dtype_of(kind))
        for own, kind in stage.outputs.items()
    }


def _plain(inputs: Inputs, name: str, kind: Any, row: int, column: int) -> Any:
    """An input as the naive forms take it: NumPy scalars, lists of them, ndarrays for textures and matrices."""
    if name == PIXEL:
        return column, row
    if get_origin(kind) is Texture:
        return inputs.buffers[name]
    value = inputs.buffers[name][row, column] if name in inputs.buffers else inputs.uniforms[name]
    return list(value) if np.ndim(value) == 1 else value


def assert_same_bits(got: Mapping[str, np.ndarray], expected: Mapping[str, np.ndarray]) -> None:
    """Every buffer has the same bits; a NaN equals any NaN."""
    assert list(got) == list(expected)
    for name, buffer in expected.items():
        differs = got[name].view(f"u{buffer.itemsize}") != buffer.view(f"u{buffer.itemsize}")
        differs &= ~((got[name] != got[name]) & (buffer != buffer))
        places = np.argwhere(differs)
        if len(places):
            row, column = places[0][:2]
            raise AssertionError(
                f"{name}: {len(places)} of {buffer.size} values differ, the first at pixel {column},{row}: "
                f"{got[name][row, column]!r}, expected {buffer[row, column]!r}"
            )
