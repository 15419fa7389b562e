"""Witnesses of pixels that a wrong stage drew: a small sphere of which one buffer was drawn by another scene."""

from functools import cache

import numpy as np

import sss_ref
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

CAUSES_UNTRIED = sss_ref.Scope(seconds=0, power=False)
TWO_LIGHTS = {"lights": [{"position": [2.0, 1.5, 2.6]}, {"position": [-2.0, 1.5, 2.6], "color": [0.5, 0.7, 1.0]}]}
WRONG = {  # buffer that is wrong -> what draws it so, and what else the scene has
    "phong": ({"phong.shininess": 20.0}, {}),
    "translucency": ({"translucency.exponent": 0.751}, {}),
    "scattered": ({"blur.pixel_scale": 1.5}, {}),
    "phong_2": ({"phong.shininess": 20.0}, TWO_LIGHTS),
    "lit": ({"translucency.scale": [0.1, 0.2, 0.3]}, {"translucency.scale": [0.2, 0.3, 0.4]}),
    "directly_lit": ({"lights": [{"position": [-2.0, 1.5, 2.6]}]}, {}),
}
SMALL = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}


def small(**overrides):
    """A sphere at 32 x 32 pixels, rendered."""
    given = {"preset": "robust", "method": "screen_space", "shadow_map.test": "slope"}
    return render(load_scene("sphere", **SMALL, **(given | overrides)), "arrays")


@cache
def mistaken(name):
    """A scene's rendering and what a renderer drew of it with one buffer wrong."""
    change, shared = WRONG[name]
    right = small(**shared)
    return right, dict(right.buffers) | {name: small(**(shared | change))[name]}


@cache
def witness_of(name):
    """The witness of that buffer."""
    return found_in(*mistaken(name))


def found_in(right, buffers, **options):
    """The witness of the first stage that is wrong."""
    return sss_ref.validate(right, buffers, explain=CAUSES_UNTRIED, **options).finding.witness


def same_bits(a, b):
    """Whether two arrays have the same bits."""
    return a.dtype == b.dtype and np.array_equal(a.view(np.uint8), b.view(np.uint8))
