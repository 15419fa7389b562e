"""The methods by name."""

from sss_ref.errors import SceneError
from sss_ref.language.pipeline import Method
from sss_ref.methods.screen_space import screen_space
from sss_ref.scene.settings import SceneFile

METHODS = {"screen_space": screen_space}


def method_of(settings: SceneFile) -> Method:
    """The method that a scene asks for; raises SceneError where it cannot be rendered yet."""
    if settings.method not in METHODS:
        known = ", ".join(METHODS)
        raise SceneError(f"method: expected one of {known}, got {settings.method!r}; this version has no other")
    return METHODS[settings.method](settings)
