"""Counts do not depend on threads, on pauses, or on whether anything is compiled."""

import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest
from meeting import Meeting

from sss_ref.errors import SceneError
from sss_ref.truth import tally
from sss_ref.truth.counting import ring
from sss_ref.truth.photon import ABSORBED, REFLECTED, TRANSMITTED, Setup, Volume
from sss_ref.truth.tally import Tally, Walk, nothing_walked, read_tally

SKIN = Volume(0.74, 0.032, 0.3, 1.3)
BEAM = Walk(SKIN, Setup(math.inf, False), (0.5, 1.0, 2.0, 8.0), seed=5)


def same(one, other):
    return one.photons == other.photons and np.array_equal(one.counts, other.counts)


@pytest.fixture
def small_blocks(monkeypatch):
    monkeypatch.setattr(tally, "BLOCK", 100)


def test_the_same_bits_from_one_two_and_three_threads(small_blocks):
    one, two, three = (nothing_walked(BEAM).more(1050, threads) for threads in (1, 2, 3))
    assert same(one, two) and same(one, three)
    assert one.counts.sum() == 1050


def test_two_goes_are_as_one(small_blocks, tmp_path):
    at_once = nothing_walked(BEAM).more(1300)
    nothing_walked(BEAM).more(650).save(tmp_path / "tally.json")
    assert same(read_tally(tmp_path / "tally.json", BEAM).more(650), at_once)
    assert [path.name for path in tmp_path.iterdir()] == ["tally.json"]


def test_other_seeds_are_other_photons():
    other = Walk(SKIN, BEAM.setup, BEAM.radii, seed=6)
    assert not same(nothing_walked(BEAM).more(500), nothing_walked(other).more(500))


def test_plain_python_counts_the_same():
    code = (
        "import math; from sss_ref.truth.tally import *; "
        f"of = Walk(Volume(*{tuple(SKIN)}), Setup(math.inf, False), {BEAM.radii}, 5); "
        "print(nothing_walked(of).more(150, threads=1).counts.tolist())"
    )
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == nothing_walked(BEAM).more(150).counts.tolist()


def test_progress_is_told(small_blocks):
    told = []
    nothing_walked(BEAM).more(150).more(250, on_progress=lambda done, wanted: told.append((done, wanted)))
    assert told == [(100, 250), (200, 250), (250, 250)]


def test_a_ring_has_its_outer_radius():
    squares = np.array([1.0, 4.0])
    assert [ring(squares, square) for square in (0.0, 1.0, 1.5, 4.0, 5.0)] == [0, 0, 1, 1, 2]


def test_the_file_of_another_walk_is_refused(tmp_path):
    path = tmp_path / "tally.json"
    nothing_walked(BEAM).more(10).save(path)
    with pytest.raises(SceneError, match=r"tally\.json: expected the tally of this walk, got another one's"):
        read_tally(path, Walk(SKIN, BEAM.setup, BEAM.radii, seed=6))


@pytest.mark.parametrize(
    "change",
    [
        *({"photons": 11}, {"photons": "many"}, {"photons": 10.0}, {"photons": [10]}),
        *({"counts": [[1]]}, {"counts": [[1], 2]}, {"counts": 10**40}, {"format": "sss_ref tally 0"}),
    ],
    ids=str,
)
def test_what_is_no_tally_is_refused(tmp_path, change):
    path = tmp_path / "tally.json"
    nothing_walked(BEAM).more(10).save(path)
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    check_is_no_tally(path)


@pytest.mark.parametrize("text", ["{", "[]", "[" * 100_000], ids=len)
def test_what_is_no_record_is_refused(tmp_path, text):
    (tmp_path / "tally.json").write_text(text)
    check_is_no_tally(tmp_path / "tally.json")


def test_counts_below_0_are_refused(tmp_path):
    """Their sum is right."""
    path = tmp_path / "tally.json"
    tally = nothing_walked(BEAM).more(10)
    tally.counts[0, 0, :2] += [100, -100]
    tally.save(path)
    check_is_no_tally(path)


def check_is_no_tally(path):
    with pytest.raises(SceneError, match="expected a tally, got something else; delete the file"):
        read_tally(path, BEAM)


@pytest.mark.parametrize(
    ("volume", "thickness", "line"),
    [
        (Volume(1.0, 0.0), math.inf, "absorption: expected more than 0 where the body has no end"),
        (Volume(-1.0, 2.0), 1.0, "scattering: expected a number per mm, 0 or more, got -1"),
        (Volume(1.0, math.nan), 1.0, "absorption: expected a number per mm, 0 or more, got nan"),
        (Volume(0.0, 0.0), 1.0, "extinction: expected more than 0"),
        (Volume(1.0, 1.0, 1.0), 1.0, "anisotropy: expected a number between -1 and 1, got 1; correct"),
        (Volume(1.0, 1.0, -1.0), 1.0, "anisotropy: expected a number between -1 and 1, got -1"),
        (Volume(math.inf, 1.0), 1.0, "scattering: expected a number per mm, 0 or more, got inf"),
        (Volume(1.0, math.inf), 1.0, "absorption: expected a number per mm, 0 or more, got inf"),
        (Volume(1.0, 1.0, 0.0, math.inf), 1.0, "ior: expected 1 or more, got inf"),
        (Volume(1.0, 1.0, 0.0, 0.9), 1.0, "ior: expected 1 or more, got 0.9"),
        (Volume(1.0, 1.0), 0.0, "thickness: expected more than 0 mm"),
    ],
)
def test_what_cannot_be_walked_is_refused(volume, thickness, line):
    with pytest.raises(SceneError, match=line):
        Walk(volume, Setup(thickness, True), ())


def test_progress_is_told_every_16384_photons():
    told = []
    nothing_walked(BEAM).more(20_000, on_progress=lambda *found: told.append(found))
    assert told == [(16_384, 20_000), (20_000, 20_000)]


@pytest.mark.parametrize(("asked", "used"), [(1, 1), (2, 2), (None, 3)])
def test_so_many_threads_share_the_work(small_blocks, monkeypatch, asked, used):
    """As many at a time as are asked for, else one per processor: none goes on before all are there."""
    work = Meeting(used)
    monkeypatch.setattr(os, "cpu_count", lambda: 3)
    monkeypatch.setattr(tally, "count_photons", work)
    nothing_walked(BEAM).more(600, asked)
    assert len(work.threads) == used


def test_shares_are_of_one_fate():
    walked = Tally(BEAM, 10, np.arange(1, 46).reshape(3, 3, 5))
    assert walked.share(REFLECTED) == 12 and walked.share(ABSORBED) == 57
    half = Tally(BEAM, 16, np.full((3, 3, 5), 0))
    half.counts[TRANSMITTED, 1:, 2] = 1, 3
    assert (half.share(TRANSMITTED), half.share_error(TRANSMITTED)) == (0.25, math.sqrt(0.25 * 0.75 / 16))


COUNTS = {  # reflected, transmitted, absorbed; scattered never, once, more often
    (Volume(2.0, 0.1, 0.6, 1.4), True): [[0, 2, 52], [20, 29, 104], [13, 12, 68]],
    (Volume(2.0, 0.1, 0.6, 1.4), False): [[0, 2, 64], [30, 32, 97], [10, 7, 58]],
    (Volume(1.0, 0.3), True): [[0, 47, 49], [42, 28, 18], [63, 24, 29]],
}


@pytest.mark.parametrize(("volume", "diffuse"), COUNTS, ids=str)
def test_the_same_photons_are_counted_everywhere(volume, diffuse):
    found = nothing_walked(Walk(volume, Setup(1.0, diffuse), ())).more(300)
    assert found.counts[:, :, 0].tolist() == COUNTS[volume, diffuse]


@pytest.mark.parametrize(
    "setup", [(Volume(0.0, 0.5), 1.0), (Volume(1.0, 0.0), 1.0), (Volume(1.0, 1.0, -0.99, 1.0), 1e-9)], ids=str
)
def test_what_can_just_be_walked(setup):
    volume, thickness = setup
    assert Walk(volume, Setup(thickness, True), ()).volume == volume
