"""The scene that is traced, and those of the techniques: what is left out of both."""

import pytest

from sss_ref.errors import SceneError
from sss_ref.scene.load import load_scene
from sss_ref.truth.photon import Volume
from sss_ref.yardstick.yardstick import Yardstick, medium_of

GIVEN = {
    "mm_per_unit": 60.0,
    "camera.width": 20,
    "camera.height": 10,
    "phong.ambient": 0.25,
    "phong.specular": 0.5,
    "output.background": [0.1, 0.2, 0.3],
    "lights.0.intensity": 3.0,
    "method": "texture_space",
    "material": "marble",
    "shadow_map.test": "literal",
}


def test_what_is_traced_has_the_body_the_camera_and_the_lights_alone():
    of = Yardstick("sphere", {key: value for key, value in GIVEN.items() if "map" not in key}, "skin1")
    traced = of.tracing.scene.settings
    assert (of.tracing.border, of.tracing.volumes[0]) == ("entered", Volume(0.74, 0.032, 0.0, 1.3))
    assert (traced.mm_per_unit, traced.camera.width, traced.camera.height) == (60, 20, 10)
    assert (traced.phong.ambient, traced.phong.specular, traced.lights[0].intensity) == (0, 0, 3)
    assert (traced.output.background, traced.method, traced.material) == ((0, 0, 0), "screen_space", None)
    assert (traced.shadow_map.test, traced.preset) == ("slope", "robust")


def test_a_techniques_scene_has_its_own_keys_on_top():
    of = Yardstick("sphere", {"mm_per_unit": 60.0, "phong.ambient": 0.25, "lights.0.intensity": 3.0}, "skin1")
    found = of.scene_of("burley", {"diffusion.reach_mm": 2.5}).settings
    assert (found.method, found.diffusion.reach_mm, found.phong.ambient, found.lights[0].intensity) == (
        "burley",
        2.5,
        0,
        3,
    )
    assert (of.name, of.left_out) == ("sphere", ["phong.ambient = 0.25", "phong.specular = 0.5"])
    plain = Yardstick("sphere", {"phong.ambient": 0.0, "phong.specular": 0.0}, "skin1")
    assert plain.left_out == []


@pytest.mark.parametrize(
    ("overrides", "line"),
    [
        (
            {},
            "mm_per_unit: expected how many mm a unit of the scene is, got nothing; set it in the scene file, or give",
        ),
        (
            {"mm_per_unit": 1.0, "mesh.color": "material", "material": "marble"},
            'mesh.color: expected one colour, as there is one medium, got "material"; give one colour in mesh.color',
        ),
    ],
)
def test_what_cannot_be_measured_is_refused(overrides, line):
    with pytest.raises(SceneError) as error:
        _ = Yardstick("sphere", overrides, "skin1").tracing
    assert str(error.value).startswith(line)


def test_the_medium_is_the_one_that_is_given_or_the_scenes():
    plain, marble, skin = (
        load_scene("sphere", **{"material": name, "mm_per_unit": 1.0}) for name in (None, "marble", "skin")
    )
    assert medium_of(plain, "skin1") == medium_of(marble, "skin1") == "skin1" and medium_of(marble, None) == "marble"
    assert medium_of(skin, "wax") == "wax"
    for scene, came in (
        (plain, "none and a scene without material"),
        (skin, "none, and of skin no coefficients are known"),
    ):
        with pytest.raises(
            SceneError, match=f"^--medium: expected the name of a medium, got {came}; try one of skin1, "
        ):
            medium_of(scene, None)
