"""The methods by name."""

from collections.abc import Mapping

from sss_ref.language import Stage
from sss_ref.language.pipeline import Method
from sss_ref.methods import published
from sss_ref.methods.own_stage import with_stages
from sss_ref.methods.screen_space import screen_space
from sss_ref.methods.texture_space import texture_space
from sss_ref.scene.settings import SceneFile

METHODS = {"screen_space": screen_space, "texture_space": texture_space}
PUBLISHED = {"screen_space": published.screen_space, "texture_space": published.texture_space}


def method_of(settings: SceneFile, own_stages: Mapping[str, Stage] | None = None) -> Method:
    """The method that a scene asks for, as the text has it or as the printed figures have it.

    own_stages: name -> the stage to run in the place of the one of that name (see `sss_ref.with_stage`).
    """
    methods = PUBLISHED if settings.preset == "published" else METHODS
    return with_stages(methods[settings.method](settings), own_stages or {})
