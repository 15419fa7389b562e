"""What is drawn has the moments it should have, within four standard errors for these seeds."""

import math

import numpy as np
import pytest

from sss_ref.numerics.random_numbers import new_stream
from sss_ref.truth.samplers import about, cosine_direction, exponential, in_disc, reflectance, scattered

DRAWS = 20_000


def assert_mean(values, expected):
    values = np.array(values)
    assert abs(values.mean() - expected) < 4 * values.std() / math.sqrt(len(values))


def test_free_paths_fall_off_as_e_to_the_minus_t():
    stream = new_stream(1)
    drawn = np.array([exponential(stream) for _ in range(DRAWS)])
    assert_mean(drawn, 1)
    assert_mean(drawn**2, 2)
    for t in (0.1, 1, 3):
        assert_mean(drawn > t, math.exp(-t))


def test_points_fill_the_disc_evenly():
    stream = new_stream(2)
    a, b, q = np.array([in_disc(stream) for _ in range(DRAWS)]).T
    assert (q == a * a + b * b).all() and (q > 0).all() and (q < 1).all()
    assert_mean(q, 1 / 2)
    assert_mean(a * b, 0)


def test_diffuse_light_has_a_mean_cosine_of_two_thirds():
    stream = new_stream(3)
    drawn = np.array([cosine_direction(stream) for _ in range(DRAWS)])
    np.testing.assert_allclose((drawn**2).sum(axis=1), 1, atol=1e-12)  # a few roundings
    assert_mean(drawn[:, 2], 2 / 3)


@pytest.mark.parametrize("g", [0.0, 0.3, -0.6, 0.9])
@pytest.mark.parametrize("axis", [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.48, -0.6, 0.64), (0.48, 0.6, -0.64)])
def test_scattering_has_the_moments_of_henyey_and_greenstein(g, axis):
    """The mean of the n-th Legendre polynomial of the cosine is g^n."""
    stream = new_stream(4)
    drawn = np.array([scattered(stream, axis, g) for _ in range(DRAWS)])
    np.testing.assert_allclose((drawn**2).sum(axis=1), 1, atol=1e-12)  # a few roundings
    cosine = drawn @ np.array(axis)
    assert_mean(cosine, g)
    assert_mean((3 * cosine**2 - 1) / 2, g * g)
    across = np.cross(axis, (1.0, 0.0, 0.0) if abs(axis[0]) < 0.4 else (0.0, 1.0, 0.0))
    assert_mean(drawn @ across, 0)


def test_a_frame_is_of_unit_vectors_at_right_angles():
    axis = (0.36, 0.48, -0.8)
    frame = np.array([about(axis, one) for one in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))])
    np.testing.assert_allclose(frame @ frame.T, np.eye(3), atol=1e-15)  # a few roundings
    assert tuple(frame[2]) == axis


def test_reflection_at_a_smooth_border():
    assert reflectance(1.0, 1.5) == pytest.approx(0.04, abs=1e-15)
    assert reflectance(1.0, 1 / 1.5) == pytest.approx(0.04, abs=1e-15)
    assert reflectance(0.5, 1.5) == 1.0  # beyond the critical angle, cos = .745
    assert reflectance(0.5, 1.0) == 0.0
    brewster = 1 / math.sqrt(1 + 1.5**2)  # from outside: light in the plane is not reflected, half of the rest
    across = ((1 - 1.5**2) / (1 + 1.5**2)) ** 2
    assert reflectance(brewster, 1 / 1.5) == pytest.approx(across / 2, abs=1e-15)
    beyond = math.sqrt(1 - 1.5**2 * (1 - 0.9**2))
    assert reflectance(0.9, 1.5) == pytest.approx(reflectance(beyond, 1 / 1.5), abs=1e-15)  # the same both ways


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ((10, 20, 0), 10.5),  # the second is larger: a run of one
        ((20, 10, 15), None),  # a run of two: all anew
        ((10, 10, 0), 10.5),  # an equal one does not fall
    ],
)
def test_a_run_of_falling_numbers_ends_at_the_first_that_does_not_fall(words, expected):
    """Of a stream whose next three words are given; (w + 1/2) / 2^32 each."""
    stream = np.array([1, 0, 0, 0, *words], np.uint64)
    found = exponential(stream) * 2.0**32
    assert found == expected if expected else found > 2.0**32


FALLS = [2.3728947682539, 0.3009655453497544, 0.3956687432946637]
POINTS = [
    (0.18516049976460636, -0.7524342227261513, 0.6004416702025863),
    (-0.6745730747934431, 0.1995627956930548, 0.4948741426611081),
]
SCATTERED = {
    0.0: [
        (0.23408222373024387, -0.9512367718297919, -0.20088334040517264),
        (-0.9588679408960099, 0.28366736553225763, 0.010251714677783852),
    ],
    0.3: [
        (0.15554527206211521, -0.8447557465268949, -0.5120482370333004),
        (-0.4799279621930007, -0.21949228034799811, 0.8494070225592142),
    ],
    -0.6: [
        (-0.3958094263153054, 0.15335558868659827, -0.905437442045852),
        (-0.8551310796220368, 0.5053133636728581, -0.1157982778717877),
    ],
}


def test_what_is_drawn_has_the_same_bits_everywhere():
    streams = [new_stream(7, 3) for _ in range(3)]
    assert [exponential(streams[0]) for _ in FALLS] == FALLS
    assert [in_disc(streams[1]) for _ in POINTS] == POINTS
    assert [cosine_direction(streams[2]) for _ in POINTS] == [(a, b, math.sqrt(1 - q)) for a, b, q in POINTS]


@pytest.mark.parametrize("g", SCATTERED)
def test_a_scattering_has_the_same_bits_everywhere(g):
    stream = new_stream(7, 3)
    assert [scattered(stream, (0.48, -0.6, 0.64), g) for _ in range(2)] == SCATTERED[g]


def test_which_of_the_frames_about_an_axis_is_taken():
    assert about((1.0, 0.0, 0.0), (1.0, 0.0, 0.0)) == (0, 0, -1)  # as if z were above 0
    assert about((0.0, 1.0, 0.0), (0.36, 0.48, 0.8)) == (0.36, 0.8, -0.48)
    assert about((0.0, 0.0, -1.0), (0.36, 0.48, 0.8)) == (0.36, -0.48, -0.8)


def test_light_along_a_border_does_not_cross_it():
    assert reflectance(0.0, 1.0) == 1.0
    assert reflectance(0.0, 0.5) == 1.0
