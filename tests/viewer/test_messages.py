"""What a page may say, up to the last value that is taken and the first that is not."""

import json

import pytest

from sss_ref.errors import SceneError
from sss_ref.viewer.messages import message_of

TURN = {"kind": "turn", "right": 0.5, "up": -0.25}
ZOOM = {"kind": "zoom", "factor": 1.0}
LIGHT = {"kind": "move_light", "light": 0, "right": 0.0, "up": 0.0, "behind": False}
SHOW = {"kind": "show", "buffer": "image"}
TAKEN = [
    *(TURN | {key: way} for key in ("right", "up") for way in (-10, 10)),
    *(ZOOM | {"factor": factor} for factor in (0.05, 20)),
    *(LIGHT | {"factor": factor} for factor in (0.05, 20)),
    *(LIGHT | {"light": light} for light in (0, 63)),
    SHOW | {"buffer": "x" * 300},
    {"kind": "drawn"},
    {"kind": "restore", "data": {"camera": {}}},
]
REFUSED = [
    *((TURN | {key: way}, f"turn.{key}") for key in ("right", "up") for way in (-10.001, 10.001)),
    *((ZOOM | {"factor": factor}, "zoom.factor") for factor in (0.0499, 20.01)),
    *((LIGHT | {"factor": factor}, "move_light.factor") for factor in (0.0499, 20.01)),
    *((LIGHT | {"light": light}, "move_light.light") for light in (-1, 64)),
    (SHOW | {"buffer": "x" * 301}, "show.buffer"),
    (SHOW | {"more": 1}, "show.more"),
    (TURN | {"right": "0.5"}, "turn.right"),
    (TURN | {"right": float("nan")}, "turn.right"),
]


@pytest.mark.parametrize("said", TAKEN, ids=json.dumps)
def test_a_message_is_read_as_it_was_said(said):
    read = message_of(json.dumps(said)).model_dump()
    assert {key: read[key] for key in said} == said


def test_a_light_that_is_dragged_keeps_its_distance_unless_it_is_said():
    assert message_of(json.dumps(LIGHT)).factor == 1


@pytest.mark.parametrize(("said", "where"), REFUSED)
def test_what_is_beyond_is_refused_with_its_place(said, where):
    with pytest.raises(SceneError) as caught:
        message_of(json.dumps(said))
    assert (
        str(caught.value) == f"message: {where}: expected what this page sends, got something else; load the page again"
    )


def test_a_message_cannot_be_changed():
    with pytest.raises(ValueError, match="frozen"):
        message_of(json.dumps(TURN)).up = 1.0
