"""What a preset, a material and a table fill in is what scene files were written for: none of it moves unseen."""

from pathlib import Path

import pytest
from filled_scenes import text

EXPECTED = Path(__file__).with_name("filled.txt").read_text(encoding="utf-8").split("\n\n")


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    return text(tmp_path_factory.mktemp("scene")).split("\n\n")


@pytest.mark.parametrize("part", range(len(EXPECTED)), ids=[part.partition("\n")[0].strip("[]") for part in EXPECTED])
def test_a_scene_is_filled_as_ever(found, part):
    """Where a default is meant to change, tests/support/filled_scenes.py says how."""
    assert len(found) == len(EXPECTED)
    assert found[part].strip() == EXPECTED[part].strip()
