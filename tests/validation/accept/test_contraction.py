"""What one stage hands to the next in its shader: rounded, or as a compiler had it that took both together."""

from dataclasses import replace

import numpy as np
import pytest
from scenes import LIGHT, around, sphere, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.types import vec2
from sss_ref.numerics.interval import Interval
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.contraction import contracted
from sss_ref.validation.accept.known import Known
from sss_ref.validation.stage_by_stage import validate

F = np.float32
DUMPED = F([1.0, -0.75, 0.0])
UP, DOWN = F([1.0 + 2.0**-23, -0.75 + 2.0**-24, 0.0]), F([1.0 - 2.0**-24, -0.75 - 2.0**-24, 0.0])
LOW, HIGH = DUMPED - F(0.25), DUMPED + F(0.5)


def profile(contraction):
    return replace(PROFILES["vulkan"], contraction=contraction)


def handed_on(contraction, kind=float, doubt=0):
    """The ends of a dumped value of which its own stage may have given LOW to HIGH."""
    given = Known(DUMPED, Interval(LOW, HIGH), np.full(3, doubt, np.uint8))
    return contracted(Known.exactly(DUMPED), given, kind, profile(contraction))


def test_unfused_it_is_what_was_dumped():
    assert handed_on("unfused").bounds is DUMPED


def test_fused_it_lies_between_its_neighbours():
    bounds = handed_on("fused").bounds
    assert bounds.low.tobytes() == DOWN.tobytes() and bounds.high.tobytes() == UP.tobytes()


def test_free_it_is_what_the_stage_may_give_but_where_that_was_in_doubt():
    bounds = handed_on("free").bounds
    assert bounds.low.tobytes() == LOW.tobytes() and bounds.high.tobytes() == HIGH.tobytes()
    decided = handed_on("free", doubt=1).bounds
    assert decided.low.tobytes() == DOWN.tobytes() and decided.high.tobytes() == UP.tobytes()


@pytest.mark.parametrize("kind", [int, bool])
def test_whole_numbers_and_truth_values_are_never_contracted(kind):
    assert handed_on("free", kind).bounds is DUMPED


def test_every_component_of_a_vector_is_widened():
    dumped = Known.exactly(vec2(DUMPED, DUMPED))
    given = Known(dumped.exact, vec2(Interval(LOW, HIGH), Interval(DUMPED, DUMPED)), np.uint8(0))
    bounds = contracted(dumped, given, vec2, profile("free")).bounds
    assert bounds.x.high.tobytes() == HIGH.tobytes() and bounds.y.high.tobytes() == UP.tobytes()


@pytest.fixture(scope="module")
def two_lights(tmp_path_factory):
    """A rendering, and its dump of a compiler that takes the colour out of the sum of what two lights give."""
    path = written(tmp_path_factory.mktemp("ball") / "sphere.obj", *sphere(12))
    lights = [{"position": LIGHT, "color": [0.9, 0.7, 0.3]}, {"position": [-3.0, 0.5, 1.0], "color": [0.3, 0.5, 0.9]}]
    scene = load_scene(around(path, 64, lights=lights, mesh={"path": path, "color": [0.7, 0.3, 0.9]}))
    oracle = render(scene, interpreter="arrays")
    albedo, one, other = (oracle.buffers[name] for name in ("albedo", "phong_1", "phong_2"))
    seen = oracle.buffers["coverage"] == 1
    phong = oracle.buffers["phong"].copy()
    phong[seen] = ((one[seen] / albedo[seen]) + (other[seen] / albedo[seen])) * albedo[seen]
    return oracle, {**oracle.buffers, "phong": phong}


def test_a_sum_taken_together_with_what_it_sums_passes_if_it_may(two_lights):
    oracle, dumped = two_lights
    found = validate(oracle, dumped, profile=profile("unfused"), explain=False)
    assert found.culprit.stage == "plus" and found.culprit.buffer == "phong"
    assert validate(oracle, dumped, profile=profile("free"), explain=False).verdicts[-1].buffer == "image"
    named = [
        one.buffer for one in validate(oracle, dumped, profile=profile("free"), explain=False).verdicts if one.failed
    ]
    assert "phong" not in named


def test_a_wrong_sum_does_not(two_lights):
    oracle, dumped = two_lights
    wrong = {**dumped, "phong": dumped["phong"] * F(1.0001)}
    assert validate(oracle, wrong, profile=profile("free"), explain=False).culprit.stage == "plus"
