"""Time that is measured, and time that is up."""

import itertools

from sss_ref.validation import clock
from sss_ref.validation.clock import Clock, Limit


def ticking(monkeypatch):
    """Every look at the clock finds it a second later."""
    seconds = itertools.count()
    monkeypatch.setattr(clock.time, "perf_counter", lambda: float(next(seconds)))


def test_a_phase_that_comes_twice_is_added_up(monkeypatch):
    ticking(monkeypatch)
    told = []
    found = Clock(told.append)
    for name in ("one", "two", "one"):
        with found.phase(name):
            pass
    assert found.seconds == {"one": 2.0, "two": 1.0} and told == ["one", "two", "one"]


def test_what_would_begin_too_late_is_counted(monkeypatch):
    ticking(monkeypatch)
    limit = Limit(6)
    assert list(limit.within("letters", "abcde")) == ["a", "b"]
    assert list(limit.within("numbers", range(2))) == []
    assert limit.told == "not tried within 6 s: 3 letters, 2 numbers"


def test_what_would_end_too_late_is_not_begun(monkeypatch):
    now = 0.0
    monkeypatch.setattr(clock.time, "perf_counter", lambda: now)
    limit, made = Limit(10), []
    for letter, seconds in limit.within("letters", zip("abcde", (1, 4, 2, 1, 1), strict=True)):
        made.append(letter)
        now += seconds
    assert made == ["a", "b", "c"] and limit.told == "not tried within 10 s: 2 letters"
    assert list(limit.within("numbers", range(2))) == [0, 1]  # of which none has been long


def test_nothing_is_said_where_all_was_tried():
    limit = Limit(1000)
    assert list(limit.within("letters", "abc")) == ["a", "b", "c"] and limit.told == ""
