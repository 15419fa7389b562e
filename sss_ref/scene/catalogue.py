"""The methods by name: the paper's two, and the techniques that share its passes."""

from sss_ref.language.pipeline import Method
from sss_ref.methods.burley import burley
from sss_ref.methods.gaussian_texture import gaussian_texture
from sss_ref.methods.parallel_views import with_parallel_rays
from sss_ref.methods.preintegrated import preintegrated
from sss_ref.methods.published import printed_methods
from sss_ref.methods.screen_space import screen_space
from sss_ref.methods.separable import separable
from sss_ref.methods.texture_space import texture_space
from sss_ref.scene_file.settings import SceneFile

METHODS = {"screen_space": screen_space, "texture_space": texture_space}
TECHNIQUES = {
    "separable": separable,
    "burley": burley,
    "preintegrated": preintegrated,
    "gaussian_texture": gaussian_texture,
}
PUBLISHED = {"screen_space": printed_methods.screen_space, "texture_space": printed_methods.texture_space}


def method_of(settings: SceneFile) -> Method:
    """The method that settings ask for, as the text has it or as the printed figures have it."""
    methods = PUBLISHED if settings.preset == "published" else METHODS | TECHNIQUES
    return with_parallel_rays(methods[settings.method](settings), settings)
