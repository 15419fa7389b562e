"""The whole at once: intervals flow from stage to stage, and nothing of the dump goes in.

Where a stage passes with what was drawn before it but its buffer lies outside these bounds, it has inherited an error.
The bounds grow from stage to stage, so this is reported and decides nothing.
"""

from collections.abc import Collection
from dataclasses import replace

from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import KnownBuffer
from sss_ref.validation.accept.walk import in_rounds, untouched

NOTHING = Drawing({})


def chained(case: Case, on_demand: Collection[str] = ()) -> dict[str, KnownBuffer]:
    """What every buffer of a scene may hold, drawn by a processor of the profile; the rasterizer's are the oracle's.

    on_demand: names beside the method's outputs.
    """
    oracle, method = case.oracle, case.oracle.scene.method
    wanted = {*method.outputs, *on_demand}
    known: dict[str, KnownBuffer] = {}
    for this_pass in method.only(wanted).passes:
        drawn = replace(case.of_oracle.drawn(this_pass), drawing=NOTHING)
        known |= untouched(oracle, drawn, [name for name in this_pass.values if name in wanted])
        start = {name: known[name] for stage in this_pass.stages for name in stage.writes.values() if name in wanted}
        known |= in_rounds(drawn, {**drawn.read, **known}, drawn.work.fragments.where, start)
    return known
