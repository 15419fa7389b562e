"""What a run says it would see, it sees; and what it says it would not, it does not."""

import numpy as np
import pytest
from scenes import around, two_slabs, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.types import Array, Texture, mat3, mat4, vec2, vec3
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.power import (
    Power,
    Sensitivity,
    Trial,
    _changed,
    _is_number,
    _least,
    _outermost,
    _size,
    _some,
    power,
)
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


@pytest.mark.parametrize(
    ("change", "relative", "told"),
    [
        (None, True, "wrap not even doubled"),
        (None, False, "wrap not even 1"),
        (0.0123, True, "wrap 0.01"),
        (0.0123, False, "wrap 0 to 0.01"),
    ],
)
def test_a_change_that_is_seen_in_words(change, relative, told):
    assert str(Sensitivity("wrap", change, relative)) == told


@pytest.mark.parametrize("least", [1.0, 0.3, 1e-3, 1e-6, 2e-9])
def test_the_least_change_is_found_by_halving_decades(least):
    """To a 128th of the nine decades below 1, and never below what is seen."""
    found = _least(lambda change: change >= least)
    assert least <= found <= least * 10 ** (9 / 128) * (1 + 1e-12)


def test_what_is_never_or_always_seen():
    assert _least(lambda change: change > 1.0) is None
    assert np.isclose(_least(lambda change: True), 10 ** (-9 + 9 / 128), rtol=1e-12, atol=0)


def test_a_number_is_changed_by_a_share_or_by_itself():
    assert _changed(np.float32(3), 0.25, True) == np.float32(3.75) and _changed(np.float32(3), 0.25, False) == 3.25
    colour = _changed(vec3(*np.float32([1, 2, 4])), 0.5, True)
    assert isinstance(colour, vec3) and [*colour] == [1.5, 3, 6]
    assert _changed(Array(np.float32([1, 2])), 0.5, False).data.tolist() == [1.5, 2.5]
    assert _changed(np.float32(3), 2.0**-25, True).dtype == np.float32


def test_the_size_of_a_value_is_that_of_its_largest_number():
    assert _size(np.float32(-3)) == 3 and _size(vec3(*np.float32([1, -4, 2]))) == 4
    assert _size(Array(np.float32([[0, -2], [1, 0]]))) == 2


@pytest.mark.parametrize(
    ("value", "is_one"),
    [
        (np.float32(1), True),
        (vec3(*np.float32([1, 2, 3])), True),
        (Array(np.float32([1])), True),
        (Array(np.int32([1])), False),
        (np.int32(1), False),
        (Texture(np.zeros((1, 1), np.float32)), False),
        (mat3(np.eye(3)), False),
        (mat4(np.eye(4)), False),
        (np.zeros(3, np.float32), False),
    ],
)
def test_which_inputs_are_numbers_that_somebody_sets(value, is_one):
    assert _is_number(value) is is_one


def trial(expected, reach):
    return Trial(None, {"lit": np.float64(expected)}, {"lit": np.float64(reach)})


def test_what_is_out_of_reach_is_seen_and_what_differs_changes():
    one = trial([[1.0, 2.0], [3.0, 4.0]], 0.5)

    def lit(*columns):
        return {"lit": vec2(*(np.float32(column) for column in columns))}

    assert (
        not one.sees(lit([1.5, 3], [2, 3.5]))
        and one.sees(lit([1.75, 3], [2, 4]))
        and one.sees(lit([np.nan, 3], [2, 4]))
    )
    assert not one.sees({"other": vec2(np.float32(9), np.float32(9))})
    assert not one.changes(lit([1, 3], [2, 4])) and one.changes(lit([1, 3], [2, 4.25])) and not one.changes({})
    assert not trial([[np.nan]], 1.0).changes({"lit": np.float32([np.nan])})
    assert not trial([[1.0], [1.0]], 1.0).changes({"lit": np.float32(1)})


def test_the_outermost_pixels_are_those_of_the_first_and_last_row_and_column():
    pixels = np.argwhere(np.ones((4, 3)))[1:]  # without a corner
    outer = {tuple(each) for each in _outermost(pixels).tolist()}
    assert outer == {tuple(each) for each in pixels.tolist()} - {(1, 1), (2, 1)}


@pytest.mark.parametrize(("count", "kept"), [(3, 3), (12, 12), (13, 12), (100, 12)])
def test_of_many_mutants_twelve_are_tried_in_their_order(count, kept):
    found = _some(list(range(count)))
    assert len(found) == len(set(found)) == kept and found == sorted(found) == _some(list(range(count)))
    assert count < 100 or found != list(range(kept))


def test_a_stage_is_told_with_its_numbers():
    numbers = Sensitivity("x", 0.5, True), Sensitivity("y", None, True)
    assert str(Power("ratio", numbers, 3, 2, ("a",))) == "ratio: x 0.5, y not even doubled"
