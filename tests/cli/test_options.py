"""What several commands are given: what goes together, and what comes of it."""

import pytest

from sss_ref.cli.options import Changes, Execution, Haste, Wanted
from sss_ref.errors import SceneError
from sss_ref.validation.scope import FEW_SECONDS, SECONDS


def test_what_is_not_given_overrides_nothing():
    assert Changes().overrides() == {}
    assert Changes(preset="paper").overrides() == {"preset": "paper"}
    assert Changes(method="burley", size="3X4").overrides() == {
        "method": "burley",
        "camera.width": 3,
        "camera.height": 4,
    }


@pytest.mark.parametrize("size", ["3", "x", "3x", "x4", "axb", "3x4x5", "-3x4", "3.5x4", ""])
def test_a_size_is_two_whole_numbers(size):
    with pytest.raises(SceneError, match="--size: expected WIDTHxHEIGHT, got"):
        Changes(size=size).overrides()


@pytest.mark.parametrize("assignment", ["camera.width", "=3", "=", ""])
def test_an_assignment_has_a_key_and_a_value(assignment):
    with pytest.raises(SceneError, match=r"--set: expected key\.path=value, got"):
        Changes(set=(assignment,)).overrides()


@pytest.mark.parametrize("threads", [None, 1, 2])
def test_one_thread_is_the_least(threads):
    assert Execution(threads=threads).threads == threads
    with pytest.raises(SceneError, match="--threads: expected at least 1, got 0"):
        Execution(threads=0)


@pytest.mark.parametrize(
    "given",
    [
        {},
        {"until": "lit"},
        {"until": "lit", "keep": "all"},
        {"keep": "final"},
        {"keep": "all"},
        {"samples": 2},
        {"samples": 2, "keep": "final"},
        {"samples": 1, "keep": "all"},
        {"samples": 1, "until": "lit"},
    ],
)
def test_what_may_be_wanted_together(given):
    wanted = Wanted(**given)
    assert (wanted.until, wanted.keep, wanted.samples) == (
        given.get("until"),
        given.get("keep"),
        given.get("samples", 1),
    )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"until": "lit", "keep": "final"}, "--until: expected without --keep final"),
        ({"samples": 2, "until": "lit"}, "--samples: expected without --until and --keep all"),
        ({"samples": 2, "keep": "all"}, "--samples: expected without --until and --keep all"),
        ({"samples": 0, "keep": "all"}, "--samples: expected without --until and --keep all"),
    ],
)
def test_what_may_not(given, message):
    with pytest.raises(SceneError, match=message):
        Wanted(**given)


@pytest.mark.parametrize(
    ("quick", "power", "reported", "is_worked_out"),
    [
        (False, None, False, False),
        (False, None, True, True),
        (True, None, True, False),
        (True, None, False, False),
        (False, True, False, True),
        (True, True, False, True),
        (False, False, True, False),
    ],
)
def test_how_small_an_error_would_be_seen_is_for_reports(quick, power, reported, is_worked_out):
    scope = Haste(only="phong", quick=quick, power=power).scope(reported)
    assert (scope.stage, scope.seconds) == ("phong", FEW_SECONDS if quick else SECONDS)
    assert scope.power is is_worked_out
