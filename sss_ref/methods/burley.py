"""Normalized diffusion in screen space (Christensen and Burley 2015): the paper's passes, and Burley's profile sampled.

What lies before or behind a pixel counts by its distance in space, so light does not cross from one surface to another.
"""

from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.screen_space import neutral, up_to_the_camera
from sss_ref.methods.separable import REACH_THERE
from sss_ref.passes import burley_blur, composite
from sss_ref.scene_file.settings import SceneFile


def burley(settings: SceneFile) -> Method:
    """Shadow map, camera, blur, composite."""
    before, picture = up_to_the_camera(settings, REACH_THERE)
    return Method(
        "burley",
        passes=(
            *before,
            Pass("blur", "camera", ScreenDraw("coverage"), (burley_blur.scatter_burley.bound(lit=picture),)),
            Pass("composite", "camera", ScreenDraw(), (composite.over_background,)),
        ),
        constants=neutral(settings),
    )
