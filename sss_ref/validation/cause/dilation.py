"""Too few rounds of a dilation, or none: a map that was used as drawn."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Buffers, Machine, draw, shade
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.cause.hypothesis import INPUT, SETTING, Charge
from sss_ref.validation.cause.on_the_way import within

MORE = 2  # rounds beyond those that are right
AS_DRAWN = "the map was used as drawn, without dilation"


def dilations(case: Case, check: Check) -> Iterator[tuple[Charge, np.ndarray]]:
    """Other numbers of rounds of the pass, and maps that it reads before their dilation: in words, and bool (H, W).

    The pixels are those on which the buffer is as that leaves it.
    """
    this_pass = case.oracle.scene.method[check.pass_name]
    there = {**case.oracle.buffers, **case.drawing.buffers}
    tried = _other_rounds(case, this_pass, there) if this_pass.fed_back else _as_drawn(case, this_pass, check, there)
    for charge, drawn in tried:
        yield charge, within(check, check.got, drawn[check.buffer])


def _other_rounds(case: Case, this_pass: Pass, there: Buffers) -> Iterator[tuple[Charge, Buffers]]:
    """What a pass gives after other numbers of rounds; after none, what it was given."""
    scene, machine = case.oracle.scene, Machine(stops=False)
    fragments = draw(scene, this_pass, there, machine).fragments
    after = [{own: there[name] for name, own in this_pass.feedback.items()}]

    def run(read: Buffers) -> Buffers:
        after.append(shade(scene, this_pass, fragments, read, [*this_pass.fed_back], machine))
        return after[-1]

    replace(this_pass, rounds=this_pass.rounds + MORE).folded(there, run)
    for rounds, written in enumerate(after):
        if rounds != this_pass.rounds:
            told = f"{this_pass.name} runs {rounds} round{'s' * (rounds != 1)} instead of {this_pass.rounds}"
            yield Charge(told if rounds else AS_DRAWN, SETTING), written


def _as_drawn(case: Case, this_pass: Pass, check: Check, there: Buffers) -> Iterator[tuple[Charge, Buffers]]:
    """What a pass gives if it reads the maps before their dilation, and is limited by their masks then."""
    scene, machine = case.oracle.scene, Machine(stops=False)
    fed_back = {own: name for each in scene.method.passes for name, own in each.feedback.items()}
    changed = {own: name for own, name in fed_back.items() if own in this_pass.needs}
    if changed and check.buffer not in this_pass.draw.outputs:
        read = {**there, **{own: there[name] for own, name in changed.items()}}
        names = " and ".join(f"{name} for {own}" for own, name in changed.items())
        fragments = draw(scene, this_pass, read, machine).fragments
        charge = Charge(f"{AS_DRAWN}: {names}", INPUT, tuple(changed))
        yield charge, shade(scene, this_pass, fragments, read, [check.buffer], machine)
