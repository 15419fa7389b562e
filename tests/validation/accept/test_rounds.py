"""A pass in rounds copies texels: its buffers may be off by what storage takes from them, and by nothing else."""

from itertools import combinations

import numpy as np
import pytest

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import checks, last_round
from sss_ref.validation.profile_file import profile_of
from sss_ref.validation.stage_by_stage import validate
from sss_ref.validation.verdict.clusters import Whereabouts
from sss_ref.validation.verdict.verdict import judged

F = np.float32
SMALL = {f"{t}.{s}": 48 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
PROFILES = ("ieee", "vulkan")
IRRADIANCE = ("irradiance", "irradiance_mask", "irradiance_filled", "scattered_irradiance")
OFF = F(1 + 8e-6)  # 67 to 134 ulp
NARROW = {"blur.unit": "pixel", "shadow_map.test": "slope"}  # in mm a second pass dilates; soft shadows bound little
TWO_LIGHTS = [{"position": [3.0, 1.0, 2.0]}, {"position": [-3.0, 0.5, 1.0]}]


def rendered(**overrides):
    return render(load_scene("figure5", preset="robust", **SMALL, **NARROW, **overrides), "arrays")


@pytest.fixture(scope="module")
def oracle():
    return rendered()


def dump_of(oracle, names, **changed):
    return {name: oracle[name] for name in names} | changed


def verdicts(oracle, buffers, profile, stored=None, rounded=None):
    case = Case(oracle, Drawing(buffers, stored or {}, rounded or {}), profile_of(profile))
    return {each.buffer: judged(each, Whereabouts(oracle, buffers)) for each in checks(case)}


def neighbours(buffer, storage):
    """Each number as a texture may keep it, the one or the other way at random."""
    up = np.random.default_rng(5).random(buffer.shape) < 0.5
    if storage == "unorm8":
        return (np.clip(np.where(up, np.ceil(buffer * 255), np.floor(buffer * 255)), 0, 255) / 255).astype(F)
    near = buffer.astype(np.float16)
    other = np.nextafter(near, np.where(near < buffer, F(np.inf), F(-np.inf)).astype(np.float16))
    return np.where(up | (near == buffer), near, other).astype(F)


SUBSETS = [
    tuple(name for name in IRRADIANCE if name == "irradiance_filled" or name in others)
    for count in range(4)
    for others in combinations([each for each in IRRADIANCE if each != "irradiance_filled"], count)
]


@pytest.mark.parametrize("names", SUBSETS, ids="-".join)
@pytest.mark.parametrize("profile", PROFILES)
def test_copied_texels_that_are_a_little_off_fail(oracle, names, profile):
    """What they copy is known exactly if it was dumped, or on an exact processor; else it may be off by roundings."""
    known = "irradiance" in names or profile == "ieee"
    wrong = oracle["irradiance_filled"] * (OFF if known else F(1.01))
    found = verdicts(oracle, dump_of(oracle, names, irradiance_filled=wrong), profile)["irradiance_filled"]
    differs = (wrong != oracle["irradiance_filled"]).any(axis=-1)
    assert differs.sum() > 500 and found.stage == "dilate"
    assert found.failing == differs.sum() if known else found.failing > 0.9 * differs.sum()
    assert verdicts(oracle, dump_of(oracle, names), profile)["irradiance_filled"].certain == differs.size


def test_what_is_copied_may_be_off_as_its_stages_allow(oracle):
    """Of the irradiance nothing was given but its copy: a right processor may have it some units off."""
    little_off = {"irradiance_filled": oracle["irradiance_filled"] * OFF}
    assert verdicts(oracle, little_off, "vulkan")["irradiance_filled"].passed


def test_the_report_tells_the_last_round(oracle):
    dumped = dump_of(oracle, IRRADIANCE[:3], irradiance_filled=oracle["irradiance_filled"] * OFF)
    found = validate(oracle, dumped)
    assert [each.buffer for each in found.verdicts if not each.passed] == ["irradiance_filled"]
    assert found.summary.startswith("fail: stage dilate of pass irradiance_fill is the first that is wrong")
    drawn = last_round(Case(oracle, Drawing(dumped), profile_of("vulkan")), oracle.scene.method["irradiance_fill"])
    masks = [drawn.read["irradiance_mask"].exact, oracle["irradiance_mask"], oracle["irradiance_filled_mask"]]
    last, first, filled = (int((each != 0).sum()) for each in masks)
    assert first < last < filled


@pytest.mark.parametrize("profile", PROFILES)
def test_one_wrong_texel_of_the_mask_fails(oracle, profile):
    mask = oracle["irradiance_filled_mask"].copy()
    mask[tuple(np.argwhere(mask == 0)[0])] = 1
    found = verdicts(oracle, {"irradiance_filled_mask": mask}, profile)["irradiance_filled_mask"]
    assert found.failing == 1 and found.certain == mask.size - 1


@pytest.mark.parametrize("profile", PROFILES)
def test_what_was_dumped_is_copied_and_not_what_the_oracle_has(oracle, profile):
    """An irradiance that is wrong everywhere makes a fill that is right, and is off from the oracle's."""
    twice = {"irradiance": oracle["irradiance"] * F(2), "irradiance_filled": oracle["irradiance_filled"] * F(2)}
    found = verdicts(oracle, twice, profile)
    assert not found["irradiance"].passed and found["irradiance_filled"].passed
    once = twice | {"irradiance_filled": oracle["irradiance_filled"]}
    assert not verdicts(oracle, once, profile)["irradiance_filled"].passed


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("storage", ["float16", "unorm8"])
def test_textures_in_few_bits(oracle, profile, storage):
    """Copies of texels in few bits are exact; where only the target has few bits, or only the file, a step is right."""
    kept = neighbours(oracle["irradiance"], storage)
    scene = oracle.scene
    filled = copied(kept, oracle["irradiance_mask"], scene.settings.irradiance_map.dilate)
    both = dict.fromkeys(("irradiance", "irradiance_filled"), storage)
    dumped = dump_of(oracle, IRRADIANCE[:2], irradiance=kept, irradiance_filled=filled)
    assert verdicts(oracle, dumped, profile, both)["irradiance_filled"].passed
    alone = dump_of(oracle, IRRADIANCE[:2], irradiance_filled=neighbours(oracle["irradiance_filled"], storage))
    assert verdicts(oracle, alone, profile, {"irradiance_filled": storage})["irradiance_filled"].passed
    assert not verdicts(oracle, alone, profile)["irradiance_filled"].passed
    files = dump_of(
        oracle, IRRADIANCE[:2], irradiance=kept, irradiance_filled=neighbours(oracle["irradiance_filled"], storage)
    )
    assert verdicts(oracle, files, profile, both, dict.fromkeys(both, "float32"))["irradiance_filled"].passed
    step = {"float16": 2.0**-10, "unorm8": 1 / 255}[storage]
    beyond = dumped | {"irradiance_filled": filled + F(3 * step) * np.maximum(filled, F(storage == "unorm8"))}
    assert not verdicts(oracle, beyond, profile, both)["irradiance_filled"].passed


def copied(buffer, mask, rounds):
    """Rule R8 in plain loops: an uncovered texel takes the value of its first covered neighbour of the round before."""
    order = [(0, -1), (0, 1), (-1, 0), (1, 0), (-1, -1), (-1, 1), (1, -1), (1, 1)]  # rows, columns
    buffer, mask = buffer.copy(), mask != 0
    for _ in range(rounds):
        before, covered = buffer.copy(), mask.copy()
        for row, column in np.argwhere(~covered):
            for down, right in order:
                at = row + down, column + right
                if 0 <= at[0] < mask.shape[0] and 0 <= at[1] < mask.shape[1] and covered[at]:
                    buffer[row, column], mask[row, column] = before[at], True
                    break
    return buffer


@pytest.mark.parametrize("profile", PROFILES)
def test_every_light_has_its_own(profile):
    oracle = rendered(lights=TWO_LIGHTS)
    fills = [name for name in oracle.buffers if name.startswith("irradiance_filled") and "mask" not in name]
    assert len(fills) == 2
    for name in fills:
        found = verdicts(oracle, dict(oracle.buffers) | {name: oracle[name] * OFF}, profile)
        assert [buffer for buffer in fills if not found[buffer].passed] == [name]
    assert all(each.passed for each in verdicts(oracle, oracle.buffers, profile).values())


def test_without_rounds_the_fill_is_what_it_reads():
    oracle = rendered(**{"irradiance_map.dilate": 0})
    right = {"irradiance": oracle["irradiance"], "irradiance_filled": oracle["irradiance"]}
    assert verdicts(oracle, right, "vulkan")["irradiance_filled"].certain == 48 * 48
    wrong = right | {"irradiance_filled": oracle["irradiance"] * OFF}
    assert verdicts(oracle, wrong, "vulkan")["irradiance_filled"].failing > 300


def test_a_wrong_number_of_rounds_is_seen(oracle):
    other = rendered(**{"irradiance_map.dilate": oracle.scene.settings.irradiance_map.dilate - 1})
    found = {each.buffer: each for each in checks(Case(oracle, Drawing(other.buffers), profile_of("vulkan")))}
    assert (found["irradiance_filled_mask"].expected != other["irradiance_filled_mask"]).any()
    assert found["irradiance_filled"].reach.max() == 0
