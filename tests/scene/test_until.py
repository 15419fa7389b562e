import pytest

from sss_ref.errors import SceneError
from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.shared import CAMERA_VIEW, LIGHT_VIEW
from sss_ref.passes import blur, shadow_map
from sss_ref.passes.camera import surface
from sss_ref.scene.until import buffers_until

METHOD = Method(
    "short",
    (
        Pass("shadow_map", "shadow_map", LIGHT_VIEW, (shadow_map.distance_to_light,)),
        Pass("camera", "camera", CAMERA_VIEW, (surface,)),
        Pass("surface", "camera", ScreenDraw(), (blur.scatter,)),
    ),
)
BUFFERS = list(METHOD.outputs)


@pytest.mark.parametrize(
    "end, last",
    [
        ("shadow_map", "light_distance"),
        ("distance_to_light", "light_distance"),
        ("light_depth", "light_depth"),
        ("light_triangle", "light_triangle"),
        ("camera", "uv"),
        ("normal_world", "normal_world"),
        ("scatter", "scattered"),
        ("surface", "scattered"),  # the pass, not the stage of that name
    ],
)
def test_ends_with_what_was_named(end, last):
    assert buffers_until(METHOD, end) == BUFFERS[: BUFFERS.index(last) + 1]


def test_unknown_name():
    with pytest.raises(
        SceneError, match=r"^until: expected a pass, a stage or a buffer \(light_triangle, .*\), got 'phong'$"
    ):
        buffers_until(METHOD, "phong")
