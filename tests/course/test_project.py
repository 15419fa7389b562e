"""The project's solutions make a renderer that `validate` passes, and a half of it is taken for a half."""

import numpy as np
import pytest
from exercise_answers import solutions

import sss_ref
from sss_ref.course.project import MILESTONES, SIZE, as_buffer, chained, oracle, readable

WRITTEN = {check.__name__.removeprefix("own_"): answer for check, answer in solutions().items()}


def test_the_solutions_in_a_chain_draw_what_a_right_processor_may():
    dump = chained({name: WRITTEN[name] for name in MILESTONES}, SIZE)
    assert list(dump) == [*MILESTONES]
    report = sss_ref.validate(oracle(), dump, profile="gl", explain=False)
    assert report.passed, report.summary
    assert np.allclose(dump["image"], oracle().image, atol=1e-4)
    assert not np.array_equal(dump["image"], oracle().image)


@pytest.mark.parametrize("missing", [lambda: None, lambda scattered: scattered])
def test_a_chain_ends_before_what_gives_nothing_or_asks_for_what_there_is_not(missing):
    assert list(chained(WRITTEN | {"phong": missing}, SIZE)) == [*MILESTONES[: MILESTONES.index("phong")]]


@pytest.mark.parametrize("buffer", MILESTONES)
def test_a_function_may_read_what_is_before_it_and_not_itself(buffer):
    known = readable(buffer)
    assert buffer not in known and "image" not in known
    assert {"position_world", "light_distance", "light_position", "tap_weight"} <= set(known)


def test_what_stands_beside_the_model_does_not_matter():
    right = oracle()["thickness"]
    drawn = oracle()["coverage"] != 0
    assert np.array_equal(as_buffer("thickness", np.where(drawn, right, np.nan)), right)
