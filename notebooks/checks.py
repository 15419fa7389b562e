"""The checks of the exercises: each takes a reader's function and raises `NotYet`, with a hint, if it is not right."""

import itertools
import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from dumps import WRONG_STAGE

from sss_ref.language import ivec2, nearest_texel, vec2, vec3
from sss_ref.passes.shadow_map import distance_to_light
from sss_ref.raster.coverage import EdgeFunction, at, edge_function, owns_its_samples


class NotYet(Exception):
    """What is still wrong with an answer."""


def verdict(check: Callable[[Any], None], answer: Callable[..., Any]) -> None:
    """Print what a check finds, so that a notebook runs on whatever the answer."""
    try:
        check(answer)
    except NotYet as hint:
        print("Not yet:", hint)
    else:
        print("Right.")


def near(value: Any, expected: Any) -> bool:
    """Whether two numbers, or the numbers of two arrays, agree to five digits: an answer need not round as we do."""
    return np.shape(value) == np.shape(expected) and bool(np.allclose(value, expected, rtol=1e-5, atol=1e-7))


def distance_of_a_wall(answer: Callable[[float, float], float]) -> None:
    """01: the distance D along a ray at an angle to the axis, of a wall at a depth in front of the light."""
    for depth, angle in [(2.0, 0.0), (2.0, 0.5), (5.0, -0.9), (3.0, 1.2)]:
        point = vec3(*map(np.float32, (depth * math.tan(angle), 0.0, -depth)))
        expected = float(distance_to_light(point, vec3(*np.zeros(3, np.float32))).light_distance)
        got = answer(depth, angle)
        if not near(got, expected):
            too = "near" if got < expected else "far"
            raise NotYet(
                f"at depth {depth:g} and {math.degrees(angle):.0f} degrees off the axis your wall is too {too}: "
                f"{got:.4f}, where the light's distance is {expected:.4f}. Draw the right-angled triangle."
            )


def cover_once(answer: Callable[[Sequence[int], Sequence[bool]], bool]) -> None:
    """02: a fill rule under which two triangles that share an edge cover each sample of their square once.

    The square has its corners on samples 0 and 4, its triangles meet on the diagonal. Samples on its right and upper
    border belong to whatever may lie beyond.
    """
    corners = (0, 0), (4, 0), (4, 4), (0, 4)
    triangles = [_edges(*(corners[k] for k in chosen)) for chosen in ((0, 1, 2), (0, 2, 3))]
    for column, row in itertools.product(range(5), repeat=2):
        drawn = [answer([at(e, column, row) for e in edges], [*map(owns_its_samples, edges)]) for edges in triangles]
        count, expected = sum(map(bool, drawn)), int(column < 4 and row < 4)
        if count != expected:
            where = "on their common edge" if column == row else "elsewhere"
            raise NotYet(
                f"sample ({column}, {row}), {where}, is drawn {count} times, not {expected}. "
                "What tells the two triangles apart where an edge function is 0?"
            )


def _edges(a: tuple[int, int], b: tuple[int, int], c: tuple[int, int]) -> list[EdgeFunction]:
    """The edges of a counter-clockwise triangle with its corners on samples."""
    return [edge_function(start, end, 1, 1) for start, end in ((a, b), (b, c), (c, a))]


def mirrored(answer: Callable[[vec3, vec3], vec3]) -> None:
    """03: the direction in which a mirror with this normal sends the light that comes from `to_light`."""
    generator = np.random.default_rng(3)
    for _ in range(8):
        normal, to_light = (v / np.linalg.norm(v) for v in generator.normal(size=(2, 3)))
        to_light = to_light if normal @ to_light > 0 else -to_light
        got = np.array([*answer(vec3(*map(np.float32, normal)), vec3(*map(np.float32, to_light)))], float)
        if abs(got @ got - 1) > 1e-4:
            raise NotYet(f"a mirrored direction is as long as the direction itself, 1, and yours is {got @ got:.3f}.")
        if got @ normal < 0:
            raise NotYet("your direction points into the surface. Which way does `reflect` expect the light to run?")
        if not near(got, 2 * (normal @ to_light) * normal - to_light):
            raise NotYet("the angle to the normal is not the same before and after; or it left the plane of the two.")


def colour_kept(answer: Callable[[np.ndarray], np.ndarray]) -> None:
    """04: tap weights (13, 3) scaled so that a white surface stays white."""
    weights = np.random.default_rng(4).uniform(0.1, 1.0, (13, 3)) * [1.0, 2.0, 3.0]
    got = np.asarray(answer(weights.copy()), float)
    if got.shape != weights.shape:
        raise NotYet(f"expected {weights.shape} weights, got {got.shape}.")
    sums = got.sum(axis=0)
    if not near(sums, np.ones(3)):
        seen = ", ".join(f"{each:.3f}" for each in sums)
        raise NotYet(f"a white surface comes out as ({seen}). Every channel has to keep its own light.")
    if not near(got / got[0], weights / weights[0]):
        raise NotYet("the sums are right, but the taps no longer have their proportions: scale, do not shift.")


def way_inside(answer: Callable[[Sequence[float]], float]) -> None:
    """05: how far a ray runs inside bodies, from the distances at which it enters and leaves them in turn."""
    for crossings in ([1.0, 3.0], [1.0, 1.5, 4.0, 4.25], [0.5, 1.0, 2.0, 4.0, 4.5, 4.75]):
        expected = sum(crossings[1::2]) - sum(crossings[::2])
        got = answer(crossings)
        if not near(got, expected):
            raise NotYet(
                f"a ray that crosses surfaces at {crossings} runs {expected:g} inside, and yours {got:g}. "
                "Which of the stretches between two crossings are body, and which are air?"
            )


def texel_that_holds(answer: Callable[[float, int], int]) -> None:
    """06: the column of the texel that holds a texture coordinate."""
    for width in (4, 7, 1024):
        for u in (0.0, 0.1, 0.24, 0.26, 0.499, 0.5, 0.74, 0.99, 1.0):
            at = nearest_texel(ivec2(np.int32(width), np.int32(1)), vec2(np.float32(u), np.float32(0)))
            got = answer(u, width)
            if got != at.x:
                raise NotYet(
                    f"u = {u:g} lies in column {at.x} of {width}, and you say {got}. "
                    "Texel i reaches from i/width to (i + 1)/width, and the last one also holds u = 1."
                )


def blur_on_the_body(answer: Callable[[float, float, float, int], float]) -> None:
    """07: the length on a surface that faces the camera which so many pixels span."""
    for pixels, distance, fov_y, height in [(6.0, 4.0, 90.0, 100), (6.0, 8.0, 90.0, 100), (2.0, 4.2, 31.0, 1024)]:
        expected = pixels * 2.0 * distance * math.tan(math.radians(fov_y) / 2) / height
        got = answer(pixels, distance, fov_y, height)
        if not near(got, expected):
            raise NotYet(
                f"{pixels:g} of {height} pixels at distance {distance:g} with {fov_y:g} degrees span {expected:.5f} "
                f"scene units, and yours {got:.5f}. How high is the whole picture out there?"
            )


def ulps_between(answer: Callable[[np.float32, np.float32], int]) -> None:
    """08: how many steps lead from one float32 to another; both are positive."""
    zero, least, one, two = np.float32(0), np.float32(2.0**-149), np.float32(1), np.float32(2)
    pairs = [(one, one), (np.nextafter(two, one), two), (one, two), (two, np.float32(3)), (np.float32(0.5), two)]
    for a, b in [*pairs, (zero, least), (np.float32(4), np.nextafter(np.float32(4), zero))]:
        expected = abs(int(a.view(np.int32)) - int(b.view(np.int32)))
        got = answer(a, b)
        if got != expected:
            raise NotYet(
                f"from {a!s} to {b!s} there are {expected} steps, and you count {got}. "
                "The steps change at every power of two; what does not change is how the bit patterns are ordered."
            )


def wrong_stages(answer: Callable[[], dict[str, str | None]]) -> None:
    """09: the stage that is wrong in each of the dumps A, B and C; None for the one that is right."""
    got = answer()
    for name, expected in WRONG_STAGE.items():
        if name not in got:
            raise NotYet(f"nothing is said of {name}.")
        if got[name] == expected:
            continue
        if expected is None:
            raise NotYet(f"{name} has other bits than the oracle. Could a right processor have them?")
        if got[name] is None:
            raise NotYet(f"{name} looks right. Give `sss_ref.validate` its buffers.")
        raise NotYet(f"{got[name]} is not what is wrong in {name}: did it make a mistake, or was it given one?")
