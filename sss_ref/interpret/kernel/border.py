"""A round of dilation, run on the border of the charts alone, for nothing else changes.

`dilate` gives a texel its inputs again where the mask is 1, and where it is 0 at the eight neighbours too.
"""

import numpy as np

from sss_ref.interpret.work import Work
from sss_ref.language.pipeline import Pass
from sss_ref.passes.irradiance import dilate


def is_dilation(this_pass: Pass) -> bool:
    """Whether a pass is `dilate`, whatever it widens, fed back its outputs."""
    return bool(this_pass.feedback) and all(
        stage.python is dilate.python and not stage.variant[0] for stage in this_pass.stages
    )


def carried_over(work: Work, rows: slice) -> np.ndarray:
    """Copy the inputs of some rows to the outputs; bool (R, W), the texels that may change."""
    for name, own in work.this_pass.feedback.items():
        if own in work.outputs:
            work.outputs[own][rows] = work.buffers[name][rows]
    (stage,) = work.this_pass.stages
    return border(work.buffers[stage.reads["irradiance_mask"]], rows)


def border(mask: np.ndarray, rows: slice) -> np.ndarray:
    """Where a mask, uint8 (H, W), is 0 and 1 at one of the eight neighbours, in some of its rows: bool (R, W)."""
    first, stop = max(rows.start - 1, 0), min(rows.stop + 1, len(mask))
    beyond = (first - (rows.start - 1), rows.stop + 1 - stop)
    around = np.pad(mask[first:stop] != 0, (beyond, (1, 1)))
    tall = around[:-2] | around[1:-1] | around[2:]
    beside = tall[:, :-2] | tall[:, 1:-1] | tall[:, 2:]
    found: np.ndarray = beside & ~around[1:-1, 1:-1]
    return found
