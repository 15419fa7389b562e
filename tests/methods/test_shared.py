"""What all methods share, as far as a scene's keys decide it alone."""

import pytest
from scenes import settings_with

from sss_ref.methods.shared import NEUTRAL, is_blended, is_soft, is_wrapped
from sss_ref.scene.catalogue import method_of

MULTIPLIED, ADDED = 1, 0  # by 1, or with 0 added, a colour stays as it is
TEXTURE = {"method": "texture_space"}
PRODUCT = {**TEXTURE, "irradiance_map.image": "product"}


@pytest.mark.parametrize(
    ("keys", "neutral"),
    [
        ({"translucency.combine": "multiply"}, MULTIPLIED),
        ({"translucency.combine": "add"}, ADDED),
        ({"translucency.combine": "transmit"}, ADDED),
        ({"translucency.combine": "transmit_wrapped"}, ADDED),
        ({**TEXTURE, "irradiance_map.image": "sqrt"}, MULTIPLIED),
        ({**TEXTURE, "irradiance_map.image": "product"}, ADDED),
        ({"preset": "published"}, ADDED),
        ({"preset": "published", **TEXTURE}, ADDED),
    ],
)
def test_the_factor_that_leaves_a_colour_as_it_is(keys, neutral):
    assert method_of(settings_with(keys)).constants[NEUTRAL] == neutral


@pytest.mark.parametrize(
    ("keys", "soft", "blended", "wrapped"),
    [
        ({}, False, False, False),
        ({"shadow_map.test": "kernel"}, True, True, False),
        ({"shadow_map.test": "kernel", "translucency.combine": "add"}, True, False, False),
        ({"translucency.combine": "transmit_wrapped"}, False, False, True),
        ({"shadow_map.test": "kernel", "translucency.combine": "transmit_wrapped"}, True, True, True),
        ({**TEXTURE, "shadow_map.test": "kernel"}, True, False, False),
        ({**PRODUCT, "translucency.combine": "transmit_wrapped"}, False, False, True),
        ({**TEXTURE, "irradiance_map.image": "sqrt", "translucency.combine": "transmit_wrapped"}, False, False, False),
    ],
)
def test_what_a_scene_asks_of_shadows_and_of_light_from_behind(keys, soft, blended, wrapped):
    settings = settings_with({"preset": "paper", **keys})
    assert (is_soft(settings), is_blended(settings), is_wrapped(settings)) == (soft, blended, wrapped)
