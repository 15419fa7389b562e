"""A technique of your own: light of each colour is absorbed by its own law, T = e^(-sigma * d) per channel.

Red goes far in skin and blue does not, so thin parts glow red. The stage below takes the place of `lit_transmit`; array
code, compiled kernel, trace and GLSL come from its one source.
"""

from typing import NamedTuple

import sss_ref
from sss_ref.language import dot, exp, max, normalize, select, stage, vec3


class Lit(NamedTuple):
    """The model lit, and what the body lets through."""

    lit: vec3  # linear RGB
    transmittance: vec3  # a buffer of its own


@stage(source="Beer-Lambert law, per channel")
def lit_absorbed(
    phong: vec3, albedo: vec3, directly_lit: bool, thickness: float, incident_light: vec3, position_world: vec3,
    normal_world: vec3, light_position: vec3, ambient: float, extinction: vec3,
) -> Lit:  # fmt: skip
    """Phong where lit, else ambient; plus albedo*e*T*max(-N.L, 0), T a colour."""
    transmittance = exp(-extinction * thickness)
    from_behind = max(-dot(normal_world, normalize(light_position - position_world)), 0.0)
    reflected = select(directly_lit, phong, ambient * albedo)
    return Lit(reflected + (albedo * incident_light) * (transmittance * from_behind), transmittance)


two_cases = {"shadow_map.test": "slope", "translucency.combine": "transmit"}
scene = sss_ref.load_scene("figure3_with", **two_cases, **{"lights.0.position": [0.8, 0.7, -2.6]})
scene = sss_ref.with_stage(scene, "lit_transmit", lit_absorbed, extinction=(0.7, 2.5, 5.0))

if __name__ == "__main__":
    print(sss_ref.render(scene).save("beer_lambert"))
