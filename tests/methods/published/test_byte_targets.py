"""Targets of eight bits, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.methods.published.byte_targets import stored_r8, stored_rgb8

STEPS = [
    (0, 0),
    (1, 255),
    (7.5, 255),
    (-0.25, 0),
    (0.5, 128),  # 127.5 lies between 127 and 128: up
    (0.001953125, 0),  # .498
    (0.0019607844, 1),  # .50000002
    (2 / 255, 2),
    (0.99803925, 255),  # 254.5000...: the first that is 255
    (0.998, 254),
]


@pytest.mark.parametrize(("value", "step"), STEPS)
def test_stored_r8(value, step):
    assert call(stored_r8, value=value) == (np.float32(step) / np.float32(255),)


def test_stored_rgb8():
    thirds = np.float32([85, 170, 255]) / np.float32(255)
    assert call(stored_rgb8, color=(0.3333, 0.6667, 1.5)) == (tuple(thirds.tolist()),)


def test_what_is_stored_stays_as_it_is():
    steps = np.arange(256, dtype=np.float32) / np.float32(255)
    assert [call(stored_r8, value=step)[0] for step in steps] == steps.tolist()
