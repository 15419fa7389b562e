"""A stage of the reader's draws what the right one does, in the scenes that show what it is for."""

import numpy as np
import pytest
from exercise_answers import a_text, solutions
from matplotlib import pyplot

from sss_ref.course import checks
from sss_ref.course.right_pictures import PLACES, SIZE, right_and_own
from sss_ref.course.together import right_and_yours

SOLUTIONS = solutions()


@pytest.fixture(autouse=True)
def no_window():
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")


@pytest.mark.parametrize("check", PLACES, ids=lambda check: check.__name__)
def test_a_solution_draws_the_right_picture(check):
    right, own = right_and_own(check, SOLUTIONS[check], "bust")
    assert np.ptp(right) > 0 and np.allclose(own, right, atol=1e-4)


def test_what_is_no_stage_is_said_in_the_place_of_its_picture():
    assert right_and_own(checks.stencilled, a_text, "bust")[1] == "not a stage yet"
    right_and_yours(checks.stencilled, a_text, "bust")
    right, own = pyplot.gcf().axes
    assert right.images and not own.images and own.texts[0].get_text() == "not a stage yet"


def test_where_stages_are_at_work():
    """What a reader sees the right picture of: scenes by the paper's text, each with what shows its stage."""
    text = {
        "shadow_map.test": "slope",
        "translucency.combine": "transmit",
        "translucency.d_min": 0.1,
        "translucency.exponent": 0.6,
        "translucency.scale": 0.2,
    }
    mapped = text | {"irradiance_map.width": 256, "irradiance_map.height": 256}
    assert SIZE == 256 and {
        check.__name__: (place.scene, dict(place.overrides)) for check, place in PLACES.items()
    } == {
        "light_that_spreads": ("figure3_with", {"lights.0.intensity": 10.0}),
        "lit_within_a_bias": ("figure3_with", text | {"shadow_map.bias_abs": 0.03}),
        "matt_surface": ("figure3_with", text | {"phong.specular": 0.0}),
        "stencilled": ("figure3_with", {"blur.pixel_scale": 6.0}),
        "where_light_entered": ("figure3_with", text),
        "mixed_with_phong": ("figure5", mapped | {"irradiance_map.image": "sqrt"}),
        "albedo_after_the_blur": ("figure5", mapped | {"irradiance_map.image": "product"}),
        "same_bits": ("figure1", {}),
        "mended_lambert": ("figure5", mapped | {"irradiance_map.mode": "lambert"}),
    }
