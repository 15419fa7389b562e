"""The methods by name."""

from sss_ref.language.pipeline import Method
from sss_ref.methods.screen_space import screen_space
from sss_ref.methods.texture_space import texture_space
from sss_ref.scene.settings import SceneFile

METHODS = {"screen_space": screen_space, "texture_space": texture_space}


def method_of(settings: SceneFile) -> Method:
    """The method that a scene asks for."""
    return METHODS[settings.method](settings)
