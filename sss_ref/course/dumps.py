"""Three dumps for the last exercise: what three graphics processors, one of them right, might have drawn."""

import sss_ref
from sss_ref.course import small_scenes
from sss_ref.language import dot, max, normalize, stage, vec3
from sss_ref.passes.phong import Phong, highlight


@stage(source="paper 3.2, after Phong 1975")
def phong_regrouped(
    position_world: vec3,
    normal_world: vec3,
    albedo: vec3,
    light_position: vec3,
    camera_position: vec3,
    incident_light: vec3,
    ambient: float,
    diffuse: float,
    specular: float,
    shininess: float,
    light_count: float,
) -> Phong:
    """(ambient/n + e*(diffuse*max(N.L, 0) + specular*(V.R)^shininess)) * albedo: one product fewer, other bits."""
    to_light = normalize(light_position - position_world)
    to_eye = normalize(camera_position - position_world)
    lambert = diffuse * max(dot(normal_world, to_light), 0.0)
    mirror = specular * highlight(normal_world, to_light, to_eye, shininess)
    return Phong((ambient / light_count + incident_light * (lambert + mirror)) * albedo)


def three_dumps(head: str) -> tuple[sss_ref.Result, dict[str, sss_ref.Result]]:
    """The oracle's rendering, and the dumps by name."""
    scene = _scene(head)
    scenes = {
        "A": _scene(head, **{"shadow_map.lookup_inset": 0.995}),
        "B": sss_ref.with_stage(scene, "phong_shading", phong_regrouped),
        "C": _scene(head, **{"blur.pixel_scale": 2.1}),
    }
    return sss_ref.render(scene), {name: sss_ref.render(each) for name, each in scenes.items()}


def _scene(head: str, **overrides: float) -> sss_ref.Scene:
    return small_scenes.load(
        "figure3_with", head, 192, **(small_scenes.BY_THE_TEXT | {"blur.pixel_scale": 2.0} | overrides)
    )
