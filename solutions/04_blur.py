"""Solutions of lesson 4."""

from sss_ref.language import select, vec3
from sss_ref.passes.composite import Image


def colour_kept(weights):
    """Each colour is divided by its own sum."""
    return weights / weights.sum(axis=0)


def stencilled(scattered: vec3, coverage: bool, background: vec3) -> Image:
    """The model where it is, the background elsewhere."""
    return Image(select(coverage, scattered, background))


weight_given_back_in_glsl = """
vec3 renormalized(vec3 total, vec3 kept, vec3 all_weights) {
    return total * (all_weights / kept);
}
"""
