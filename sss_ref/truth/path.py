"""One path from the eye through the body, and the light that it gathers (compiled).

With a `matched` border light does not notice the surface: from every scattering a straight ray goes to each light, and
is dimmed by what it passes inside the body, wherever it comes out and in again. With a `diffuse` border, the one of
Jensen et al. (2001), light enters and leaves as by a white diffuser under Fresnel's border: the path ends where it
leaves, and there it gathers what falls on the surface. With the border `entered` it does the same, but all that falls
on the surface enters, and all that leaves is seen: Fresnel's border reflects inside alone.
"""

import math
from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.random_numbers import uniform
from sss_ref.numerics.scalar import exp_scalar
from sss_ref.truth.photon import entering, leaves
from sss_ref.truth.rays import NO_TRIANGLE, inside_length, nearest, normal
from sss_ref.truth.samplers import about, exponential, reflectance, scattered

LIGHTEST = 0.1  # the weight below which a path goes on with a probability, as much heavier
LOST = -1.0  # what a path gathers that has slipped between two triangles


class Illumination(NamedTuple):
    """The lights of a scene, float64.

    place: (L, 3) of a point light its position, of parallel rays the unit vector towards them. parallel: bool (L,).
    fades: bool (L,), whether with 1/D^2. power: (L, 3), colour times intensity.
    """

    place: np.ndarray
    parallel: np.ndarray
    fades: np.ndarray
    power: np.ndarray


class Scenery(NamedTuple):
    """All that a path meets besides the material of its colour."""

    tree: NamedTuple  # a BoxTree
    lights: Illumination
    is_matched: bool
    is_dimmed: bool  # whether what Fresnel's border reflects outside is taken off


@compiled
def gathered(stream, scenery, volume, ray, channel):
    """The radiance that one path along a ray (origin, direction) gathers in a channel; LOST for one that is lost."""
    if scenery.is_matched:
        return gathered_inside(stream, scenery, volume, ray, channel)
    return gathered_at_surface(stream, scenery, volume, ray, channel)


@compiled
def gathered_inside(stream, scenery, volume, ray, channel):
    """Of a body whose border light does not notice."""
    extinction = volume.scattering + volume.absorption
    origin, direction = ray
    weight, radiance, is_inside = 1.0, 0.0, False
    while True:
        ahead = exponential(stream) / extinction if is_inside else math.inf
        distance, triangle = nearest(scenery.tree, origin, direction, ahead, not is_inside)
        if distance == math.inf:
            return radiance
        origin = along(origin, direction, distance)
        if triangle != NO_TRIANGLE:
            is_inside = not is_inside
            continue
        weight *= volume.scattering / extinction
        lit = light_within(scenery, volume, origin, direction, channel)
        if lit == LOST:
            return LOST
        radiance += weight * lit
        weight = survived(stream, weight)
        if weight == 0.0:
            return radiance
        direction = scattered(stream, direction, volume.anisotropy)


@compiled
def light_within(scenery, volume, point, direction, channel):
    """What one scattering at a point throws back along a path: the light that reaches it, times the phase function."""
    lights, total = scenery.lights, 0.0
    for light in range(len(lights.power)):
        to_light, distance, strength = towards(lights, light, point, channel)
        length = inside_length(scenery.tree, point, to_light, distance)
        if length < 0.0:
            return LOST
        cosine = direction[0] * to_light[0] + direction[1] * to_light[1] + direction[2] * to_light[2]
        kept = np.float64(exp_scalar(-(volume.scattering + volume.absorption) * length))
        total += math.pi * strength * phase(cosine, volume.anisotropy) * kept
    return total


@compiled
def phase(cosine, anisotropy):
    """Henyey and Greenstein's phase function, 1/sr; cosine: between the directions before and after."""
    square = anisotropy * anisotropy
    base = 1.0 + square - 2.0 * anisotropy * cosine
    return (1.0 - square) / (4.0 * math.pi * base * math.sqrt(base))


@compiled
def gathered_at_surface(stream, scenery, volume, ray, channel):
    """Of a body under a diffuser: the path enters where the ray meets it, and ends where it leaves."""
    tree, extinction = scenery.tree, volume.scattering + volume.absorption
    distance, triangle = nearest(tree, ray[0], ray[1], math.inf, True)
    if triangle == NO_TRIANGLE:
        return 0.0
    facing = normal(tree, triangle)
    weight = 1.0
    if scenery.is_dimmed:
        weight -= reflectance(min(abs(dot(facing, ray[1])), 1.0), 1.0 / volume.ior)
    origin = along(ray[0], ray[1], distance)
    direction = about(opposite(facing), entering(stream, volume.ior, True))
    while True:
        ahead = exponential(stream) / extinction
        while True:
            distance, triangle = nearest(tree, origin, direction, ahead, False)
            origin = along(origin, direction, distance)
            if triangle == NO_TRIANGLE:
                break
            facing = normal(tree, triangle)
            cosine = min(dot(facing, direction), 1.0)
            if leaves(stream, cosine, volume.ior):
                return weight * light_on(scenery, volume, origin, facing, channel)
            ahead -= distance
            direction = along(direction, facing, -2.0 * cosine)
        weight = survived(stream, weight * volume.scattering / extinction)
        if weight == 0.0:
            return 0.0
        direction = scattered(stream, direction, volume.anisotropy)


@compiled
def light_on(scenery, volume, point, facing, channel):
    """The radiance of a white diffuser under the border, lit by what enters at a point of the surface."""
    lights, total = scenery.lights, 0.0
    for light in range(len(lights.power)):
        to_light, distance, strength = towards(lights, light, point, channel)
        cosine = dot(facing, to_light)
        if cosine > 0.0 and nearest(scenery.tree, point, to_light, distance, True)[1] == NO_TRIANGLE:
            kept = 1.0 - reflectance(min(cosine, 1.0), 1.0 / volume.ior) if scenery.is_dimmed else 1.0
            total += strength * cosine * kept
    return total


@compiled
def towards(lights, light, point, channel):
    """The direction to a light, its distance, and its strength e at a point; the irradiance is pi * e."""
    power = lights.power[light, channel]
    x, y, z = lights.place[light, 0], lights.place[light, 1], lights.place[light, 2]
    if lights.parallel[light]:
        return (x, y, z), math.inf, power
    x, y, z = x - point[0], y - point[1], z - point[2]
    square = x * x + y * y + z * z
    distance = math.sqrt(square)
    return (x / distance, y / distance, z / distance), distance, power / square if lights.fades[light] else power


@compiled
def survived(stream, weight):
    """The weight with which a path goes on: a light one often ends, with 0, or becomes as much heavier."""
    if weight >= LIGHTEST:
        return weight
    return LIGHTEST if uniform(stream) * LIGHTEST < weight else 0.0


@compiled
def along(origin, direction, distance):
    """origin + direction * distance."""
    return (
        origin[0] + distance * direction[0],
        origin[1] + distance * direction[1],
        origin[2] + distance * direction[2],
    )


@compiled
def dot(a, b):
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled
def opposite(direction):
    """The direction turned round."""
    return -direction[0], -direction[1], -direction[2]
