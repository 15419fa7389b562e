"""The processors that have a name, and what follows from a profile's numbers."""

import dataclasses

import pytest

from sss_ref.interpret.intervals.profile import PROFILES, Profile
from sss_ref.numerics.bounded import Bounded
from sss_ref.numerics.ieee import Ieee

UNIT = 2.0**-8  # texels


def test_the_profiles_are_what_the_specifications_ask():
    """OpenGL ES asks of mediump 2^-10, from 2^-14 to 2^14; OpenGL 1 part in 10^5."""
    plain = Bounded()
    assert {name: (each.weight_bits, each.filter_bits, each.nearest_slack) for name, each in PROFILES.items()} == {
        "ieee": (0, 0, 0.0),
        **dict.fromkeys(("vulkan", "wgsl", "gl", "mediump"), (8, 8, UNIT)),
    }
    assert isinstance(PROFILES["ieee"].arithmetic, Ieee) and PROFILES["vulkan"].arithmetic == plain
    assert PROFILES["gl"].arithmetic == Bounded(relative=0.00001)
    mediump = PROFILES["mediump"]
    assert mediump.arithmetic == Bounded(relative=1 / 1024, smallest_normal=1 / 16384, largest=16384.0)
    assert mediump.for_vertices.arithmetic == plain and PROFILES["gl"].for_vertices is PROFILES["gl"]
    others = {(each.subpixel_bits, each.snap, each.depth_format, each.reversed_depth) for each in PROFILES.values()}
    assert others == {(8, "nearest", "D32F", False)}
    assert [name for name, each in PROFILES.items() if each.contraction != "unfused"] == ["wgsl"]


@pytest.mark.parametrize(("bits", "slack"), [(0, 0.0), (1, 0.5), (8, UNIT)])
def test_a_position_is_off_by_its_last_bit(bits, slack):
    assert Profile(weight_bits=bits).position_slack == slack


@pytest.mark.parametrize(("bits", "span", "slack"), [(0, 1.0, 0.0), (8, 1.0, 2 / 255), (2, 3.0, 2.0), (1, 0.25, 0.5)])
def test_a_filter_of_bytes_is_off_by_a_step_along_each_axis(bits, span, slack):
    assert Profile(filter_bits=bits).filter_slack(span) == slack


@pytest.mark.parametrize(
    ("changes", "exactly"),
    [({}, True), ({"snap": "any"}, False), ({"arithmetic": Bounded()}, False), ({"subpixel_bits": 4}, True)],
)
def test_one_triangle_a_pixel_where_all_is_rounded_and_snapped_in_one_way(changes, exactly):
    assert dataclasses.replace(PROFILES["ieee"], **changes).draws_exactly == exactly
