"""The exercises of lesson 8: float32."""

from collections.abc import Callable

import numpy as np

from sss_ref.course.checks.answers import NotYet


def ulps_between(answer: Callable[[np.float32, np.float32], int]) -> None:
    """08: how many steps lead from one float32 to another; both are positive."""
    zero, least, one, two = np.float32(0), np.float32(2.0**-149), np.float32(1), np.float32(2)
    pairs = [(one, one), (np.nextafter(two, one), two), (one, two), (two, np.float32(3)), (np.float32(0.5), two)]
    for a, b in [*pairs, (zero, least), (np.float32(4), np.nextafter(np.float32(4), zero))]:
        expected = abs(int(a.view(np.int32)) - int(b.view(np.int32)))
        got = answer(a, b)
        if got != expected:
            raise NotYet(
                f"from {a!s} to {b!s} there are {expected} steps, and you count {got}. "
                "The steps change at every power of two; what does not change is how the bit patterns are ordered."
            )
