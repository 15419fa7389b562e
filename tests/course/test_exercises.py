"""What exercises ask of an answer and say to a wrong one: every number of theirs, in a text that was looked at."""

from pathlib import Path

import pytest
from asked_exercises import part, parts

EXPECTED = dict(zip(parts(), Path(__file__).with_name("exercises.txt").read_text("utf-8").split("\n\n"), strict=True))


@pytest.mark.parametrize("name", EXPECTED)
def test_an_exercise_asks_the_same_as_ever(name):
    """Where one is meant to change, tests/support/asked_exercises.py says how."""
    assert part(name) == EXPECTED[name].strip()
