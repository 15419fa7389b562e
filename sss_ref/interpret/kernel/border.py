"""A round of dilation, run on the border of the charts alone, for nothing else changes.

`dilate` gives a texel its inputs again where the mask is 1, and where it is 0 at the eight neighbours too.
"""

import numpy as np

from sss_ref.cache.compiled import compiled
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
    found = np.empty((min(rows.stop, len(mask)) - rows.start, mask.shape[1]), np.bool_)
    find_border(mask, rows.start, found)
    return found


@compiled
def find_border(mask: np.ndarray, first_row: int, found: np.ndarray) -> None:
    """Fill in the `border` from a row on, bool (R, W); beyond the mask's own edges is what is at them."""
    last_row, width = mask.shape[0] - 1, mask.shape[1]
    tall = np.zeros(width + 2, np.uint8)  # a texel with those above and below, and nothing on either side
    for k in range(len(found)):
        row = first_row + k
        below, above = max(row - 1, 0), min(row + 1, last_row)
        for column in range(width):
            tall[column + 1] = mask[below, column] | mask[row, column] | mask[above, column]
        for column in range(width):
            beside = tall[column] | tall[column + 1] | tall[column + 2]
            found[k, column] = (beside != 0) & (mask[row, column] == 0)
