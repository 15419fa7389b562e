"""The checks of the exercises: each takes a reader's answer and raises `NotYet`, with a hint, if it is not right."""

from sss_ref.course.checks.answers import NotChecked, NotYet, verdict
from sss_ref.course.checks.lesson_1 import distance_of_a_wall, lambert_in_glsl, light_that_spreads
from sss_ref.course.checks.lesson_2 import cover_once, lit_within_a_bias, map_coordinates_in_glsl
from sss_ref.course.checks.lesson_3 import highlight_in_glsl, matt_surface, mirrored
from sss_ref.course.checks.lesson_4 import colour_kept, stencilled, weight_given_back_in_glsl
from sss_ref.course.checks.lesson_5 import ratio_in_glsl, way_inside, where_light_entered
from sss_ref.course.checks.lesson_6 import layout_in_glsl, mixed_with_phong, texel_that_holds
from sss_ref.course.checks.lesson_7 import albedo_after_the_blur, blur_on_the_body, stranger_in_glsl
from sss_ref.course.checks.lesson_8 import difference_of_squares_in_glsl, same_bits, ulps_between
from sss_ref.course.checks.lesson_9 import mended_lambert, mended_srgb_in_glsl, wrong_stages
from sss_ref.course.checks.lesson_10 import albedo_of, free_path, photons_needed
from sss_ref.course.checks.lesson_11 import blurred_twice, exponent_between, millimetres_per_offset
from sss_ref.course.checks.lesson_12 import best_factor, error_without_noise, samples_for
from sss_ref.course.checks.lesson_13 import (
    own_directly_lit,
    own_image,
    own_lit,
    own_phong,
    own_scattered,
    own_stored_distance,
    own_thickness,
    own_translucency,
)

__all__ = [
    "NotChecked",
    "NotYet",
    "albedo_after_the_blur",
    "albedo_of",
    "best_factor",
    "blur_on_the_body",
    "blurred_twice",
    "colour_kept",
    "cover_once",
    "difference_of_squares_in_glsl",
    "distance_of_a_wall",
    "error_without_noise",
    "exponent_between",
    "free_path",
    "highlight_in_glsl",
    "lambert_in_glsl",
    "layout_in_glsl",
    "light_that_spreads",
    "lit_within_a_bias",
    "map_coordinates_in_glsl",
    "matt_surface",
    "mended_lambert",
    "mended_srgb_in_glsl",
    "millimetres_per_offset",
    "mirrored",
    "mixed_with_phong",
    "own_directly_lit",
    "own_image",
    "own_lit",
    "own_phong",
    "own_scattered",
    "own_stored_distance",
    "own_thickness",
    "own_translucency",
    "photons_needed",
    "ratio_in_glsl",
    "same_bits",
    "samples_for",
    "stencilled",
    "stranger_in_glsl",
    "texel_that_holds",
    "ulps_between",
    "verdict",
    "way_inside",
    "weight_given_back_in_glsl",
    "where_light_entered",
    "wrong_stages",
]
