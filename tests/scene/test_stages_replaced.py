"""A stage of one's own gets the names that the replaced one has."""

from typing import NamedTuple

from sss_ref.language import stage, vec3
from sss_ref.passes.phong import phong_shading
from sss_ref.scene.stages_replaced import bound_like


class Own(NamedTuple):
    """What ours writes, and more."""

    phong: vec3
    gloss_map: float


@stage(source="a test")
def glossy(
    albedo: vec3, light_color: vec3, shadow_uv: vec3, wrap: float, camera_position: vec3, strength: float
) -> Own:
    """Reads of a light, of a body, of both, of neither."""
    return Own(albedo * light_color * wrap + shadow_uv + camera_position, strength)


def names(other, before=()):
    bound = bound_like(glossy, other, set(before))
    return {own: name for own, name in {**bound.reads, **bound.writes}.items() if own != name}


def test_under_the_same_names_nothing_changes():
    assert names(phong_shading) == {}


def test_what_belongs_to_a_light_has_its_number():
    """What is new of it too; what it shares with the other has the other's name."""
    of_second = phong_shading.renamed(
        lambda name: {"light_position": "light_position_2", "phong": "phong_2"}.get(name, name)
    )
    assert names(of_second) == {
        "phong": "phong_2",
        "light_color": "light_color_2",
        "shadow_uv": "shadow_uv_2",
        "gloss_map": "gloss_map_2",
    }


def test_what_belongs_to_a_body_has_its_name():
    of_inner = phong_shading.renamed(lambda name: {"phong": "inner_phong", "albedo": "inner_albedo"}.get(name, name))
    assert names(of_inner) == {
        "albedo": "inner_albedo",
        "phong": "inner_phong",
        "shadow_uv": "inner_shadow_uv",
        "wrap": "inner_wrap",
        "gloss_map": "inner_gloss_map",
    }


def test_what_the_irradiance_map_has_already_is_read_from_there():
    assert names(phong_shading, {"texel_shadow_uv", "texel_strength"}) == {
        "shadow_uv": "texel_shadow_uv",
        "strength": "texel_strength",
    }
