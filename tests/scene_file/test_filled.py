"""What a preset, a material and a table fill in is what scene files were written for: none of it moves unseen."""

from pathlib import Path

import pytest
from filled_scenes import part, parts

EXPECTED = dict(zip(parts(), Path(__file__).with_name("filled.txt").read_text("utf-8").split("\n\n"), strict=True))


@pytest.mark.parametrize("name", EXPECTED)
def test_a_scene_is_filled_as_ever(name, tmp_path):
    """Where a default is meant to change, tests/support/filled_scenes.py says how."""
    assert part(name, tmp_path) == EXPECTED[name].strip()
