"""The checks of the exercises: each takes a reader's answer and raises `NotYet`, with a hint, if it is not right."""

from sss_ref.course.checks.answers import NotYet, verdict
from sss_ref.course.checks.lesson_1 import distance_of_a_wall
from sss_ref.course.checks.lesson_2 import cover_once
from sss_ref.course.checks.lesson_3 import mirrored
from sss_ref.course.checks.lesson_4 import colour_kept
from sss_ref.course.checks.lesson_5 import way_inside
from sss_ref.course.checks.lesson_6 import texel_that_holds
from sss_ref.course.checks.lesson_7 import blur_on_the_body
from sss_ref.course.checks.lesson_8 import ulps_between
from sss_ref.course.checks.lesson_9 import wrong_stages
from sss_ref.course.checks.lesson_10 import albedo_of, free_path, photons_needed
from sss_ref.course.checks.lesson_11 import blurred_twice, exponent_between, millimetres_per_offset
