"""From a buffer that is wrong to the witness of one of its pixels."""

import numpy as np

from sss_ref.language.layout import dtype_of
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.walk import StageRun
from sss_ref.validation.witness.situation import Situation
from sss_ref.validation.witness.witness import DrawnValue, Witness


def cut_down(check: Check, pixel: tuple[int, int], run: StageRun, drawn: DrawnPass) -> Witness:
    """The witness of one pixel (column, row) of a buffer. run: its stage there; drawn: its pass."""
    column, row = pixel
    output = next(own for own, name in run.stage.writes.items() if name == check.buffer)
    got = np.atleast_1d(check.got[row, column]).astype(dtype_of(run.stage.outputs[output]))
    dumped, buffer = drawn.drawing, check.buffer
    stored, rounded = (held.get(buffer, "float32") for held in (dumped.stored, dumped.rounded))
    place = DrawnValue(check.pass_name, buffer, pixel, stored, rounded, dumped.device)
    return Witness(Situation.of(run), output, got, place, drawn.profile)
