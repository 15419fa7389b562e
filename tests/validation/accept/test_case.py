"""What is known of a case is known of this one alone."""

from dataclasses import replace

import numpy as np
import pytest
from scenes import around, two_squares, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing


@pytest.fixture(scope="module")
def oracle(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("squares") / "squares.obj", *two_squares())
    return render(load_scene(around(path, 8)), "arrays")


def test_what_stands_in_for_a_buffer_is_that_of_its_drawing(oracle):
    """Of depths that say which square is seen, and of none."""
    case = Case(oracle, Drawing({}), replace(PROFILES["vulkan"], snap="any", subpixel_bits=4))
    alone = case.read("light_distance")
    assert case.read("light_distance") is alone
    beside = replace(case, drawing=Drawing({"light_triangle": oracle["light_triangle"]})).read("light_distance")
    assert beside is not alone and (beside.low != alone.low).any()
    assert np.array_equal(case.of_oracle.read("light_distance").low, oracle["light_distance"])


def test_what_was_dumped_is_read_as_it_is(oracle):
    dumped = oracle["light_distance"] + np.float32(1)
    assert Case(oracle, Drawing({"light_distance": dumped}), PROFILES["vulkan"]).read("light_distance").exact is dumped


def test_what_a_rasterizer_may_show_is_found_once_unless_it_reads_a_buffer(oracle):
    case = Case(oracle, Drawing({}), PROFILES["vulkan"])
    this_pass = oracle.scene.method["shadow_map"]
    assert case.visible(this_pass) is case.visible(this_pass) is case.of_oracle.visible(this_pass)
    assert Case(oracle, Drawing({}), PROFILES["ieee"]).visible(this_pass) is None
    assert case.visible(oracle.scene.method["blur"]) is None
