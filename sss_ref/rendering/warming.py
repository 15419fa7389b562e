"""Compiling everything that renderings may run, before the first of them."""

from collections.abc import Iterator
from itertools import product
from typing import Any

from sss_ref.errors import SceneError
from sss_ref.interpret.kernel.ahead import compile_alone, compile_method, compile_rows
from sss_ref.language.pipeline import Method
from sss_ref.methods.stages import all_stages
from sss_ref.rendering.fold import render
from sss_ref.scene.catalogue import METHODS, TECHNIQUES, method_of
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.presets import PRESETS
from sss_ref.scene_file.reading import opened, validated
from sss_ref.scene_file.shipped import scene_names

SMALL = {f"{table}.{side}": 64 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")}
DRAWN: tuple[dict[str, Any], ...] = (
    {"method": "texture_space"},
    {"camera.far": 4.2},  # scene units: through the middle of the default scene's mesh, so that triangles are clipped
)


def steps() -> Iterator[str]:
    """Do it step by step; before each, what is compiled."""
    yield "the rasterizer"
    compile_rows()
    for changes in DRAWN:
        render(load_scene("default", **SMALL, **changes))
    for name in scene_names():
        yield name
        for method in methods_of(name):
            compile_method(method)
    yield "all other stages"
    compile_alone(all_stages().values())


def methods_of(scene: str) -> Iterator[Method]:
    """A shipped scene's own method, then every method with every preset that the scene allows."""
    document = opened(scene)
    yield method_of(validated(document, {}))
    for method, preset in product(METHODS | TECHNIQUES, PRESETS):
        try:
            settings = validated(document, {"method": method, "preset": preset})
        except SceneError:
            continue
        yield method_of(settings)
