"""Lights without a place and cameras without perspective: the stages of any method, for rays that are parallel."""

from collections.abc import Iterator
from dataclasses import replace
from functools import reduce

from sss_ref.language import Stage
from sss_ref.language.names import Name
from sss_ref.language.parallel_rays import Rays
from sss_ref.language.pipeline import MeshDraw, Method, Pass
from sss_ref.methods.per_light import Lights
from sss_ref.scene_file.settings import SceneFile


def with_parallel_rays(method: Method, settings: SceneFile) -> Method:
    """The method with every stage made for the rays of its lights and its camera; the same where none are parallel."""
    found = tuple(rays_of(settings))
    return replace(method, passes=tuple(_with_rays(each, found) for each in method.passes)) if found else method


def rays_of(settings: SceneFile) -> Iterator[Rays]:
    """The rays of a scene that are parallel: those of directional lights, and of an orthographic camera."""
    lights = Lights(settings)
    for number, kind in zip(lights.numbers, lights.types, strict=True):
        if kind == "directional":
            origin, direction = (str(Name(name, number)) for name in ("light_position", "light_direction"))
            yield Rays(origin, direction, "_directional")
    if settings.camera.type == "orthographic":
        yield Rays("camera_position", "camera_direction", "_orthographic")


def _with_rays(this_pass: Pass, found: tuple[Rays, ...]) -> Pass:
    def turned(stage: Stage) -> Stage:
        return reduce(lambda one, rays: rays.of(one), found, stage)

    draw = this_pass.draw
    if isinstance(draw, MeshDraw):
        draw = replace(draw, vertex=turned(draw.vertex))
    return replace(this_pass, draw=draw, stages=tuple(map(turned, this_pass.stages)))
