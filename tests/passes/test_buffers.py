"""What the list of buffers says of each: what stands where nothing is drawn, and whose it is."""

import pytest

from sss_ref.passes.buffers import BUFFERS, OWN, described, entry_of, is_listed

NO_TRIANGLE = {"light_triangle", "irradiance_triangle", "triangle"}
NOWHERE = {"light_uv", "shadow_uv", "inside_shadow_uv", "irradiance_uv"}  # texture coordinates: 0, 0 is a place
FARTHEST = {"light_depth", "depth"}
NAMED = {"light_distance": "light_clear_distance", "image": "background"}
SPREAD = {f"spread_{letter}{rows}" for letter in "abcdef" for rows in ("", "_rows")}
EACH_LIGHT_HAS = {
    *SPREAD,
    "light_triangle", "light_depth", "light_distance", "light_uv", "light_normal", "irradiance",
    "irradiance_filled", "irradiance_filled_mask", "scattered_irradiance", "shadow_uv", "shadow_valid",
    "stored_distance", "inside_point", "inside_shadow_uv", "inside_shadow_valid", "inside_stored_distance",
    "entry_point", "thickness", "directly_lit", "light_visible", "light_around", "incident_light", "phong",
    "translucency", "irradiance_uv",
}  # fmt: skip
SUMMED = {"irradiance_used", "gloss", "lit"}


@pytest.mark.parametrize("name", BUFFERS)
def test_what_stands_where_nothing_is_drawn(name):
    number = -1 if name in NO_TRIANGLE | NOWHERE else 1 if name in FARTHEST else 0
    assert BUFFERS[name].background == NAMED.get(name, number)


def test_what_each_of_several_lights_has_and_what_is_summed():
    assert {name for name, buffer in BUFFERS.items() if buffer.per_light} == EACH_LIGHT_HAS
    assert {name for name, buffer in BUFFERS.items() if buffer.in_parts} == SUMMED


def test_a_name_with_a_number_is_of_its_entry():
    assert (entry_of("tap_07"), entry_of("tap_count"), entry_of("thickness_2")) == ("tap", "tap_count", "thickness")
    assert described("phong_3") is BUFFERS["phong"] and described("mine") is OWN
    assert (is_listed("tap_12"), is_listed("tap_offset"), is_listed("mine")) == (True, False, False)
    assert (OWN.background, OWN.per_light, OWN.in_parts) == (0, False, False)
