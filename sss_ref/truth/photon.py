"""One photon in a half-space or a slab of one material: it goes straight, is absorbed or scattered, until it leaves.

z points into the body; its faces are z = 0, where the photon enters at x = y = 0, and z = thickness.
"""

import math
from typing import NamedTuple

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.random_numbers import uniform
from sss_ref.truth.samplers import cosine_direction, exponential, reflectance, scattered

REFLECTED, TRANSMITTED, ABSORBED = 0, 1, 2  # what becomes of a photon


class Volume(NamedTuple):
    """What light of one colour meets in a material."""

    scattering: float  # per mm
    absorption: float  # per mm
    anisotropy: float = 0.0  # g of Henyey and Greenstein; 0 with a reduced scattering coefficient
    ior: float = 1.0  # index of refraction, 1 or more: 1 is a border that light does not notice


class Setup(NamedTuple):
    """Where a photon walks, and how it enters."""

    thickness: float  # mm; inf is a half-space
    diffuse: bool  # whether light comes from all sides (cosine), or straight down


@compiled
def walk(stream, volume, setup):
    """Walk one photon: (what becomes of it, x, y, how often it was scattered); x, y in mm, where that happened."""
    extinction = volume.scattering + volume.absorption
    albedo = volume.scattering / extinction
    x, y, z = 0.0, 0.0, 0.0
    direction = entering(stream, volume.ior, setup.diffuse)
    scatterings = 0
    while True:
        ahead = exponential(stream) / extinction
        while True:
            to_face = distance_to_face(z, direction[2], setup.thickness)
            if ahead < to_face:
                break
            x, y = x + to_face * direction[0], y + to_face * direction[1]
            ahead -= to_face
            if leaves(stream, abs(direction[2]), volume.ior):
                return (TRANSMITTED if direction[2] > 0.0 else REFLECTED), x, y, scatterings
            z = setup.thickness if direction[2] > 0.0 else 0.0
            direction = (direction[0], direction[1], -direction[2])
        x, y, z = x + ahead * direction[0], y + ahead * direction[1], z + ahead * direction[2]
        if uniform(stream) >= albedo:
            return ABSORBED, x, y, scatterings
        direction = scattered(stream, direction, volume.anisotropy)
        scatterings += 1


@compiled
def entering(stream, ior, diffuse):
    """The direction inside of light that has entered; from all sides, it was not reflected and is refracted."""
    if not diffuse:
        return 0.0, 0.0, 1.0
    a, b, cosine = cosine_direction(stream)
    while not leaves(stream, cosine, 1.0 / ior):
        a, b, cosine = cosine_direction(stream)
    x, y = a / ior, b / ior
    return x, y, math.sqrt(1.0 - (x * x + y * y))


@compiled
def leaves(stream, cosine, ior):
    """Whether light crosses a border that it meets at an angle; see `reflectance`. Nothing is drawn for ior 1."""
    return ior == 1.0 or uniform(stream) >= reflectance(cosine, ior)


@compiled
def distance_to_face(z, along, thickness):
    """How far the face is that light reaches, mm; `along`: its direction's z."""
    if along > 0.0:
        return (thickness - z) / along
    return z / -along if along < 0.0 else math.inf
