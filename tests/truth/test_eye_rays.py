"""The rays of small cameras, and the sums of a row of pixels."""

import hashlib

import numpy as np
import pytest
from lit_boxes import parallel, scenery

from sss_ref.numerics.random_numbers import new_stream, uniform
from sss_ref.truth.eye_rays import Eye, Sums, eye_ray, gather_row
from sss_ref.truth.path import gathered
from sss_ref.truth.photon import Volume

EYE = Eye(
    np.array([1.0, 2, 9]), np.array([0.0, 0, -1]), np.array([0.75, 0, 0]), np.array([0.0, 0.5, 0]), False, 4, 2, 0.0
)
SKEW = EYE._replace(across=np.array([0.3, 0.2, 0.1]), up=np.array([-0.1, 0.2, 0.4]))
LIT = scenery(parallel((0.0, 0.6, 0.8), (1, 2, 3)))
VOLUMES = Volume(2.0, 0.5), Volume(3.0, 0.25, 0.5), Volume(1.0, 1.0)


@pytest.mark.parametrize(
    ("x", "y", "direction"),
    [(2, 1, (0, 0, -1)), (4, 1, (0.6, 0, -0.8)), (0, 1, (-0.6, 0, -0.8)), (2, 2, (0, 0.2**0.5, -2 * 0.2**0.5))],
)
def test_a_ray_of_a_perspective_goes_through_a_point_of_the_picture(x, y, direction):
    origin, found = eye_ray(EYE, float(x), float(y))
    assert origin == (1, 2, 9) and found == pytest.approx(direction, abs=1e-15)


def test_without_perspective_rays_are_beside_each_other():
    flat = EYE._replace(is_parallel=True)
    assert eye_ray(flat, 4.0, 1.0) == ((1.75, 2, 9), (0, 0, -1))
    assert eye_ray(flat, 2.0, 0.0) == ((1, 1.5, 9), (0, 0, -1))
    origin, _ = eye_ray(SKEW._replace(is_parallel=True), 4.0, 2.0)
    assert origin == pytest.approx((1.2, 2.4, 9.5), abs=1e-15)


def test_a_picture_that_is_askew():
    """(.5, -.5) of the way to its borders: ahead and (.15 + .05, .1 - .1, .05 - .2)."""
    ahead = np.array([0.25, 0.5, -1.0])
    _, found = eye_ray(SKEW._replace(ahead=ahead), 3.0, 0.5)
    expected = ahead + np.array([0.2, 0, -0.15])
    assert found == pytest.approx(expected / np.sqrt((expected**2).sum()), abs=1e-15)


def sums_of(eye, samples):
    shape = (eye.height, eye.width, 3)
    sums = Sums(np.zeros(shape), np.zeros(shape), np.zeros(shape, np.int64))
    for row in range(eye.height):
        gather_row(new_stream(7), LIT, VOLUMES, eye, row, samples, sums)
    return sums


ACROSS = EYE._replace(origin=np.array([0.25, 0, 4.0]), width=3, spread=1.0)


def test_sums_have_the_same_bits_everywhere():
    sums = sums_of(ACROSS, (2, 5))
    assert (sums.counted == 3).all() and sums.total.any(axis=2)[:, 1:].any()
    assert hashlib.sha256(sums.total.tobytes() + sums.square.tobytes()).hexdigest()[:16] == "f72cabee6202e72e"


def test_every_sample_of_a_pixel_and_channel_has_its_own_numbers():
    """The sample's number above 32 bits, below them pixel after pixel its three channels."""
    sums = sums_of(ACROSS._replace(spread=0.0), (3, 5))
    for row, column, channel in np.ndindex(2, 3, 3):
        stream = [new_stream(7, (sample << 32) + (row * 3 + column) * 3 + channel) for sample in (3, 4)]
        assert all(uniform(each) < 1 and uniform(each) < 1 for each in stream)  # the place in the pixel
        ray = eye_ray(ACROSS, column + 0.5, row + 0.5)
        one, two = (gathered(each, LIT, VOLUMES[channel], ray, channel) for each in stream)
        assert sums.total[row, column, channel] == one + two
        assert sums.square[row, column, channel] == one * one + two * two
