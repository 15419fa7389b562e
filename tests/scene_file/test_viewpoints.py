"""What every type of camera and light fills in, and what of it does not go together."""

import pytest
from filled_scenes import VIEWPOINTS, are_filled_as_ever
from pydantic import ValidationError

from sss_ref.scene_file.viewpoints import (
    DirectionalLight,
    FreeCamera,
    LookAtCamera,
    OrthographicCamera,
    PointLight,
    type_of,
)

HERE, ELSEWHERE = (1.0, 2.0, 3.0), (1.0, 2.0, 4.0)
LOOKING = {"type": "look_at", "eye": HERE}
PARALLEL = {"type": "orthographic", "eye": HERE, "view_height": 2.0}
FREE = {"type": "free", "position": HERE}
SUN = {"type": "directional", "position": HERE}
LAMP = {"position": HERE}
SAME_POINT = "a point other than where it is looked from"


def wrong_keys(table, **keys):
    """Key -> what is said of it, of a table that is refused."""
    with pytest.raises(ValidationError) as caught:
        table.model_validate(keys)
    return {each["loc"][0]: each["msg"] for each in caught.value.errors()}


def test_cameras_and_lights_are_filled_as_ever(tmp_path):
    are_filled_as_ever(VIEWPOINTS, tmp_path)


@pytest.mark.parametrize(
    ("table", "keys"),
    [(LookAtCamera, LOOKING), (OrthographicCamera, PARALLEL), (PointLight, LAMP), (DirectionalLight, SUN)],
)
def test_what_is_looked_at_lies_elsewhere(table, keys):
    assert table.model_validate({**keys, "target": ELSEWHERE}).target == ELSEWHERE
    (said,) = wrong_keys(table, **keys, target=HERE).items()
    assert said[0] == "target" and SAME_POINT in said[1]


@pytest.mark.parametrize(
    ("table", "keys"),
    [(LookAtCamera, LOOKING), (OrthographicCamera, PARALLEL), (FreeCamera, FREE), (PointLight, LAMP)],
)
def test_far_lies_beyond_near(table, keys):
    assert table.model_validate({**keys, "near": 5.0, "far": 5.5}).far == 5.5
    for far in (5.0, 4.5):
        (said,) = wrong_keys(table, **keys, near=5.0, far=far).items()
        assert said[0] == "far" and "a distance beyond near = 5" in said[1]


def test_either_plane_of_a_light_may_be_fitted():
    assert PointLight.model_validate({**LAMP, "near": 5.0}).far is None
    assert PointLight.model_validate({**LAMP, "far": 0.001}).near is None


@pytest.mark.parametrize("table", [PointLight, DirectionalLight])
def test_a_light_has_one_place(table):
    kind = {"type": "directional"} if table is DirectionalLight else {}
    orbit = {"azimuth": 10.0, "elevation": 20.0, "distance": 3.0}
    assert table.model_validate({**kind, **orbit}).position is None
    assert table.model_validate({**kind, "elevation": 20.0, "distance": 3.0}).azimuth is None
    assert table.model_validate({**kind, "azimuth": 0.0, "distance": 3.0}).azimuth == 0
    for key, value in orbit.items():
        assert (
            "no position beside "
            in wrong_keys(table, **kind, **{"distance": 3.0, key: value}, position=HERE)["position"]
        )
    for nowhere in ({}, {"distance": 3.0}):
        (said,) = wrong_keys(table, **kind, **nowhere, position=None).items()
        assert said[0] == "position" and "azimuth, elevation and distance" in said[1]


def test_the_orbit_of_a_point_light_has_a_radius():
    """That of one infinitely far away is a direction, and needs none."""
    for angle in ("azimuth", "elevation"):
        assert "distance" in wrong_keys(PointLight, **{angle: 10.0}, distance=None)
        assert DirectionalLight.model_validate({"type": "directional", angle: 0.0, "position": None}).distance is None


def test_how_much_a_shadow_map_sees():
    assert PointLight.model_validate({**LAMP, "fov_y": 30.0}).opening == 30
    assert DirectionalLight.model_validate({**SUN, "view_height": 7.0}).opening == 7
    assert PointLight.model_validate(LAMP).opening is None and DirectionalLight.model_validate(SUN).opening is None


def test_the_type_of_a_light_is_the_one_that_it_says():
    sun = DirectionalLight.model_validate(SUN)
    assert [type_of(light) for light in ({}, SUN, sun, LAMP, 7)] == [
        "point", "directional", "directional", "point", "point",
    ]  # fmt: skip
