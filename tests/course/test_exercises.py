"""What exercises ask of an answer and say to a wrong one: every number of theirs, in a text that was looked at."""

from pathlib import Path

import pytest
from asked_exercises import text

EXPECTED = Path(__file__).with_name("exercises.txt").read_text(encoding="utf-8").split("\n\n")


@pytest.fixture(scope="module")
def found():
    return text().split("\n\n")


def test_there_is_a_part_for_each_exercise_and_for_the_fragments(found):
    assert len(found) == len(EXPECTED)


@pytest.mark.parametrize("part", range(len(EXPECTED)), ids=[part.partition("\n")[0].strip("[]") for part in EXPECTED])
def test_an_exercise_asks_the_same_as_ever(found, part):
    """Where one is meant to change, tests/support/asked_exercises.py says how."""
    assert found[part].strip() == EXPECTED[part].strip()
