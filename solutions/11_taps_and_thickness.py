"""Solutions of lesson 11."""

import math

import numpy as np


def blurred_twice(first, second):
    """Variances are added."""
    return math.hypot(first, second)


def millimetres_per_offset(distances, weights, wanted):
    """The root of the weighted mean of the squared distances, in offsets, has to become what is wanted."""
    return wanted / np.sqrt(np.average(distances**2, weights=weights))


def exponent_between(thin, through_thin, thick, through_thick):
    """The slope between two points on logarithmic axes."""
    return -math.log(through_thick / through_thin, thick / thin)
