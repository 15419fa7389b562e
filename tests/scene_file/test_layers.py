from sss_ref.scene_file.layers import filled, is_overridden, laid, overridden, override_paths


def test_upper_layer_wins_key_by_key():
    assert laid({"a": {"x": 1, "y": 2}, "b": 3}, {"a": {"y": 4}}) == {"a": {"x": 1, "y": 4}, "b": 3}
    assert laid({"a": [1, 2]}, {"a": [3]}) == {"a": [3]}


def test_another_type_replaces_the_table():
    orbit = {"type": "orbit", "distance": 5, "width": 64}
    assert laid(orbit, {"type": "free", "position": [0, 0, 0]}) == {"type": "free", "position": [0, 0, 0]}
    assert laid(orbit, {"type": "orbit", "distance": 6}) == {"type": "orbit", "distance": 6, "width": 64}
    assert laid(orbit, {"distance": 6})["type"] == "orbit"


def test_file_goes_on_its_preset():
    data = filled({"preset": "robust", "blur": {"mask": "none"}})
    assert data["blur"] == {"kernel": "hbh09", "mask": "none", "pixel_scale": 2.0}
    assert filled({})["translucency"]["y"] == -1.0
    assert filled({"preset": 7})["translucency"]["y"] == -1.0  # validation will refuse it


def test_robust_blurs_in_mm_where_the_scene_knows_its_unit():
    def blur(**data):
        return filled({"preset": "robust", **data})["blur"]

    in_mm = {"kernel": "hbh09", "mask": "taps", "pixel_scale": 2.0, "unit": "mm", "follow_surface": True}
    assert blur(mm_per_unit=150.0) == in_mm
    assert blur(blur={"unit": "mm"}) == in_mm
    assert blur(mm_per_unit=150.0, blur={"follow_surface": False}) == {**in_mm, "follow_surface": False}
    assert "unit" not in blur() and "follow_surface" not in blur()
    assert "unit" not in blur(mm_per_unit=150.0, blur={"pixel_scale": 3.0})
    assert blur(mm_per_unit=150.0, blur={"unit": "pixel"})["unit"] == "pixel"
    assert "unit" not in filled({"mm_per_unit": 150.0})["blur"]


def test_what_a_preset_has_of_lights_lies_below_every_light():
    lights = filled({"preset": "published", "lights": [{"fov_y": 30}, {}, 7]})["lights"]
    assert [light["fov_y"] for light in lights[:2]] == [30, 90.0]
    assert lights[2] == 7  # validation will refuse it
    assert "lights" not in filled({"preset": "published"})
    assert filled({"preset": "published", "lights": "one"})["lights"] == "one"


def test_a_camera_of_parallel_rays_has_all_but_the_angle_of_a_preset():
    common = {"near": 0.001, "far": 1000, "width": 1600, "height": 900}
    for kind, angle in (("orthographic", {}), ("free", {"fov_y": 45})):
        camera = filled({"preset": "published", "camera": {"type": kind}})["camera"]
        assert camera == {"type": kind, **common, **angle}


def test_overrides_by_dotted_key_and_as_tables():
    data = {"camera": {"width": 1, "height": 2}, "lights": [{"intensity": 1.0}]}
    result, problems = overridden(data, {"camera.width": 8, "camera": {"far": 9}, "lights.0.intensity": 2.0, "a.b": 1})
    assert result == {
        "camera": {"width": 8, "height": 2, "far": 9},
        "lights": [{"intensity": 2.0}],
        "a": {"b": 1},
    }
    assert problems == []
    assert data == {"camera": {"width": 1, "height": 2}, "lights": [{"intensity": 1.0}]}


def test_a_place_that_is_overridden_replaces_the_other_way_to_say_it():
    orbit, point = {"azimuth": 1, "distance": 2, "color": 3}, {"position": 4, "color": 3}
    data = {"lights": [orbit, point, 7]}

    def lights(**overrides):
        result, problems = overridden(data, overrides)
        assert problems == []
        return result["lights"][:2]

    assert lights(**{"lights.0.position": 5}) == [{"color": 3, "position": 5}, point]
    assert lights(**{"lights.1.elevation": 5, "lights.1": {"distance": 6}}) == [
        orbit,
        {"color": 3, "elevation": 5, "distance": 6},
    ]
    assert lights(**{"lights.0.distance": 5, "lights.1.color": 6}) == [{**orbit, "distance": 5}, {**point, "color": 6}]
    assert lights(**{"lights.0.position": 5, "lights.0.azimuth": 6}) == [{**orbit, "azimuth": 6, "position": 5}, point]
    assert lights(**{"lights.1.position": 5}) == [orbit, {**point, "position": 5}]
    assert lights(**{"lights.0": 8, "lights.1.color": 6}) == [8, {**point, "color": 6}]
    assert data == {"lights": [orbit, point, 7]}


def test_override_beyond_the_list():
    _, problems = overridden({"lights": [{}]}, {"lights.1.intensity": 2.0, "lights.first": 1})
    assert problems == [
        "lights.1.intensity: expected an index below 1, got 1; correct it",
        "lights.first: expected an index below 1, got first; correct it",
    ]


def test_which_values_are_overridden():
    paths = override_paths({"camera.width": 8, "phong": {"ambient": 1}, "lights.0.position": [0, 0, 0]})
    assert paths == {("camera", "width"), ("phong", "ambient"), ("lights", 0, "position")}
    assert is_overridden(("lights", 0, "position", 2), paths)
    assert not is_overridden(("camera", "height"), paths)


def test_a_number_of_ten_digits_is_no_place_of_an_array():
    assert override_paths({"a.123456789": 1, "a.1234567890": 1}) == {("a", 123456789), ("a", "1234567890")}
