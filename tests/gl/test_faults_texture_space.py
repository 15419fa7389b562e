"""Faults that only the texture-space method can have, each found at its stage."""

from dataclasses import replace

import pytest
from edited import KEPT, blamed, judged, rendered
from faults import TEXTURE_SPACE as FAULTS
from opengl import needs_mesa

from sss_ref.gl import draw
from sss_ref.passes.texture_image import gloss_where_lit
from sss_ref.validation.cause.mutants import mutants
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

T = "texture space"


@pytest.mark.parametrize("fault", FAULTS)
def test_the_stage_with_the_fault_is_named(fault, tmp_path):
    found = judged(FAULTS[fault], tmp_path)
    assert not found.passed and blamed(found.culprit) == [FAULTS[fault].at]


def test_a_mistake_in_a_function_that_two_stages_call_stays_in_one():
    """`highlight` is wrong in gloss_where_lit alone: its shader has both, the other under a number."""
    oracle = rendered(T)
    wrong = next(mutant for mutant in mutants(gloss_where_lit) if mutant.wrong == "mirrored = dot(to_eye, normal)")
    own = {"gloss_where_lit": gloss_where_lit.with_body(wrong.body)}
    found = validate(oracle, draw(replace(oracle.scene, own_stages=own), keep=KEPT), explain=False)
    assert blamed(found.culprit) == ["camera/gloss_where_lit"]
