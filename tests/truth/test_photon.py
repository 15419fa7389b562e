"""Photons one by one: where each ends, to the last bit, and the faces that it meets."""

import math

import pytest

from sss_ref.numerics.random_numbers import new_stream
from sss_ref.truth.photon import (
    ABSORBED,
    REFLECTED,
    TRANSMITTED,
    Setup,
    Volume,
    distance_to_face,
    entering,
    leaves,
    walk,
)
from sss_ref.truth.samplers import reflectance

FORWARD = Volume(2.0, 0.1, 0.6, 1.4)
ENDS = {  # of photons 0 to 4 of seed 5: the fate, x and y, mm, and how often it was scattered
    (FORWARD, Setup(1.5, True)): [
        (2, -0.1212010323944978, -0.28164138252781123, 3),
        (2, 0.10807585422764301, 1.0562093006171231, 17),
        (0, -1.9424632176394896, -0.373058727381664, 4),
        (1, -0.1576047526298605, -1.0526108816635573, 7),
        (2, 1.458016818196406, 1.0889277632757013, 4),
    ],
    (FORWARD, Setup(1.5, False)): [
        (2, -0.05899048924943155, -0.14929526492982545, 3),
        (1, 0.0, 0.0, 0),
        (0, -2.7048234808466787, -0.8940042833753035, 16),
        (2, -2.694963990802168, 1.6334018136187494, 9),
        (2, 1.815191851358439, 1.7561921028659921, 4),
    ],
    (Volume(1.0, 0.3), Setup(math.inf, True)): [
        (0, 1.0594805041352415, 0.950456276910004, 9),
        (0, 0.0184113847382891, -0.079433003816742, 1),
        (0, -0.0009866666394604804, 0.002006630574247795, 1),
        (2, -0.5350552742309953, -1.4176716760502008, 2),
        (2, 0.12404834209896462, -0.06411250331595596, 0),
    ],
    (Volume(1.0, 0.3, -0.5), Setup(math.inf, False)): [
        (2, -0.1409362591102455, -0.2612232959782186, 3),
        (2, -1.889860953460548, 0.5088955988158641, 8),
        (2, -0.07651673351233362, 0.13660915661287618, 1),
        (0, -0.13691737920697314, -0.07847420918241, 1),
        (2, 0.0, 0.0, 0),
    ],
}


@pytest.mark.parametrize(("volume", "setup"), ENDS, ids=str)
def test_photons_end_at_the_same_bits_everywhere(volume, setup):
    assert [walk(new_stream(5, photon), volume, setup) for photon in range(5)] == ENDS[volume, setup]


def test_what_becomes_of_photons_is_the_place_of_their_counts():
    assert (REFLECTED, TRANSMITTED, ABSORBED) == (0, 1, 2)


@pytest.mark.parametrize(
    ("z", "along", "distance"),
    [(0.5, 0.5, 3.0), (0.5, -0.5, 1.0), (0.0, 1.0, 2.0), (0.0, -1.0, 0.0), (2.0, 1.0, 0.0), (0.5, 0.0, math.inf)],
)
def test_how_far_a_face_of_a_slab_of_2_mm_is(z, along, distance):
    assert distance_to_face(z, along, 2.0) == distance


def test_a_border_that_light_does_not_notice_draws_nothing():
    stream = new_stream(1)
    assert leaves(stream, 0.1, 1.0) and not stream[0]
    assert not leaves(stream, 0.1, 1.4) and stream[0] == 1  # beyond the critical angle


def test_a_photon_leaves_as_often_as_it_is_not_reflected():
    stream = new_stream(2)
    out = sum(leaves(stream, 0.75, 1.4) for _ in range(4000)) / 4000
    expected = 1 - reflectance(0.75, 1.4)
    assert 0.5 < expected < 0.95 and abs(out - expected) < 4 * math.sqrt(expected * (1 - expected) / 4000)


def test_light_straight_down_enters_straight_down():
    stream = new_stream(1)
    assert entering(stream, 1.4, False) == (0, 0, 1) and not stream[0]


def test_light_from_all_sides_is_refracted_towards_the_normal():
    """Sines are divided by 1.4; the mean of the squared ones outside is a half, less what is reflected when low."""
    stream = new_stream(1)
    found = [entering(stream, 1.4, True) for _ in range(2000)]
    assert all(x * x + y * y + z * z == pytest.approx(1, abs=1e-15) and z > math.sqrt(1 - 1.4**-2) for x, y, z in found)
    assert 0.44 < 1.4**2 * sum(x * x + y * y for x, y, _ in found) / 2000 < 0.49
