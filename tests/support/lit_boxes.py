"""Boxes and lights as paths meet them, without a scene."""

import numpy as np
from boxes import CORNERS, FACES

from sss_ref.truth.box_tree import box_tree_of
from sss_ref.truth.path import Illumination, Scenery

CUBE = ((-1, -1, -1), (1, 1, 1))


def boxes(*ends):
    """The triangles of boxes, each from a corner to the opposite one."""
    fans = [(face[0], *face[k : k + 2]) for face in FACES for k in (1, 2)]
    return np.array(
        [[[both[CORNERS[c - 1][axis]][axis] for axis in range(3)] for c in fan] for both in ends for fan in fans], float
    )


def lamps(*each):
    """Lights: place, whether parallel, whether fading, power."""
    places, parallel, fades, powers = zip(*each, strict=True)
    return Illumination(np.array(places, float), np.array(parallel), np.array(fades), np.array(powers, float))


def scenery(*lights, ends=(CUBE,), matched=True, dimmed=False):
    """All that a path meets; ends: the corners of boxes."""
    return Scenery(box_tree_of(boxes(*ends)), lamps(*lights), matched, dimmed)


def parallel(towards, power=(1, 1, 1)):
    """Light from far away, in a direction."""
    return towards, True, False, power
