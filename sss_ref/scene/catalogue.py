"""The methods by name: the paper's two, and the techniques that share its passes. A scene loads its own."""

from functools import partial
from importlib import import_module
from typing import cast

from sss_ref.language.pipeline import Method
from sss_ref.methods.parallel_views import with_parallel_rays
from sss_ref.scene_file.settings import SceneFile


def _built(home: str, name: str, settings: SceneFile) -> Method:
    """What the function of a name makes of settings. home: the module that it is in."""
    return cast(Method, getattr(import_module(home), name)(settings))


METHODS = {name: partial(_built, f"sss_ref.methods.{name}", name) for name in ("screen_space", "texture_space")}
TECHNIQUES = {
    name: partial(_built, f"sss_ref.methods.{name}", name)
    for name in ("separable", "burley", "preintegrated", "gaussian_texture")
}
PUBLISHED = {name: partial(_built, "sss_ref.methods.published.printed_methods", name) for name in METHODS}


def method_of(settings: SceneFile) -> Method:
    """The method that settings ask for, as the text has it or as the printed figures have it."""
    methods = PUBLISHED if settings.preset == "published" else METHODS | TECHNIQUES
    return with_parallel_rays(methods[settings.method](settings), settings)
