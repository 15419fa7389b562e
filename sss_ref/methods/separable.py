"""Separable subsurface scattering (Jimenez et al. 2015): the paper's passes in screen space, with a blur of two passes.

The first blurs along the rows, the second along the columns, with a kernel that is the profile's projection on a line.
"""

from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.screen_space import neutral, up_to_the_camera
from sss_ref.passes import composite, lengths, separable_blur
from sss_ref.scene_file.settings import SceneFile

REACH_THERE = (  # how many pixels the kernel's reach is at a fragment
    lengths.pixel_length,
    lengths.offset_length.bound(mm_per_offset="reach_mm"),
)


def separable(settings: SceneFile) -> Method:
    """Shadow map, camera, blur along x, blur along y, composite."""
    before, picture = up_to_the_camera(settings, REACH_THERE)
    model, along = ScreenDraw("coverage"), separable_blur.scatter_along
    rows, columns = (along.bound(kernel_offset=axis) for axis in ("kernel_rows", "kernel_columns"))
    return Method(
        "separable",
        passes=(
            *before,
            Pass("blur_rows", "camera", model, (rows.bound(lit=picture, scattered="scattered_rows"),)),
            Pass("blur_columns", "camera", model, (columns.bound(lit="scattered_rows"),)),
            Pass("composite", "camera", ScreenDraw(), (composite.over_background,)),
        ),
        constants=neutral(settings),
    )
