"""Pre-integrated skin (Penner and Borshukov 2011): the paper's passes, with a table in the place of a blur."""

from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.screen_space import neutral, up_to_the_camera
from sss_ref.methods.shared import Shading
from sss_ref.passes import composite, preintegrated_skin
from sss_ref.scene_file.settings import SceneFile

ROUND = Shading(
    phong=preintegrated_skin.phong_preintegrated,
    shadow_test=(preintegrated_skin.directly_lit_round,),
    of_surface=(preintegrated_skin.surface_curvature,),
)


def preintegrated(settings: SceneFile) -> Method:
    """Shadow map, camera, composite."""
    before, picture = up_to_the_camera(settings, (), ROUND)
    return Method(
        "preintegrated",
        passes=(
            *before,
            Pass("composite", "camera", ScreenDraw(), (composite.over_background.bound(scattered=picture),)),
        ),
        constants=neutral(settings),
    )
