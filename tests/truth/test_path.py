"""Paths in boxes: each part by hand, and whole paths to the last bit."""

import math

import numpy as np
import pytest
from lit_boxes import CUBE, lamps, parallel, scenery

from sss_ref.numerics.random_numbers import new_stream
from sss_ref.truth.path import (
    LOST,
    along,
    dot,
    gathered,
    light_on,
    light_within,
    opposite,
    phase,
    survived,
    towards,
)
from sss_ref.truth.photon import Volume
from sss_ref.truth.samplers import reflectance

ROUNDED = {"rel": 1e-12}
UP, ASIDE = (0.0, 0.0, 1.0), (-1.0, 0.0, 0.0)


def test_a_light_has_a_direction_a_distance_and_a_strength_of_its_channel():
    lights = lamps(
        ((0, 0, 5), False, False, (2, 3, 4)), ((0, 0, 5), False, True, (2, 3, 4)), parallel((0, 0.6, 0.8), (5, 6, 7))
    )
    point = (0.0, 4.0, 2.0)
    assert towards(lights, 0, point, 1) == ((0, -0.8, 0.6), 5, 3)
    assert towards(lights, 1, point, 2) == ((0, -0.8, 0.6), 5, 4 / 25)
    assert towards(lights, 2, point, 0) == ((0, 0.6, 0.8), math.inf, 5)
    assert towards(lights, 0, (-3.0, 0.0, 1.0), 0) == ((0.6, 0, 0.8), 5, 2)


def test_the_phase_function_of_henyey_and_greenstein():
    assert phase(0.3, 0.0) == pytest.approx(1 / (4 * math.pi), **ROUNDED)
    assert phase(1.0, 0.5) == pytest.approx(6 / (4 * math.pi), **ROUNDED)  # .75 / .25^1.5
    assert phase(-1.0, 0.5) == pytest.approx(0.75 / (4 * math.pi * 3.375), **ROUNDED)
    assert phase(0.5, -0.5) == pytest.approx(0.75 / (4 * math.pi * 1.75**1.5), **ROUNDED)


def test_the_vectors_of_a_path():
    assert along((1.0, 2.0, 3.0), (4.0, 5.0, 6.0), 2.0) == (9, 12, 15)
    assert dot((1.0, 2.0, 3.0), (4.0, 5.0, 6.0)) == 32
    assert opposite((1.0, -2.0, 3.0)) == (-1, 2, -3)


def test_light_reaches_a_point_inside_dimmed_by_the_way_there():
    """e/4 * e^(-2 * .75) from above and 3e/4 * e^(-2) from the side, scattered evenly: pi * e / (4 pi)."""
    lit = scenery(parallel(UP, (1, 4, 1)), parallel(ASIDE, (1, 12, 1)))
    found = light_within(lit, Volume(1.5, 0.5), (0.0, 0.2, 0.25), (0.0, 0.0, -1.0), 1)
    assert found == pytest.approx(math.exp(-1.5) + 3 * math.exp(-2), rel=1e-7)  # e^x is rounded to float32
    assert light_within(lit, Volume(1.5, 0.5), (0.0, 0.2, 1.0), UP, 0) == pytest.approx(
        (1 + math.exp(-2)) / 4, rel=1e-7
    )


@pytest.mark.parametrize(("direction", "cosine"), [(UP, 1), ((0.0, 0.0, -1.0), -1), ((0.0, 0.6, -0.8), -0.8)])
def test_light_is_scattered_by_the_angle_to_its_way(direction, cosine):
    found = light_within(scenery(parallel(UP)), Volume(1.0, 1.0, 0.5), (0.0, 0.2, 1.0), direction, 0)
    assert found == pytest.approx(math.pi * phase(cosine, 0.5), **ROUNDED)


@pytest.mark.parametrize("aside", [(0.6, 0.0, 0.8), (0.0, 0.6, 0.8), (0.6, 0.8, 0.0)])
def test_all_of_a_direction_is_in_the_angle(aside):
    found = light_within(scenery(parallel(aside)), Volume(0.0, 1e-9, 0.5), (0.0, 0.0, 0.0), (0.48, 0.6, 0.64), 0)
    assert found == pytest.approx(math.pi * phase(np.dot(aside, (0.48, 0.6, 0.64)), 0.5), rel=1e-6)


def test_a_way_that_does_not_leave_is_lost():
    assert light_within(scenery(parallel(UP)), Volume(1.0, 1.0), (0.0, 0.0, 3.0), UP, 0) == LOST == -1


def test_light_falls_on_a_face_by_its_cosine():
    faces = parallel((0, 0.6, 0.8), (2, 3, 4)), parallel((0, 0, -1), (9, 9, 9))
    assert light_on(scenery(*faces), Volume(1.0, 1.0), (0.0, 0.0, 1.0), UP, 2) == pytest.approx(3.2, **ROUNDED)
    both = scenery(*faces, parallel(UP, (1, 1, 1)))
    assert light_on(both, Volume(1.0, 1.0), (0.0, 0.0, 1.0), UP, 0) == pytest.approx(1.6 + 1, **ROUNDED)


def test_what_the_border_reflects_outside_is_taken_off_where_it_is_asked_for():
    dimmed = scenery(parallel((0, 0.6, 0.8)), dimmed=True)
    found = light_on(dimmed, Volume(1.0, 1.0, 0.0, 1.4), (0.0, 0.0, 1.0), UP, 0)
    assert found == pytest.approx(0.8 * (1 - reflectance(0.8, 1 / 1.4)), **ROUNDED)


@pytest.mark.parametrize(("height", "light"), [(2.5, 0), (2.0, 2), (1.5, 2)])
def test_another_part_of_the_body_shades_a_face_from_what_lies_beyond_it(height, light):
    """Its lower face is at 2; a light on it, and one before it, is not shaded."""
    body = CUBE, ((-1, -1, 2), (1, 1, 3))
    lit = scenery(((0, 0, height), False, False, (2, 2, 2)), ends=body)
    assert light_on(lit, Volume(1.0, 1.0), (0.0, 0.0, 1.0), UP, 0) == light


def test_a_path_as_light_as_a_tenth_goes_on():
    stream = new_stream(1)
    assert survived(stream, 0.1) == 0.1 and not stream[0]  # nothing is drawn


def walks(volume, **kind):
    lights = parallel((0, 0.6, 0.8), (1, 2, 3)), ((0.5, 1, 4), False, True, (30, 20, 10))
    scene = scenery(*lights, **kind)
    rays = [((0.1 * k, 1.2, 4.5), (0.0, -0.28, -0.96)) for k in range(8)]
    return [gathered(new_stream(3, k), scene, volume, ray, k % 3) for k, ray in enumerate(rays)]


FORWARD = Volume(6.0, 0.25, 0.6, 1.4)


GATHERED = {  # volume and border -> of eight rays
    (FORWARD, "matched"): [
        0.21485489460907214,
        0.36207800540774593,
        1.8613337875833267,
        4.240877951780536,
        2.640743749878051,
        0.015135359941869903,
        0.4329583277813176,
        6.234214574207575,
    ],
    (FORWARD, "diffuse"): [0.0, 0.0, 0.2442182489201638, 1.207759330955731, 0.0, 0.0, 0.6378568310915433, 0.0],
    (FORWARD, "entered"): [0.0, 0.0, 0.26425332340909546, 1.280492787594326, 0.0, 0.0, 0.6753756052422087, 0.0],
    (Volume(2.0, 1.0), "matched"): [
        0.1277081189150412,
        0.8494867040017651,
        0.9224554882337612,
        0.9117962627154249,
        0.43892835572597705,
        0.048689797563797634,
        0.4117738977145283,
        0.9496422266297525,
    ],
    (Volume(2.0, 0.0), "matched"): [
        0.46744774325431737,
        1.1871683107012752,
        0.8325726200941457,
        1.6509724940840536,
        1.9295771012096368,
        0.06985450958716208,
        0.12068767275130797,
        2.2271225884240105,
    ],
    (Volume(2.0, 0.0), "entered"): [
        3.9079539407745187,
        0.0,
        0.0,
        2.9795548592610075,
        3.5879622975455234,
        3.4251745367871442,
        0.0,
        3.1600213651248477,
    ],
}


@pytest.mark.parametrize(("volume", "border"), GATHERED, ids=str)
def test_paths_gather_the_same_bits_everywhere(volume, border):
    found = walks(volume, matched=border == "matched", dimmed=border == "diffuse")
    assert found == GATHERED[volume, border]


def test_a_ray_beside_the_body_gathers_nothing():
    for matched in (True, False):
        ray = (2.0, 0.0, 5.0), (0.0, 0.0, -1.0)
        assert gathered(new_stream(3), scenery(parallel(UP), matched=matched), FORWARD, ray, 0) == 0
