import math

import pytest

from sss_ref.batch.plan import Plan
from sss_ref.batch.turntable import turntable
from sss_ref.errors import SceneError

LOOK_AT = {"camera": {"type": "look_at", "eye": [1, 2, 5], "target": [1, 0, 1]}}


def test_an_orbit_begins_where_the_scene_has_it():
    plan = Plan(turntable("small", 4, {"camera.azimuth": 10, "camera.width": 32}))
    assert [plan[item] for item in range(len(plan))] == [{"camera.azimuth": 10 + 90 * turn} for turn in range(4)]
    assert plan.overrides(1) == {"camera.azimuth": 100, "camera.width": 32}


def test_an_eye_turns_as_azimuth_does_and_keeps_height_and_distance():
    plan = Plan(turntable("small", 4, LOOK_AT))
    assert [plan[item]["camera.eye"] for item in range(4)] == [[1, 2, 5], [5, 2, 1], [1, 2, -3], [-3, 2, 1]]
    eighth = Plan(turntable("small", 8, LOOK_AT))[1]["camera.eye"]
    assert eighth == pytest.approx([1 + 4 * math.sqrt(0.5), 2, 1 + 4 * math.sqrt(0.5)], rel=1e-14)  # libm's rounding


def test_a_free_camera_has_nothing_to_turn_around():
    with pytest.raises(SceneError, match=r'small: camera: expected a target to turn around, got one of type "free"'):
        turntable("small", 4, {"camera": {"type": "free", "position": [0, 0, 5]}})


@pytest.mark.parametrize("frames", [2, 10_000])
def test_two_frames_are_a_turn_and_so_are_ten_thousand(frames):
    assert len(Plan(turntable("small", frames, {}))) == frames


@pytest.mark.parametrize("frames", [1, 10_001])
def test_too_few_and_too_many_frames(frames):
    with pytest.raises(SceneError, match=f"--frames: expected 2 to 10000, got {frames}"):
        turntable("small", frames, {})
