"""Stages at some pixels: how well what they give fits what was got there."""

from types import SimpleNamespace

import numpy as np
import pytest
from checked import check_of

from sss_ref.language import vec3
from sss_ref.passes.phong import light_constant
from sss_ref.validation.cause import sample as module
from sss_ref.validation.cause.sample import Sample, fit_of

COUNT = 40
COLOUR = vec3(*np.float32([1, 2, 3]))


def sample_at(count=COUNT, reach=0.0, off=0.0, wrong=()):
    """The light at some pixels, whose intensity is 0, 1, 2 and so on; some of what was got is off, if not wrong."""
    intensity = np.arange(count, dtype=np.float32)
    got = intensity[:, None] * [1.0, 2.0, 3.0] + off
    is_wrong = np.isin(np.arange(count), wrong)
    at = np.arange(count), np.arange(count) + 100
    return Sample(light_constant, [COLOUR, intensity], "incident_light", at, got, np.full((count, 3), reach), is_wrong)


@pytest.mark.parametrize(
    ("holds", "wrong", "fit"),
    [
        ([1, 1, 0, 0], [1, 0, 1, 0], (0.5, 0.5)),
        ([1, 1, 1, 0], [1, 1, 0, 0], (1, 0.5)),
        ([1, 0, 1, 1], [0, 0, 0, 0], (0, 0.75)),
        ([0, 0, 1, 1], [1, 1, 1, 1], (0.5, 1)),
    ],
)
def test_two_shares(holds, wrong, fit):
    assert fit_of(np.array(holds, bool), np.array(wrong, bool)) == fit


def test_values_fit_up_to_their_reach_in_every_channel():
    sample = sample_at(reach=0.5, wrong=[0, 1])
    values = sample.got.copy()
    values[0, 1] += 0.5
    values[1, 2] -= 0.75
    values[5] = np.nan
    assert sample.fit(values) == (0.5, 37 / 38)


def test_a_stage_is_run_with_other_inputs():
    sample = sample_at()
    assert np.array_equal(sample.with_inputs({}), sample.got)
    assert np.array_equal(sample.with_inputs({"light_intensity": np.float32(2)}), [[2, 4, 6]])
    assert sample.own_name == "incident_light" and [*sample.given] == ["light_color", "light_intensity"]


def test_every_fifteenth_pixel_is_left_and_what_all_share_stays():
    few = sample_at(wrong=[15]).thinned()
    assert few.given["light_intensity"].tolist() == [0, 15, 30] and [*few.given["light_color"]] == [1, 2, 3]
    assert few.got[:, 0].tolist() == [0, 15, 30] and few.wrong.tolist() == [False, True, False]
    assert [each.tolist() for each in few.at] == [[0, 15, 30], [100, 115, 130]] and few.reach.shape == (3, 3)


def test_pixels_are_repeated():
    many = sample_at(3).repeated(2)
    assert many.given["light_intensity"].tolist() == [0, 1, 2, 0, 1, 2] and many.got.shape == (6, 3)


def chosen(wrong, where):
    check = check_of(np.zeros(np.shape(wrong)), np.zeros(np.shape(wrong)), where=where)
    rows, columns = module._chosen(check, np.array(wrong, bool))
    return [*zip(rows.tolist(), columns.tolist(), strict=True)]


def test_half_of_the_pixels_are_wrong_ones():
    at = chosen([[1, 1, 0], [0, 0, 0]], [[True, True, True], [True, False, True]])
    assert len(at) == 600 and set(at[:300]) == {(0, 0), (0, 1)} and set(at[300:]) == {(0, 2), (1, 0), (1, 2)}
    assert len(chosen([[0, 0]], [[True, True]])) == 300
    alone = chosen([[1, 0]], [[True, False]])
    assert len(alone) == 300 and set(alone) == {(0, 0)}


def test_a_stage_that_is_not_in_the_pass_has_no_sample():
    drawn = SimpleNamespace(this_pass=SimpleNamespace(stages=[light_constant]))
    wrong = np.ones((1, 1), bool)
    assert module.sample_of(check_of([[0.0]], [[0.0]], stage="rasterizer"), drawn, wrong) is None
    assert module.chain_sample_of(check_of([[0.0]], [[0.0]], buffer="depth"), drawn, wrong) is None
