"""Stages in a row of which only what the last gives was dumped."""

import numpy as np
import pytest
from planted import oracle_of, scene_of

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import stacked
from sss_ref.validation.cause.chain import chain_of, suspected

SIDE = 24


@pytest.fixture(scope="module")
def oracle():
    return oracle_of(scene_of("bust", SIDE))


def drawn_of(oracle, *dumped):
    case = Case(oracle, Drawing({name: oracle[name] for name in dumped}), PROFILES["vulkan"])
    return case.drawn(oracle.scene.method["camera"])


@pytest.mark.parametrize("dumped", [("lit",), ("lit", "phong"), ("lit", "phong", "thickness", "normal_world")])
def test_it_gives_what_its_stages_give_one_after_the_other(oracle, dumped):
    drawn = drawn_of(oracle, *dumped)
    at = np.nonzero(drawn.work.fragments.where)
    chain, inputs = chain_of(drawn, "lit", at)
    assert np.array_equal(stacked(chain.run(inputs)["lit"]), oracle["lit"][at])


def test_it_has_the_stages_of_which_nothing_was_dumped_and_reads_what_was(oracle):
    chain, _ = chain_of(drawn_of(oracle, "lit", "phong", "translucency"), "lit", (np.array([12]), np.array([12])))
    names = [stage.name for stage in chain.stages]
    assert names[-1] == "lit_transmit_wrapped" and "phong_shading" not in names and "back_point" not in names
    assert {"phong", "translucency", "fragment_position"} <= set(chain.parameters)
    assert "position_world" not in chain.parameters  # which its own stage `surface` gives


def test_a_stage_that_was_given_all_it_reads_is_alone(oracle):
    this_pass = oracle.scene.method["camera"]
    (alone,) = suspected(this_pass, "lit", set(oracle.buffers))
    assert alone.name == "lit_transmit_wrapped"
