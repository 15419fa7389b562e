"""Stages made for parallel rays: naive loop, array code and kernel give one result, and what cannot be made is told."""

from functools import reduce
from types import FunctionType
from typing import NamedTuple

import naive_parallel
import numpy as np
import pytest
from fragments import random_inputs
from one_stage import assert_same_bits, call, run, run_naively

from sss_ref.errors import StageError
from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.language import length, normalize, stage, vec3
from sss_ref.language.parallel_rays import Rays
from sss_ref.methods.stages import all_stages

LIGHT = Rays("light_position", "light_direction", "_directional")
CAMERA = Rays("camera_position", "camera_direction", "_orthographic")
NAIVE = {
    name: value
    for name, value in vars(naive_parallel).items()
    if isinstance(value, FunctionType) and value.__module__ == "naive_parallel" and not name.startswith("_")
}
UP, DOWN = (0, 0, 1), (0, 0, -1)


class Found(NamedTuple):
    """What a stage of these tests asks a light."""

    answer: vec3


def made(name):
    """The stage that a naive form is of."""
    base = name.removesuffix("_orthographic").removesuffix("_directional")
    rays = [each for each in (LIGHT, CAMERA) if each.suffix in name]
    return reduce(lambda one, own: own.of(one), rays, all_stages()[base])


@pytest.mark.parametrize("name", NAIVE)
def test_array_code_and_kernel_give_the_bits_of_the_naive_loop(name):
    stage_, inputs = made(name), random_inputs(np.random.default_rng(3), 24, 16)
    assert stage_.name == name
    expected = run_naively(NAIVE[name], stage_, inputs)
    assert_same_bits(run(arrays, stage_, inputs), expected)
    assert_same_bits(run(kernel, stage_, inputs), expected)


OURS = [each for each in all_stages().values() if "published" not in each.python.__module__]


@pytest.mark.parametrize("own", [each for each in OURS if each.name != "back_point"], ids=lambda own: own.name)
def test_every_stage_can_be_made_but_the_one_with_a_twin(own):
    turned = CAMERA.of(LIGHT.of(own))
    assert ("light_position" in turned.reads) <= ("light_direction" in turned.reads)
    assert ("camera_position" in turned.reads) <= ("camera_direction" in turned.reads)


def test_a_distance_counts_from_the_plane_and_along_the_rays():
    distance = LIGHT.of(all_stages()["distance_to_light"])
    given = {"light_position": (9, 9, 5), "light_direction": DOWN}
    assert call(distance, fragment_position=(0, 0, 2), **given) == (3,)
    assert call(distance, fragment_position=(0, 0, 7), **given) == (-2,)


def test_a_name_that_a_stage_has_given_itself_is_left_to_it():
    @stage(source="a test")
    def asks(position_world: vec3, light_position: vec3) -> Found:
        light_direction = normalize(position_world - light_position)
        return Found(light_direction * length(light_position - position_world))

    turned = LIGHT.of(asks)
    assert turned.reads == {
        "position_world": "position_world",
        "light_position": "light_position",
        "light_direction_": "light_direction",
    }
    assert list(turned.parameters) == list(turned.reads) == ["position_world", "light_position", "light_direction_"]
    given = {"position_world": (1, 2, 3), "light_position": (0, 0, 5), "light_direction_": DOWN}
    assert call(turned, **given) == ((0, 0, -2),)


def test_a_stage_that_reads_the_direction_is_left_as_it_is():
    own = all_stages()["back_point_parallel"]
    assert LIGHT.of(own) is own
    assert LIGHT.of(all_stages()["surface"]) is all_stages()["surface"]


def test_a_question_that_parallel_rays_do_not_answer_is_told():
    with pytest.raises(StageError) as caught:
        LIGHT.of(all_stages()["back_point"])
    assert str(caught.value) == (
        "stage back_point: expected light_position as O in normalize(O - P), normalize(P - O) or length(P - O) where "
        "rays are parallel, got it elsewhere; let the stage read light_direction too"
    )
