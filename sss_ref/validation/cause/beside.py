"""What explains a background that is wrong: another clear value, or a pass that draws beside its stencil."""

from collections.abc import Iterator

import numpy as np

from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.walk import run_stage
from sss_ref.validation.verdict.background import background_of, outside_and_wrong

CLOSE = 2.0**-16  # relative, of what a stage gives where it should not run


def backgrounds(check: Check, drawn: DrawnPass) -> Iterator[tuple[str, float]]:
    """The explanations, with the share of the pixels on which something wrong stands; none where nothing does."""
    found = background_of(check)
    if found is not None and found.uniform:
        yield f"it is cleared to {found.got}, not to {found.expected}", 1.0
    elif found is not None and drawn.this_pass.draw.stencil:
        rows, columns = np.nonzero(outside_and_wrong(check))
        written = run_stage(drawn, (rows, columns), check.buffer).written[check.buffer].columns
        got = np.atleast_3d(check.got)[rows, columns].astype(np.float64)
        share = float((np.abs(got - written) <= np.abs(got) * CLOSE).all(axis=1).mean())
        yield f"the pass draws beside its stencil, {drawn.this_pass.draw.stencil}", share
