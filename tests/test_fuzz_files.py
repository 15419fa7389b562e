"""Files with anything in them are read right, or refused in lines of ours. `benchmarks/fuzz_files.py` tries many."""

import random

import changed_files
import fuzzed_readers
import fuzzing
import harmless_changes
import numpy as np
import pytest
from fuzzing import changed_files as files_of
from fuzzing import outcome, trials
from valid_files import valid_files

from sss_ref.errors import DumpError, MeshError

SEEDS = range(500)


def test_nothing_is_wrong_with_changed_files():
    """Of each kind some; some of them are read, some refused, and harmless changes make no difference."""
    found = list(trials(SEEDS))
    assert [trial for trial in found if trial.fault] == []
    assert {trial.kind for trial in found} == set(fuzzing.KINDS)
    assert {trial.came for trial in found} == {"read", "refused", "same"}


def test_each_is_valid_before_it_is_changed(tmp_path):
    for valid in valid_files():
        came, _, fault = outcome(valid, valid.files, tmp_path / "a")
        assert (valid.name, came, fault) == (valid.name, "read", None)


@pytest.mark.parametrize("suffix", sorted({*changed_files.OF_SUFFIX, *harmless_changes.OF_SUFFIX, ".exr", ".tif"}))
def test_changes_change_something(suffix):
    """Every change that there is for a kind of file, at one time or another."""
    named = [(name, data) for valid in valid_files() for name, data in valid.files.items() if name.endswith(suffix)]
    assert named
    for make, of_suffix in (
        (changed_files.changed, changed_files.OF_SUFFIX),
        (harmless_changes.harmless, harmless_changes.OF_SUFFIX),
    ):
        done = set()
        for seed in range(150):
            rng = random.Random(seed)
            name, data = named[seed % len(named)]
            made = make(rng, name, data)
            done |= {made[1]} if made and made[0] != data else set()
        assert {each.__name__ for each in of_suffix.get(suffix, ())} <= done


def test_a_seed_gives_the_same_files():
    assert [files_of(seed)[2:] for seed in range(20)] == [files_of(seed)[2:] for seed in range(20)]


@pytest.fixture
def mesh():
    return next(each for each in valid_files() if each.kind == "mesh")


def raised(error):
    def read(path):
        raise error

    return read


def test_what_is_no_error_of_ours_is_a_fault(monkeypatch, tmp_path, mesh):
    for error, fault in (
        (ValueError("a"), "ValueError: a"),
        (MeshError("a"), "no line of ours: 'a'"),
        (DumpError("a: expected b, got \x1b; d"), "no line of ours"),
        (DumpError("a: expected b, got c; d\nb"), "no line of ours: 'b'"),
    ):
        monkeypatch.setitem(fuzzing.KINDS, "mesh", raised(error))
        assert fault in outcome(mesh, mesh.files, tmp_path / "a")[2]
    monkeypatch.setitem(fuzzing.KINDS, "mesh", raised(MeshError("a: expected b, got c; d")))
    assert outcome(mesh, mesh.files, tmp_path / "a")[2] is None


@pytest.mark.parametrize("value", [np.float32("nan"), float("inf")], ids=str)
def test_what_is_not_finite_is_a_fault(monkeypatch, tmp_path, mesh, value):
    found = {"a": [1.0, {"b": np.array([1.0, value]) if isinstance(value, np.floating) else value}]}
    monkeypatch.setitem(fuzzing.KINDS, "mesh", lambda path: list(fuzzed_readers.facts("m", found)))
    assert outcome(mesh, mesh.files, tmp_path / "a")[2] == "m.a.1.b is not finite"


def test_a_harmless_change_that_matters_is_a_fault(monkeypatch, tmp_path):
    seed = next(seed for seed in range(1000) if files_of(seed)[0] and files_of(seed)[1].kind == "mesh")
    assert fuzzing.tried(seed, tmp_path).fault is None
    files = iter("ab")
    monkeypatch.setitem(fuzzing.KINDS, "mesh", lambda path: [("mesh", next(files), True)])
    assert "a harmless change matters" in fuzzing.tried(seed, tmp_path).fault


def test_a_reader_that_takes_too_long_is_ended_and_the_next_is_read():
    running = trials(range(1000), seconds=1e-5)  # a tick of the processor's clock is more, so not the first may be
    ended = next(trial for trial in running if trial.came == "ended")
    assert ended.fault == "more than 1e-05 s of processor time"
    assert next(running).seed == ended.seed + 1
    running.close()
