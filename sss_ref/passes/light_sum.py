"""Several lights: what each contributes is summed in the order of the scene file."""

from typing import NamedTuple

from sss_ref.language import stage, vec3


class Sum(NamedTuple):
    """Two contributions as one."""

    total: vec3  # linear RGB


@stage(source="light adds")
def plus(first: vec3, second: vec3) -> Sum:
    """first + second."""
    return Sum(first + second)
