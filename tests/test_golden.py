"""The hashes that were found elsewhere, found again here: the same bits on every machine."""

import json
import sys
from pathlib import Path

import pytest

DATA = Path(__file__).parents[1] / "data"
sys.path.insert(0, str(DATA / "generate"))
GOLDEN = json.loads((DATA / "golden.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def golden():
    import golden

    return golden


@pytest.fixture(scope="module")
def asked(golden):
    return golden.asked()


def test_golden_hashes_are_of_these_rules():
    from sss_ref.rules import RULES_VERSION

    assert GOLDEN["rules_version"] == RULES_VERSION


@pytest.mark.parametrize("name", GOLDEN["scenes"])
def test_hashes_of_every_buffer(golden, asked, name):
    assert golden.hashes(*asked[name]) == GOLDEN["scenes"][name]


def test_every_shipped_scene_has_golden_hashes(asked):
    assert set(asked) == set(GOLDEN["scenes"])
