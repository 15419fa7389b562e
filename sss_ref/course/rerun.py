"""One stage run again on what a rendering left, as plain NumPy, with some of its inputs changed."""

from typing import Any

import numpy as np

from sss_ref import Result
from sss_ref.interpret.work import buffer_value, store, uniform_value
from sss_ref.language import Stage, ivec2
from sss_ref.language.layout import dtype_of, shape_of


def rerun(stage: Stage, result: Result, /, **changed: Any) -> dict[str, np.ndarray]:
    """What a stage of the camera's picture writes: name -> (H, W) or (H, W, C), 0 beside the model.

    result: a rendering with all its buffers; the stage reads these and the scene's uniforms.
    changed: inputs to use instead: a buffer of the same size, or a uniform.
    """
    rows, columns = np.nonzero(result["coverage"])
    values = inputs_of(stage, result, (rows, columns), **changed)
    outputs = stage(*values.values())
    return {name: _picture(value, stage, name, result) for name, value in outputs._asdict().items()}


def inputs_of(stage: Stage, result: Result, at: tuple[np.ndarray, np.ndarray], /, **changed: Any) -> dict[str, Any]:
    """What a stage reads at some fragments, by the names of its parameters and in their order.

    at: rows and columns (N,) of the camera's picture. result, changed: as in `rerun`.
    """
    rows, columns = at
    given: dict[str, Any] = {**result.scene.uniforms, **result.buffers, **changed}
    pixel = ivec2(columns.astype(np.int32), rows.astype(np.int32))
    values: dict[str, Any] = {}
    for name, kind in stage.parameters.items():
        if name in result.buffers:
            values[name] = buffer_value(kind, given[name], rows, columns)
        else:
            values[name] = pixel if name == "pixel" else uniform_value(kind, given[name])
    return values


def _picture(value: Any, stage: Stage, name: str, result: Result) -> np.ndarray:
    """A stage's output at the covered pixels as a buffer."""
    rows, columns = np.nonzero(result["coverage"])
    height, width = result["coverage"].shape
    kind = stage.outputs[name]
    buffer = np.zeros(shape_of(kind, width, height), dtype_of(kind))
    store(buffer, rows, columns, value)
    return buffer
