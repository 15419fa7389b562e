"""What a stage gets of the one before it in its shader, where a compiler may take the operations of both together."""

from typing import Any

import numpy as np

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.intervals.value_sets import componentwise
from sss_ref.language.types import ivec2
from sss_ref.numerics.interval import Interval, hull, point
from sss_ref.validation.accept.known import Known


def contracted(dumped: Known, given: Known | None, kind: Any, profile: Profile) -> Known:
    """A dumped value of a type as the next stage of its pass may have computed with it.

    given: all that its own stage may have given; None where nobody knows, which only "free" asks. "fused" (see
    `Profile`): a product that a sum takes was not rounded, so it may be anything between the two neighbours of what
    was; 0 is 0. "free": as well what its stage gives in any other order, unless a condition or a texel was in doubt
    there, which the dumped value has decided.
    """
    if profile.contraction == "unfused" or kind in (bool, int, ivec2):
        return dumped
    near = componentwise(_unrounded, dumped.bounds)
    if given is not None and profile.contraction == "free":
        near = componentwise(lambda a, b: _decided(a, b, given.doubt), near, given.bounds)
    return Known(dumped.exact, near, dumped.doubt)


def _unrounded(value: Any) -> Interval:
    """A value with its neighbours in float32."""
    a = value if isinstance(value, Interval) else point(value)
    low, high = (np.asarray(end, np.float32) for end in (a.low, a.high))
    return Interval(
        np.where(low == 0, low, np.nextafter(low, np.float32(-np.inf))),
        np.where(high == 0, high, np.nextafter(high, np.float32(np.inf))),
    )


def _decided(near: Interval, given: Interval, doubt: Any) -> Interval:
    """What is near, and what was given where nothing was in doubt."""
    both = hull(near, given)
    undecided = np.asarray(doubt) != 0
    return Interval(np.where(undecided, near.low, both.low), np.where(undecided, near.high, both.high))
