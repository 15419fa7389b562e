import math

import numpy as np
import pytest
from pydantic import ValidationError
from small_batches import SMALL, small_sweep

from sss_ref.batch.draws import chances
from sss_ref.batch.light_stage import LightStage
from sss_ref.batch.run import BatchExecution, run
from sss_ref.scene.load import load_scene
from sss_ref.view.matrices import outward

ARRAYS = BatchExecution(interpreter="arrays", threads=1)


def directions(stage, seed=0):
    """(N, 3), from the middle towards each light."""
    return np.array([outward(light["azimuth"], light["elevation"]) for (light,) in stage.lights(seed)])


def test_a_spiral_of_two_and_of_one():
    """Heights 1/2 and -1/2; the second a golden angle further: 180 * (3 - sqrt 5) degrees."""
    (first,), (second,) = LightStage(count=2).lights(0)
    assert (first["azimuth"], first["elevation"]) == (0.0, 30.0)
    assert second["elevation"] == -30.0
    assert second["azimuth"] == pytest.approx(137.50776405003785, abs=1e-13)  # worked out by hand
    assert LightStage(count=1).lights(0)[0][0]["elevation"] == 0.0


EVEN, DRAWN = LightStage(count=500), LightStage(count=500, directions="random")


@pytest.mark.parametrize("stage, off, least", [(EVEN, 0.003, 60), (DRAWN, 0.1, 40)])
def test_directions_are_spread_over_the_whole_sphere(stage, off, least):
    """Their mean is near 0, and in each octant there are about as many: 62.5 of 500."""
    found = directions(stage)
    assert np.abs(found.mean(axis=0)).max() < off
    octants = np.bincount((found > 0) @ [1, 2, 4], minlength=8)
    assert octants.sum() == 500 and octants.min() >= least


def test_the_spiral_leaves_no_gap():
    """The nearest neighbour of each of 200 is no closer than two thirds of the spacing of a square grid."""
    found = directions(LightStage(count=200))
    angles = np.arccos(np.clip(found @ found.T - 2 * np.eye(200), -1, 1))
    assert angles.min() > 2 / 3 * math.sqrt(4 * math.pi / 200)


def test_random_directions_are_those_of_the_seed():
    stage = LightStage(count=4, directions="random")
    assert stage.lights(7) == stage.lights(7) != stage.lights(8)
    assert stage.lights(7) == LightStage(count=9, directions="random").lights(7)[:4]


def test_random_directions_are_two_chances_each():
    """The azimuth is the first share of a turn, the height the second of what lies between -1 and 1."""
    for number, (light,) in enumerate(LightStage(count=5, directions="random").lights(3)):
        draws = chances(3, "olat", number)
        assert light["azimuth"] == 360 * next(draws)
        assert math.sin(math.radians(light["elevation"])) == pytest.approx(2 * next(draws) - 1, abs=1e-14)  # libm's


@pytest.mark.parametrize("count", [1, 10_000])
def test_as_many_lights_as_a_stage_may_have(count):
    assert LightStage(count=count).count == count
    for wrong in (0, 10_001):
        with pytest.raises(ValidationError, match="count"):
            LightStage(count=wrong)


def test_lights_are_parallel_unless_they_have_a_distance():
    (light,) = LightStage(count=1, intensity=3.0).lights(0)[0]
    assert light == {"type": "directional", "azimuth": 0.0, "elevation": 0.0, "intensity": 3.0}
    scene = load_scene("small", lights=LightStage(count=1, distance=5.0).lights(0)[0])
    light = scene.settings.lights[0]
    assert light.type == "point" and light.falloff == "none"
    assert light.target == (0.5, 0.5, 0.5) and light.position == (0.5, 0.5, 5.5)  # of the box from 0 to 1


def test_one_light_at_a_time_replaces_those_of_the_scene(tmp_path):
    kept = {"keep": ["image", "thickness"], "outputs": ["png"], "cameras": False}
    sweep = small_sweep(vary={"camera.azimuth": [0, 40]}, olat={"count": 3}, **kept)
    batch = run(sweep, tmp_path, ARRAYS)
    assert [each.state for each in batch.outcomes] == ["rendered"] * 6
    assert len({each.hashes["thickness"] for each in batch.outcomes}) == 6
    by_hand = small_sweep(
        set={**SMALL, "lights": LightStage(count=3).lights(0)[2]}, vary={"camera.azimuth": [40]}, **kept
    )
    (alone,) = run(by_hand, tmp_path / "by_hand", ARRAYS).outcomes
    assert alone.name == batch.outcomes[5].name and alone.hashes == batch.outcomes[5].hashes
