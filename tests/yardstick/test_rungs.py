"""Techniques that are rendered: which, with what keys, and how long they take."""

import time
from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.errors import SceneError
from sss_ref.yardstick import rungs as module
from sss_ref.yardstick.rungs import ALL, check_rungs, checked_methods, rungs

IMAGE = np.zeros((1, 1, 3), np.float32)


def yardstick(preset="robust"):
    """What a scene of it is: its method and keys."""
    settings = SimpleNamespace(preset=preset, mm_per_unit=4.0)
    return SimpleNamespace(given=SimpleNamespace(settings=settings), scene_of=lambda method, keys: (method, keys))


@pytest.fixture
def rendered(monkeypatch):
    """The renderings that are asked for; they take 5, 3 and 4 seconds, the first one of each rung much longer."""
    calls = []

    def render(scene, threads, keep):
        calls.append((scene, threads, keep))
        return SimpleNamespace(image=IMAGE)

    clock = iter(np.cumsum([10.0, 5.0, 100.0, 3.0, 100.0, 4.0] * 9).tolist())
    monkeypatch.setattr(module, "render", render)
    monkeypatch.setattr(time, "process_time", lambda: next(clock))
    return calls


def test_the_quickest_of_three_renderings_by_one_thread_counts(rendered):
    (found,) = rungs(yardstick(), ["burley"], None, lambda said: None)
    assert found.milliseconds == 3000 and found.image is IMAGE
    assert (found.name, found.keys) == ("burley, shipped", {})
    assert rendered == [(("burley", {}), 1, "final")] * 4  # one before, for what has to be compiled


def test_each_is_rendered_with_its_own_keys_and_those_that_are_fitted(rendered):
    fit = SimpleNamespace(keys=lambda unit, law: {"unit": unit, "law": law}, nearer_law="beer")
    told = []
    found = [*rungs(yardstick(), ["burley", "separable"], fit, told.append)]
    fitted = {"unit": 4.0, "law": "beer"}
    assert [(each.name, each.keys) for each in found] == [
        ("burley, shipped", {}),
        ("burley, fitted", fitted),
        ("separable, shipped", {}),
        ("separable, fitted", fitted),
    ]
    assert told == [f"rendering {each.name}" for each in found]


def test_all_techniques_unless_some_are_named_each_once():
    assert checked_methods([]) == ALL and len(set(ALL)) == len(ALL)
    assert {"screen_space", "burley"} <= set(ALL)
    assert checked_methods(["burley", "screen_space", "burley"]) == ("burley", "screen_space")
    with pytest.raises(SceneError, match="--methods: expected a technique, got 'burly'; did you mean burley"):
        checked_methods(["burley", "burly"])


@pytest.mark.parametrize(
    ("preset", "fitted", "fails"), [("published", True, True), ("published", False, False), ("paper", True, False)]
)
def test_a_published_scene_has_no_keys_to_fit(preset, fitted, fails):
    asked = []
    of = yardstick(preset)
    of.scene_of = lambda method, keys: asked.append((method, keys))
    if fails:
        with pytest.raises(SceneError, match=r'^preset: expected one whose keys can be fitted, got "published"; '):
            check_rungs(of, ["burley"], fitted)
        return
    check_rungs(of, ["burley", "separable"], fitted)
    assert asked == [("burley", {}), ("separable", {})]
