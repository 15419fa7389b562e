"""Other numbers for the uniforms of a stage."""

import numpy as np
import pytest
from planted import NUMBERS, Planted, instead, oracle_of, scene_of, vertex

from sss_ref.validation.cause.hypothesis import FITTED, NUMBER
from sss_ref.validation.scope import Scope
from sss_ref.validation.stage_by_stage import validate


@pytest.fixture(scope="module")
def oracle():
    return oracle_of(scene_of("bust", 32))


@pytest.mark.parametrize(
    ("name", "value", "rank", "text"),
    [
        ("wrap", 0.0, NUMBER, "wrap is 0 instead"),
        ("shininess", 64.0, NUMBER, "shininess is 64 instead"),
        ("shininess", 33.3, FITTED, "shininess is 33.3 instead"),
        ("translucency_scale", 0.1234, FITTED, "translucency_scale is 0.1234 instead"),
    ],
)
def test_simple_numbers_and_few_digits_come_first(oracle, name, value, rank, text):
    dumped = Planted(name, vertex(name, instead(np.float32(value))), "", lacks=NUMBERS).drawn(oracle.scene)
    found = validate(oracle, dumped, explain=Scope(power=False, seconds=300)).finding.hypotheses
    assert found[0].text.startswith(text) and found[0].rank == rank
