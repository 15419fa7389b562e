"""Stages with a mistake in them, on small stages of the test's own."""

from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.language import stage, vec3
from sss_ref.validation.cause.hypothesis import SOURCE
from sss_ref.validation.cause.mistaken import computing, stages_instead, stages_misread, stages_mutated


class Lit(NamedTuple):
    """A colour, and how bright it is."""

    lit: vec3
    brightness: float


class Other(NamedTuple):
    """Something else."""

    image: vec3


@stage(source="a test")
def wrapped(translucency_scale: float, wrap: float, phong: vec3) -> Lit:
    """Divides what wraps round."""
    scale = translucency_scale / (1.0 + wrap)
    return Lit(phong * scale, scale)


@stage(source="a test")
def unwrapped(translucency_scale: float, phong: vec3) -> Lit:
    """Takes no wrap."""
    return Lit(phong * translucency_scale, translucency_scale)


@stage(source="a test")
def needing_more(translucency_scale: float, phong: vec3, thickness: float) -> Lit:
    """Reads what the others do not."""
    return Lit(phong * thickness, translucency_scale)


@stage(source="a test")
def elsewhere(phong: vec3) -> Other:
    """Writes what the others do not."""
    return Other(phong * 2.0)


ALL = {each.name: each for each in (wrapped, unwrapped, needing_more, elsewhere)}
BOUND = wrapped.bound(phong="phong_2", lit="lit_2", wrap="wrap_2")
GIVEN = {"translucency_scale": np.float32(3), "wrap": np.float32(0.5), "phong": vec3(*np.float32([1, 2, 4]))}


def given_by(stage):
    """What a stage writes, by its buffers."""
    written = stage.run([GIVEN[own] for own in stage.parameters])
    return {name: [*map(float, value)] if isinstance(value, vec3) else float(value) for name, value in written.items()}


def test_the_right_one_gives_this():
    assert given_by(BOUND) == {"lit_2": [2, 4, 8], "brightness": 2}


def test_another_stage_writes_the_same_from_what_there_is():
    ((charge, instead),) = stages_instead(BOUND, ALL)
    assert (charge.text, charge.blames) == ("it computes unwrapped, not wrapped", SOURCE)
    assert instead.reads == {"translucency_scale": "translucency_scale", "phong": "phong_2"}
    assert given_by(instead) == {"lit_2": [3, 6, 12], "brightness": 3}
    assert not [*stages_instead(unwrapped.bound(), {"wrapped": wrapped, "unwrapped": unwrapped})]
    same = [charge.text for charge, _ in stages_instead(wrapped, {"copied": wrapped})]
    assert same == ["it computes copied, not wrapped"]


def test_a_misreading_changes_one_of_its_outputs():
    misread = {charge.text: stage for charge, stage in stages_misread(BOUND)}
    found = given_by(misread["wrapped: what wraps round is not divided by 1 + wrap"])
    assert np.allclose(found["lit_2"], [3, 6, 12], rtol=1e-6, atol=0) and found["brightness"] == 2
    assert {text.partition(": ")[0] for text in misread} == {"wrapped"} and not [*stages_misread(elsewhere)]


def test_one_place_of_the_source_is_changed():
    found = {charge.text: given_by(stage)["lit_2"] for charge, stage in stages_mutated(BOUND)}
    assert found[
        "wrapped: `scale = translucency_scale * (1.0 + wrap)` for `scale = translucency_scale / (1.0 + wrap)`"
    ] == (pytest.approx([4.5, 9, 18]))


def test_another_computation_keeps_what_a_stage_reads_and_writes():
    other = computing(BOUND, lambda scale, wrap, phong: (phong, wrap))
    assert given_by(other) == {"lit_2": [1, 2, 4], "brightness": 0.5}
    assert other.name == "wrapped" and other.reads == BOUND.reads and other.writes == BOUND.writes
