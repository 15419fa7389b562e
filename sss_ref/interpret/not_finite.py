"""The message where a buffer would hold NaN or infinity (rule A6): which stage gave it, where, and from what."""

from typing import Any

import numpy as np

from sss_ref.errors import RenderError
from sss_ref.interpret.arrays import draw_values, run_stages
from sss_ref.interpret.work import Work
from sss_ref.language.layout import FLOAT32
from sss_ref.language.types import Array, Texture, components


def not_finite(work: Work) -> RenderError:
    """The error of a pass whose outputs are not all finite: names stage, pixel and inputs of the first that is not."""
    bad = {name: ~np.isfinite(buffer) for name, buffer in work.outputs.items() if buffer.dtype == FLOAT32}
    name = next(name for name, found in bad.items() if found.any())
    row, column, *_ = np.argwhere(bad[name])[0]
    return RenderError(_message(work, name, row, column))


def _message(work: Work, name: str, row: int, column: int) -> str:
    """Run the stages again on the one pixel, up to the first value that is not finite."""
    at = np.array([row]), np.array([column])
    for stage, inputs, results in run_stages(work, *at, draw_values(work, *at)):
        if not all(np.isfinite(part).all() for value in results.values() for part in components(value)):
            named = zip(stage.reads.values(), inputs, strict=True)
            listed = ", ".join(f"{read} = {_shown(value)}" for read, value in named if _shown(value))
            return f"stage {stage.name}, pixel {column},{row}: result is not finite; inputs: {listed}"
    return f"pass {work.this_pass.name}, pixel {column},{row}: buffer {name} is not finite"


def _shown(value: Any) -> str:
    """An input in a message: its components; textures, arrays and matrices are left out."""
    if isinstance(value, Texture | Array) or hasattr(value, "rows"):
        return ""
    return " ".join(str(np.ravel(part)[0]) for part in components(value))
