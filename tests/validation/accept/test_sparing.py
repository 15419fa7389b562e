"""Where bounds are spared nothing changes: neither what is right nor, where they are worked out, what they are."""

from dataclasses import replace

import numpy as np
import pytest
from one_stage import assert_same_bits
from scenes import LIGHT, around, sphere, written

from sss_ref.dump.held import HELD
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import machine_of, render
from sss_ref.scene.load import load_scene
from sss_ref.validation import stage_by_stage
from sss_ref.validation.accept import sparing
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import RASTERIZER, checks
from sss_ref.validation.accept.sparing import NEEDED, SAMPLED, Sparing, sampled
from sss_ref.validation.accept.walk import groups
from sss_ref.validation.stage_by_stage import validate
from sss_ref.validation.verdict.outcomes import AMBIGUOUS, CERTAIN, FAIL, NOT_COMPARED, Compared, outcome_map

SIDE, SAMPLE = 48, 60
FEW = ("triangle", "coverage", "light_triangle", "position_world", "thickness", "directly_lit", "translucency", "image")
HALVES = ("phong", "lit")
SAME = ("buffer", "compared", "equal", "within", "undefined", "ulps", "first", "worst", "background", "chained")
TWO_LIGHTS = {"lights": [{"position": LIGHT}, {"position": [-3.0, 0.5, 1.0]}]}


@pytest.fixture(scope="module")
def body(tmp_path_factory):
    return written(tmp_path_factory.mktemp("mesh") / "sphere.obj", *sphere(10))


def drawn(body, **tables):
    return render(load_scene(around(body, SIDE, preset="robust", **tables)), interpreter="arrays")


@pytest.fixture(scope="module")
def oracle(body):
    return drawn(body)


def off_by_bits(oracle, seed=5):
    """The oracle's buffers; a tenth of the numbers are the next ones, which is right or not."""
    rng, off = np.random.default_rng(seed), {}
    for name, buffer in oracle.buffers.items():
        moved = np.nextafter(buffer, np.float32(9)) if buffer.dtype == np.float32 else buffer
        off[name] = np.where(rng.random(buffer.shape) < 0.1, moved, buffer)
    return off


def with_halves(oracle):
    """Some buffers as halves, rounded to the nearest; one channel of some pixels is wrong."""
    halves = {name: HELD["float16"](oracle[name]).astype(np.float32) for name in HALVES}
    halves["lit"][:, ::7, 1] *= np.float32(1.125)
    return {**oracle.buffers, **halves}


def cases(oracle):
    off = off_by_bits(oracle)
    fused, free = (replace(PROFILES["vulkan"], contraction=kind) for kind in ("fused", "free"))
    return {
        "own": Case(oracle, Drawing(oracle.buffers), PROFILES["vulkan"]),
        "off": Case(oracle, Drawing(off), PROFILES["vulkan"]),
        "few": Case(oracle, Drawing({name: off[name] for name in FEW}), PROFILES["gl"]),
        "fused": Case(oracle, Drawing(off), fused),
        "free": Case(oracle, Drawing(off), free),
        "halves": Case(oracle, Drawing(with_halves(oracle), dict.fromkeys(HALVES, "float16")), PROFILES["vulkan"]),
        "exact": Case(oracle, Drawing(off), PROFILES["ieee"]),
    }


@pytest.mark.parametrize("name", ["own", "off", "few", "fused", "free", "halves", "exact"])
def test_what_is_worked_out_is_the_same_and_what_is_spared_is_right(oracle, name):
    case, spared = cases(oracle)[name], 0
    for whole, some in zip(checks(case), checks(case, sparing=Sparing(SAMPLE)), strict=True):
        assert whole.expected.tobytes() == some.expected.tobytes(), whole.buffer
        assert (whole.where == some.where).all()
        told = np.ones(whole.where.shape, bool) if some.bounded is None else some.bounded != 0
        assert (some.bounded is None) == (some.stage == RASTERIZER)
        for own, other in ((whole.reach, some.reach), (whole.undecided, some.undecided)):
            assert own is other is None or (own[told] == other[told]).all(), whole.buffer
        outcomes, found = outcome_map(whole), outcome_map(some)
        assert (outcomes[told] == found[told]).all(), whole.buffer
        assert set(np.unique(found[~told])) <= {CERTAIN, NOT_COMPARED}
        assert FAIL not in outcomes[~told], whole.buffer
        spared += int((~told & whole.where).sum())
    assert spared > 1000


def test_numbers_that_are_none_do_no_harm(oracle, monkeypatch):
    """What the kernels make of a dump of NaN, infinity and the largest numbers is what arrays do."""
    rng, odd = np.random.default_rng(6), {}
    for name, buffer in oracle.buffers.items():
        numbers = [np.nan, np.inf, -np.inf, 3e38, -3e38] if buffer.dtype == np.float32 else [0, 1]
        odd[name] = np.where(rng.random(buffer.shape) < 0.2, rng.choice(numbers, buffer.shape), buffer)
        odd[name] = odd[name].astype(buffer.dtype)
    case, found = Case(oracle, Drawing(odd), PROFILES["ieee"]), []
    for interpreter in ("kernel", "arrays"):
        monkeypatch.setattr(sparing, "machine_of", lambda _, chosen=interpreter: machine_of(chosen))
        with np.errstate(all="ignore"):
            found.append({check.buffer: check.expected for check in checks(case, sparing=Sparing(SAMPLE))})
    assert_same_bits(*found)
    assert not np.isfinite(found[0]["image"]).all()


def test_two_lights_run_a_stage_twice_and_each_run_is_spared_by_itself(body):
    oracle = drawn(body, **TWO_LIGHTS)
    case = Case(oracle, Drawing(off_by_bits(oracle)), PROFILES["vulkan"])
    of_all = {check.buffer: outcome_map(check) for check in checks(case)}
    of_some = {check.buffer: (outcome_map(check), check.bounded) for check in checks(case, sparing=Sparing(SAMPLE))}
    assert list(of_all) == list(of_some) and "thickness_2" in of_all
    for name, (found, bounded) in of_some.items():
        told = slice(None) if bounded is None else bounded != 0
        assert (found[told] == of_all[name][told]).all(), name


def test_only_pixels_that_are_judged_are_sampled(oracle):
    chosen = np.zeros((SIDE, SIDE), bool)
    chosen[:, : SIDE // 2] = True
    case = Case(oracle, Drawing(off_by_bits(oracle)), PROFILES["vulkan"])
    found = {check.buffer: check for check in checks(case, sparing=Sparing(SAMPLE, chosen))}
    bounded = found["phong"].bounded
    assert bounded[chosen].any() and not bounded[~chosen].any()
    assert np.count_nonzero(bounded & SAMPLED) == SAMPLE


def test_small_passes_are_worked_out_whole(oracle):
    case = Case(oracle, Drawing(oracle.buffers), PROFILES["vulkan"])
    count = int((oracle["coverage"] != 0).sum())
    (phong,) = (check for check in checks(case, sparing=Sparing(count // 2 + 1)) if check.buffer == "phong")
    assert phong.bounded is None
    (phong,) = (check for check in checks(case, sparing=Sparing(count // 2)) if check.buffer == "phong")
    assert phong.bounded is not None


def test_the_reasons_add_up(oracle):
    buffers = {**oracle.buffers, "lit": oracle["lit"] * np.float32(1.0001)}
    case = Case(oracle, Drawing(buffers), PROFILES["vulkan"])
    found = {check.buffer: check for check in checks(case, sparing=Sparing(SAMPLE))}
    assert set(np.unique(found["phong"].bounded)) == {0, SAMPLED}
    lit = found["lit"].bounded
    bright = (oracle["lit"] != buffers["lit"]).any(axis=-1) & found["lit"].where
    assert (lit & NEEDED != 0)[bright].all() and not (lit & NEEDED)[~bright].any()


@pytest.mark.parametrize(("count", "width"), [(64, 64), (61, 64), (100, 37), (250, 256)])
def test_one_pixel_of_each_run_is_taken_in_all_columns(count, width):
    where = np.ones((width, width), bool)
    rows, columns = np.nonzero(sampled(where, count))
    assert len(rows) == count
    runs = np.searchsorted(np.arange(1, count) * width * width // count, np.sort(rows * width + columns), side="right")
    assert runs.tolist() == list(range(count))
    assert len(np.unique(columns)) > min(count, width) / 2


def test_stages_stand_alone_where_all_between_them_was_dumped(oracle):
    case = Case(oracle, Drawing(oracle.buffers), PROFILES["vulkan"])
    this_pass = oracle.scene.method["camera"]
    assert groups(case.drawn(this_pass)) == [(stage,) for stage in this_pass.stages]
    whole = replace(case, profile=replace(PROFILES["vulkan"], contraction="free"))
    assert max(map(len, groups(whole.drawn(this_pass)))) > 5


def test_stages_are_taken_together_where_something_between_them_was_not_dumped(oracle):
    dumped = {name: buffer for name, buffer in oracle.buffers.items() if name != "thickness"}
    found = groups(Case(oracle, Drawing(dumped), PROFILES["vulkan"]).drawn(oracle.scene.method["camera"]))
    (together,) = (group for group in found if len(group) > 1)
    assert "thickness" in together[0].writes.values()
    assert all("thickness" in stage.reads.values() for stage in together[1:])


def test_a_report_counts_what_it_compares_and_estimates_the_rest(oracle, monkeypatch):
    buffers = off_by_bits(oracle)
    whole = validate(oracle, buffers, explain=False)
    monkeypatch.setattr(stage_by_stage, "SAMPLE", SAMPLE)
    some = validate(oracle, buffers, explain=False)
    for one, other in zip(whole.verdicts, some.verdicts, strict=True):
        assert [getattr(one, name) for name in SAME] == [getattr(other, name) for name in SAME]
        assert sum(other.outcomes) == other.compared
        assert abs(one.ambiguous - other.ambiguous) <= 0.1 * one.compared
        assert other.bounded < other.compared or other.stage == RASTERIZER
        assert not any(one.estimated)
    texels = next(one for one in some.verdicts if one.buffer == "stored_distance")
    assert texels.ambiguous and texels.estimated == (True, True, False, False, True)


def test_estimates_follow_the_sample():
    outcome = np.array([AMBIGUOUS, CERTAIN, CERTAIN, CERTAIN, AMBIGUOUS, *[CERTAIN] * 20], np.uint8)
    bounded = np.array([SAMPLED, SAMPLED, SAMPLED, SAMPLED, NEEDED, *[0] * 20], np.uint8)
    blank = np.zeros((25, 1))
    pixels = Compared(blank, blank, blank, np.zeros(25, bool), outcome, bounded)
    assert pixels.count(AMBIGUOUS) == 2 + 20 // 4
    assert np.flatnonzero(pixels.sample).tolist() == [0, 1, 2, 3]


def test_each_run_of_pixels_has_one_in_the_sample():
    where = np.random.default_rng(2).random((9, 11)) < 0.6
    chosen = np.flatnonzero(where)
    for count in (1, 2, 7, len(chosen)):
        found = np.flatnonzero(sampled(where, count))
        runs = (
            np.array_split(chosen, count)
            if len(chosen) % count == 0
            else [chosen[k * len(chosen) // count : (k + 1) * len(chosen) // count] for k in range(count)]
        )
        assert len(found) == count and all(np.isin(run, found).sum() == 1 for run in runs)
    assert sampled(where, len(chosen))[where].all()
