"""What passes.json says of a small scene, by hand."""

import numpy as np
import pytest
from scenes import LIGHT, around, two_squares, written

from sss_ref.bundle.languages import LANGUAGES
from sss_ref.bundle.pass_list import pass_list, plain
from sss_ref.scene.load import load_scene

LIGHTS = [{"position": LIGHT}, {"position": [-1.0, 0.0, 3.0]}]
PASSES = ["shadow_map_1", "shadow_map_2", "irradiance_map"]
PASSES += ["irradiance_fill_1", "irradiance_blur_1", "irradiance_fill_2", "irradiance_blur_2", "camera"]


@pytest.fixture(scope="module")
def squares(tmp_path_factory):
    return around(written(tmp_path_factory.mktemp("squares") / "squares.obj", *two_squares()), 6, lights=LIGHTS)


def loaded(squares, **tables):
    return load_scene(squares | {"method": "texture_space"} | tables)


def listed(scene, language="glsl"):
    """Name of a pass -> what is said of it."""
    return {each["name"]: each for each in pass_list(scene, LANGUAGES[language])["passes"]}


def test_the_list_begins_with_what_it_is(squares):
    found = pass_list(loaded(squares), LANGUAGES["hlsl"])
    del found["passes"]
    assert found == {
        "format": "sss_ref bundle 1",
        "rules_version": 2,
        "method": "texture_space",
        "dialect": "hlsl",
        "array_width": 4096,
    }


def test_passes_in_order_with_their_sizes(squares):
    scene = loaded(squares, irradiance_map={"width": 5, "height": 3}, camera=squares["camera"] | {"width": 7})
    found = listed(scene)
    assert [*found] == PASSES
    sizes = {name: (each["width"], each["height"]) for name, each in found.items()}
    assert sizes["shadow_map_2"] == (6, 6) and sizes["irradiance_blur_1"] == (5, 3) and sizes["camera"] == (7, 6)


def test_a_pass_reads_what_earlier_ones_wrote_of_what_it_needs(squares):
    found = listed(loaded(squares))
    assert found["shadow_map_1"]["reads"] == [] and found["irradiance_blur_2"]["reads"] == ["irradiance_filled_2"]
    assert found["irradiance_fill_1"]["reads"] == ["irradiance_1", "irradiance_mask"]
    numbered = [f"{name}_{light}" for name in ("light_distance", "light_triangle", "light_uv") for light in (1, 2)]
    assert found["camera"]["reads"] == [*numbered, "scattered_irradiance_1", "scattered_irradiance_2"]


def test_a_mesh_is_drawn_with_a_test_and_a_rectangle_without(squares):
    for overlap, later_wins in (("first", False), ("last", True)):
        found = listed(loaded(squares, irradiance_map={"overlap": overlap}))
        mesh = {"kind": "mesh", "mesh": "mesh", "indexed": True, "depth_test": "less", "cull": "none"}
        assert found["camera"]["draw"] == mesh
        assert found["irradiance_map"]["draw"] == mesh | ({"depth_test": "less or equal"} if later_wins else {})
        assert found["irradiance_blur_1"]["draw"] == {"kind": "rectangle", "discards_where_0": ""}
    screen = listed(load_scene(squares | {"method": "screen_space"}))
    assert screen["blur"]["draw"] == {"kind": "rectangle", "discards_where_0": "coverage"}
    assert not listed(loaded(squares), "wgsl")["camera"]["draw"]["indexed"]


def test_targets_have_what_they_are_cleared_to(squares):
    targets = {each["buffer"]: each for each in listed(loaded(squares))["shadow_map_1"]["draws"][0]["targets"]}
    assert targets["light_triangle_1"] == {
        "buffer": "light_triangle_1",
        "format": "R32I",
        "filter": "nearest",
        "clear": [-1],
        "unit": "triangle index in scene order",
    }
    assert targets["light_uv_1"]["clear"] == [-1, -1] and targets["light_depth_1"]["clear"] == [1]


def test_resources_are_listed_where_they_go_by_number(squares):
    scene = loaded(squares)
    assert "resources" not in listed(scene)["camera"] and "resources" not in listed(scene)["camera"]["draws"][0]
    for language in ("wgsl", "vulkan", "hlsl"):
        (one, *_) = (each for each in pass_list(scene, LANGUAGES[language])["passes"])
        vertex, fragment = one["resources"], one["draws"][0]["resources"]
        groups = LANGUAGES[language].dialect.groups
        assert (vertex["group"], fragment["group"]) == groups
        matrices = {"light_clip_from_model_1": 0, "normal_from_model": 64, "world_from_model": 112}
        assert vertex["constants"] == {"binding": 0, "bytes": 176, "offsets": matrices} and vertex["textures"] == {}
        assert fragment["constants"] == {"binding": 0, "bytes": 16, "offsets": {"light_position_1": 0}}
    assert LANGUAGES["wgsl"].dialect.groups == (0, 1)
    camera = listed(scene, "wgsl")["camera"]
    assert camera["draws"][0]["resources"]["constants"] is None
    textures = [each["resources"]["textures"] for each in camera["draws"]]
    assert all(sorted(each.values()) == [*range(1, 1 + len(each))] for each in textures) and any(textures)


@pytest.mark.parametrize(
    ("value", "told"),
    [(np.float32(0.1), 0.1), (0.1, 0.1), (3, 3), (np.int32(-1), -1), (np.float32([[1, 0.2]]), [[1.0, 0.2]])],
)
def test_numbers_have_the_fewest_digits(value, told):
    found = plain(value)
    assert found == told and type(found) is type(told)
