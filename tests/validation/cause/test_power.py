"""What a run says it would see, it sees; and what it says it would not, it does not."""

import numpy as np
import pytest
from scenes import around, two_slabs, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.power import power
from sss_ref.validation.stage_by_stage import validate


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return written(tmp_path_factory.mktemp("slabs") / "slabs.obj", *two_slabs())


@pytest.fixture(scope="module")
def oracle(path):
    return drawn(path)


@pytest.fixture(scope="module")
def report(oracle):
    return validate(oracle, oracle.buffers)


def drawn(path, **overrides):
    scene = around(path, 64, preset="robust")
    scene["camera"]["azimuth"] = 100  # half of what it sees faces the light
    return render(load_scene(scene, **{"shadow_map.test": "slope"}, **overrides), "arrays")


def sensitivity(report, stage, name):
    (one,) = (each for each in report.power if each.stage == stage)
    (found,) = (each for each in one.numbers if each.name == name)
    return found


NUMBERS = [
    ("translucency_ratio_throughout", "exponent", "translucency.exponent"),
    ("phong_shading", "shininess", "phong.shininess"),
    ("phong_shading", "ambient", "phong.ambient"),
    ("lit_transmit_wrapped", "translucency_scale", "translucency.scale"),
    ("scatter_inside", "pixel_scale", "blur.pixel_scale"),
    ("light_constant", "light_intensity", "lights.0.intensity"),
]


@pytest.mark.parametrize(("stage", "name", "key"), NUMBERS)
def test_an_error_above_is_seen_and_one_far_below_is_not(path, oracle, report, stage, name, key):
    found = sensitivity(report, stage, name)
    assert found.relative and 1e-9 < found.change < 0.1
    for factor, passed in ((2.0, False), (0.1, True)):
        right = oracle.scene.settings.model_dump()
        for part in key.split("."):
            right = right[int(part) if part.isdecimal() else part]
        changed = float(np.float32(right * (1 + factor * found.change)))
        if np.float32(changed) != np.float32(right):
            wrong = drawn(path, **{key: changed})
            judged = validate(oracle, {each: wrong[each] for each in oracle.buffers}, explain=False)
            assert judged.passed is passed and (passed or judged.culprit.stage == stage), (factor, found.change)


def test_every_judged_stage_is_tried_and_no_other(oracle):
    stages = {stage.name for one in oracle.scene.method.passes for stage in one.stages if not one.on_demand}
    assert {each.stage for each in validate(oracle, oracle.buffers).power} == stages
    some = validate(oracle, {name: oracle[name] for name in ("phong", "triangle")}).power
    assert [each.stage for each in some] == ["phong_shading"]
    assert validate(oracle, oracle.buffers, explain=False).power == ()


def test_it_is_told_of_a_failing_run_too(oracle, report):
    wrong = dict(oracle.buffers) | {"lit": oracle["lit"] + np.float32(1)}
    assert validate(oracle, wrong).power == report.power  # of the oracle alone, and the same every time


def test_a_wider_profile_sees_less(oracle, report):
    wide = {each.stage: each for each in power(case_of(oracle, "mediump"), judged_pixels(oracle))}
    for one in (each for each in report.power if each.stage in ("phong_shading", "translucency_ratio_throughout")):
        for narrow, other in zip(one.numbers, wide[one.stage].numbers, strict=True):
            assert other.change is None or narrow.change is None or other.change >= narrow.change
    exponent = next(each for each in wide["translucency_ratio_throughout"].numbers if each.name == "exponent")
    assert exponent.change > 100 * sensitivity(report, "translucency_ratio_throughout", "exponent").change


def case_of(oracle, profile, stored=()):
    return Case(oracle, Drawing({}, dict(stored)), PROFILES[profile])


def judged_pixels(oracle):
    covered = oracle["coverage"] != 0
    return {name: covered for name, buffer in oracle.buffers.items() if buffer.shape[:2] == covered.shape}


def test_a_coarse_texture_sees_less(oracle):
    fine, coarse = (
        next(power(case_of(oracle, "vulkan", stored), {"translucency": oracle["coverage"] != 0})).numbers[0]
        for stored in ({}, {"translucency": "float16"})
    )
    assert coarse.change > 20 * fine.change


def test_mistakes_are_told(report):
    tried, seen = sum(each.mistakes for each in report.power), sum(each.seen for each in report.power)
    assert tried >= 50 and seen >= 0.9 * tried
    assert all(len(each.unseen) == each.mistakes - each.seen for each in report.power)
    assert any(
        line.startswith(f"of {tried} mistakes in these stages {seen} would be seen") for line in report.sensitivity
    )
    assert any(line.startswith("translucency_ratio_throughout: x ") for line in report.sensitivity)


def test_what_cannot_be_seen_is_told(tmp_path):
    """Beside a texel's footprint as large as the body, no error in the bias shows."""
    path = written(tmp_path / "slabs.obj", *two_slabs())
    oracle = drawn(path, **{"shadow_map.bias_abs": 50.0})
    found = sensitivity(validate(oracle, {"directly_lit": oracle["directly_lit"]}), "directly_lit_slope", "bias_slope")
    assert found.change is None and str(found) == "bias_slope not even doubled"


def test_of_a_number_that_is_0_the_error_itself_is_told(path):
    """It is the T of all that is lit, where light from behind does not go round."""
    oracle = drawn(path, **{"translucency.combine": "transmit"})
    report = validate(oracle, {"translucency": oracle["translucency"]})
    found = sensitivity(report, "translucency_ratio", "translucency_neutral")
    assert not found.relative and 0 < found.change < 1e-3 and str(found).startswith("translucency_neutral 0 to ")


REPEAT = "the texture repeats beyond its edge (REPEAT for CLAMP)"


@pytest.mark.parametrize(("distance", "shown"), [(12.0, False), (2.0, True)])
def test_whether_a_picture_can_show_repeat_for_clamp(path, distance, shown):
    """A body in the middle of the picture is blurred with nothing beyond the edge; one that reaches over it is not."""
    oracle = drawn(path, **{"camera.distance": distance})
    report = validate(oracle, {"lit": oracle["lit"], "scattered": oracle["scattered"]})
    (blur,) = (each for each in report.power if each.stage == "scatter_inside")
    assert (REPEAT in blur.hidden) is not shown and REPEAT not in blur.unseen
    told = f"no difference here, another view or scene would show it: scatter_inside: {REPEAT}"
    assert (told in report.sensitivity) is not shown
