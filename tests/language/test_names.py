"""Names of buffers, registers, uniforms and passes, taken apart and put together."""

import pytest

from sss_ref.language.names import EXACT, INNER, PARTIAL, PARTIAL_SUM, TEXEL, Name

WORKED = {
    "thickness": Name("thickness"),
    "light_distance_12": Name("light_distance", 12),
    "texel_thickness": Name("thickness", site=TEXEL),
    "texel_incident_light_2": Name("incident_light", 2, TEXEL),
    "partial_lit_1": Name("lit", 1, share=PARTIAL),
    "partial_sum_lit_2": Name("lit", 2, share=PARTIAL_SUM),
    "exact_image": Name("image", share=EXACT),
    "texel_exact_irradiance": Name("irradiance", 0, TEXEL, EXACT),
    "shadow_map_3": Name("shadow_map", 3),
    "tap_07": Name("tap_07"),
    "tap_12": Name("tap_12"),
    "tap_00_offset": Name("tap_00_offset"),
    "x": Name("x"),
    "inner_lit": Name("lit", body=INNER),
    "inner_partial_lit_2": Name("lit", 2, share=PARTIAL, body=INNER),
    "inner_shadow_map_1": Name("shadow_map", 1, body=INNER),
}


@pytest.mark.parametrize("text", WORKED)
def test_a_name_is_read_and_written(text):
    assert Name.of(text) == WORKED[text]
    assert str(WORKED[text]) == text


def test_what_no_target_keeps_says_so():
    assert [text for text, name in WORKED.items() if name.is_register] == [
        *("texel_thickness", "texel_incident_light_2", "partial_lit_1", "partial_sum_lit_2", "exact_image"),
        *("texel_exact_irradiance", "inner_partial_lit_2"),
    ]


def test_one_part_is_changed_at_a_time():
    assert str(Name.of("lit").of_light(2).as_share(PARTIAL)) == "partial_lit_2"
    assert str(Name.of("phong_1").of_light(0)) == "phong"
    assert str(Name.of("phong_1").of_body(INNER)) == "inner_phong_1"
    assert str(Name.of("exact_irradiance").at(TEXEL)) == "texel_exact_irradiance"
