"""Stages on intervals: what a correct processor gives lies inside, what a wrong one gives does not."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest
from fragments import VARIANTS, random_inputs
from one_stage import Inputs, stages_by_module
from one_stage import run as run_stage
from random_processor import Processor
from retyped_stages import RETYPED

import sss_ref
from sss_ref.errors import StageError
from sss_ref.interpret import arrays
from sss_ref.interpret.intervals import evaluate as interval
from sss_ref.interpret.intervals.enclosing import CONDITION, WHICH_TEXEL
from sss_ref.interpret.intervals.evaluate import run_intervals
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.interpret.intervals.value_sets import Texels
from sss_ref.interpret.work import buffer_value, uniform_value
from sss_ref.language import (
    Array,
    Texture,
    float32,
    fract,
    fractional_part,
    nearest_texel,
    select,
    size,
    sqrt,
    stage,
    texel,
    vec2,
    vec3,
    whole_part,
)
from sss_ref.language.pipeline import CLIP_POSITION, PIXEL
from sss_ref.language.sampling import sample_bilinear_clamped, sample_bilinear_repeat
from sss_ref.language.types import components, ivec2
from sss_ref.numerics.interval import Interval
from sss_ref.passes.blur import scatter
from sss_ref.passes.camera import albedo_textured
from sss_ref.passes.transmittance import translucency_ratio_throughout
from sss_ref.rendering.draw import Machine, draw
from sss_ref.rendering.fold import shaded

F = np.float32
VULKAN, IEEE = PROFILES["vulkan"], PROFILES["ieee"]
STAGES = [s for stages in stages_by_module().values() for s in stages if CLIP_POSITION not in s.outputs]
CASES = [(s, variant) for s in STAGES for variant in [{}, *VARIANTS.get(s.name, [])]]
CASES += [(s, {}) for s in RETYPED.values()]
IDS = [f"{s.name}-{number}" for number, (s, _) in enumerate(CASES)]


def prepared(stage_, variant, width=24, height=17):
    """Random pictures, and what a stage reads of them as arrays over all fragments."""
    drawn = random_inputs(np.random.default_rng(5), width, height)
    inputs = Inputs(width, height, drawn.buffers, {**drawn.uniforms, **variant})
    rows, columns = np.indices((height, width)).reshape(2, -1)
    values = {}
    for own, kind in stage_.parameters.items():
        name = stage_.reads[own]
        if name == PIXEL:
            values[own] = ivec2(columns.astype(np.int32), rows.astype(np.int32))
        elif name in inputs.buffers:
            values[own] = buffer_value(kind, inputs.buffers[name], rows, columns)
        else:
            values[own] = uniform_value(kind, inputs.uniforms[name])
    return inputs, values


def outside(outcome, values):
    """Where any component of the values is not in its interval; NaN, which undefined operations give, counts as in."""
    pairs = list(zip(components(outcome.value), values, strict=True))
    return np.logical_or.reduce([~((part.low <= v) & (v <= part.high)) & (v == v) for part, v in pairs])


def channels(buffer):
    return list(buffer.reshape(buffer.shape[0] * buffer.shape[1], -1).T)


@pytest.mark.parametrize("profile", ["vulkan", "gl", "mediump"])
@pytest.mark.parametrize(("stage_", "variant"), CASES, ids=IDS)
def test_the_oracles_values_lie_inside(stage_, variant, profile):
    inputs, values = prepared(stage_, variant)
    got = run_intervals(stage_, values, PROFILES[profile])
    for name, buffer in run_stage(arrays, stage_, inputs).items():
        assert not outside(got[name], channels(buffer)).any()


@pytest.mark.parametrize(("stage_", "variant"), CASES, ids=IDS)
def test_ieee_gives_the_oracles_bits(stage_, variant):
    inputs, values = prepared(stage_, variant)
    got = run_intervals(stage_, values, IEEE)
    for name, buffer in run_stage(arrays, stage_, inputs).items():
        for part, expected in zip(components(got[name].value), channels(buffer), strict=True):
            for end in np.broadcast_arrays(expected, part.low, part.high)[1:]:
                known = expected == expected  # NaN, which undefined operations give, is any value on intervals
                assert end.astype(expected.dtype)[known].tobytes() == expected[known].tobytes()
        assert not got[name].doubt.any()


@pytest.mark.parametrize("seed", [None, 1, 2, 3], ids=["float64", "1", "2", "3"])
@pytest.mark.parametrize(("stage_", "variant"), CASES, ids=IDS)
def test_whatever_a_correct_processor_chooses_lies_inside(stage_, variant, seed):
    """Among its choices: fused or not, any order of sums, v * inversesqrt, exp2(y * log2 x), where texels end."""
    _, values = prepared(stage_, variant)
    got = run_intervals(stage_, values, VULKAN)
    processor = Processor(np.random.default_rng(seed), exact=seed is None)
    for name, value in processor.run(stage_, values).items():
        assert not outside(got[name], components(value)).any()


def test_chunks_and_threads_do_not_show(monkeypatch):
    _, values = prepared(scatter, {})
    whole = run_intervals(scatter, values, VULKAN)["scattered"]
    monkeypatch.setattr(interval, "CHUNK", 50)
    with ThreadPoolExecutor(2) as pool:
        parts = run_intervals(scatter, values, VULKAN, pool)["scattered"]
    for a, b in zip(whole.value, parts.value, strict=True):
        assert a.low.tobytes() == b.low.tobytes() and a.high.tobytes() == b.high.tobytes()


# One decision at a time


class Value(NamedTuple):
    value: float


@stage(source="test")
def nearest_value(picture: Texture[float], uv: vec2) -> Value:
    """A nearest sample."""
    return Value(texel(picture, nearest_texel(size(picture), uv)))


@stage(source="test")
def bilinear_value(picture: Texture[float], uv: vec2) -> Value:
    """A bilinear sample."""
    return Value(sample_bilinear_clamped(picture, uv))


@stage(source="test")
def repeated_value(picture: Texture[float], uv: vec2) -> Value:
    """A bilinear sample of a picture that repeats."""
    return Value(sample_bilinear_repeat(picture, uv))


@stage(source="test")
def step(x: float, table: Array[float], entry: int) -> Value:
    """A condition, and an entry of a table."""
    return Value(select(x > 0.5, table[entry], 7.0))


class Truth(NamedTuple):
    both: bool


@stage(source="test")
def both_above(x: float, y: float) -> Truth:
    """Two conditions."""
    return Truth((x > 0.5) & (y > 0.5))


@stage(source="test")
def passed_on(flag: bool) -> Truth:
    """A truth value as it comes."""
    return Truth(flag)


@stage(source="test")
def chosen_by(flag: bool) -> Value:
    """A choice by a truth value as it comes."""
    return Value(select(flag, 1.0, 2.0))


class Three(NamedTuple):
    three: vec3


@stage(source="test")
def beside_a_vector(x: float, v: vec3) -> Three:
    """A choice between one number for all channels, and three."""
    return Three(select(x > 0.5, 1.0, v))


@stage(source="test")
def scaled(x: float, factor: float) -> Value:
    """A product."""
    return Value(x * factor)


@stage(source="test")
def scaled_entry(table: Array[float], factor: float) -> Value:
    """A product with an entry of a table."""
    return Value(table[0] * factor)


@stage(source="test")
def fraction_of(x: float) -> Value:
    """The fraction of a scalar."""
    return Value(fract(x))


@stage(source="test")
def two_positions(a: vec2, b: vec2) -> Value:
    """Two positions split in one body."""
    return Value(fractional_part(a).x + fractional_part(b).y)


@stage(source="test")
def cell_of(position: vec2) -> Value:
    """The column of the cell that holds a position."""
    return Value(float32(whole_part(position).x))


@stage(source="test")
def root_of_inverse(x: float) -> Value:
    """Undefined for x <= 0."""
    return Value(sqrt(1.0 / x))


def row(*numbers):
    return np.array(numbers, F)


def between(low, high):
    return Interval(row(*low), row(*high))


def ends(outcome):
    return list(zip(outcome.value.low.tolist(), outcome.value.high.tolist(), strict=True))


PICTURE = np.arange(12, dtype=F).reshape(3, 4)


def test_a_nearest_sample_near_an_edge_takes_both_texels():
    at = row(0.375, 0.5, 0.5 + 2.0**-11, 0.5 - 2.0**-9, 0.9)  # of four texels: 1.5, 2, 2 + 2^-9, 2 - 2^-7, 3.6
    got = run_intervals(nearest_value, {"picture": Texture(PICTURE), "uv": vec2(at, F(0.5))}, VULKAN)["value"]
    assert ends(got) == [(5, 5), (5, 6), (5, 6), (5, 5), (7, 7)]
    assert got.doubt.tolist() == [0, WHICH_TEXEL, WHICH_TEXEL, 0, 0]


def test_a_nearest_sample_of_more_than_three_texels_may_be_anything():
    wide = vec2(between([0.3, 0.1], [0.7, 0.9]), F(0.5))
    got = run_intervals(nearest_value, {"picture": Texture(PICTURE), "uv": wide}, VULKAN)["value"]
    assert ends(got) == [(5, 6), (-np.inf, np.inf)]
    assert got.unbounded.tolist() == [False, True]


def test_texels_known_to_lie_between_two_values():
    picture = Texels(PICTURE, PICTURE + F(0.5))
    uv = vec2(row(0.375, 0.5), F(0.5))
    got = run_intervals(nearest_value, {"picture": picture, "uv": uv}, VULKAN)["value"]
    assert ends(got) == [(5, 5.5), (5, 6.5)]


@pytest.mark.parametrize(("bits", "slack"), [(8, 2 / 255), (6, 2 / 63), (0, 0.0)])
def test_a_filter_of_few_bits_loses_a_step_along_each_axis(bits, slack):
    picture = np.repeat(PICTURE[..., np.newaxis] / F(16), 3, axis=2)
    profile, uv = replace(VULKAN, filter_bits=bits), vec2(row(0.3, 0.8), row(0.4, 0.6))

    def sampled(span):
        inputs = {"uv": uv, "albedo_map": Texels(picture, picture, span)}
        return run_intervals(albedo_textured, inputs, profile)["albedo"].value.x

    bytes_, floats = sampled(1.0), sampled(0.0)
    assert np.allclose(floats.low - bytes_.low, slack, atol=2e-7)
    assert np.allclose(bytes_.high - floats.high, slack, atol=2e-7)


def test_an_undecided_condition_takes_both_sides():
    inputs = {"x": between([0.6, 0.4, 0.1], [0.7, 0.6, 0.2]), "table": Array(row(1, 7)), "entry": 0}
    got = run_intervals(step, inputs, VULKAN)["value"]
    assert ends(got) == [(1, 1), (1, 7), (7, 7)]
    assert got.doubt.tolist() == [0, CONDITION, 0]
    same = run_intervals(step, {**inputs, "entry": 1}, VULKAN)["value"]
    assert not same.doubt.any()


def test_an_undecided_condition_takes_a_number_and_a_vector():
    inputs = {"x": between([0.6, 0.4, 0.1], [0.7, 0.6, 0.2]), "v": vec3(F(1), F(7), F(0))}
    got = run_intervals(beside_a_vector, inputs, VULKAN)["three"]
    wanted = [[(1, 1)] * 3, [(1, 1), (1, 7), (7, 7)], [(1, 1), (0, 1), (0, 0)]]
    assert [list(zip(part.low, part.high, strict=True)) for part in components(got.value)] == wanted
    assert got.doubt.tolist() == [0, CONDITION, 0]


def test_a_truth_value_is_in_doubt_where_it_is_undecided():
    inputs = {"x": between([0.6, 0.4, 0.4], [0.7, 0.6, 0.6]), "y": row(1, 1, 0)}
    got = run_intervals(both_above, inputs, VULKAN)["both"]
    assert ends(got) == [(True, True), (False, True), (False, False)]
    assert got.doubt.tolist() == [0, CONDITION, 0]


def test_an_undecided_input_is_no_doubt_of_the_stage_until_it_chooses():
    flag = Interval(np.array([False]), np.array([True]))
    for function, doubt in [(passed_on, 0), (chosen_by, CONDITION)]:
        (got,) = run_intervals(function, {"flag": flag}, VULKAN).values()
        assert got.doubt.tolist() == [doubt]


def test_an_entry_outside_its_table_may_be_anything():
    inputs = {"x": F(1), "table": Array(row(1, 7)), "entry": np.array([-1, 0, 2])}
    got = run_intervals(step, inputs, VULKAN)["value"]
    assert ends(got) == [(-np.inf, np.inf), (1, 1), (-np.inf, np.inf)]


@pytest.mark.parametrize("stage_", [scaled, scaled_entry], ids=lambda s: s.name)
def test_a_subnormal_may_be_read_as_zero(stage_):
    inputs = {"x": F(2.0**-130), "table": Array(row(2.0**-130)), "factor": row(2.0**40)}
    for profile, low in [(VULKAN, 0.0), (IEEE, 2.0**-90)]:
        got = run_intervals(stage_, {name: inputs[name] for name in stage_.parameters}, profile)["value"]
        assert got.value.low.tolist() == [low] and got.value.high[0] >= 2.0**-90


def test_the_fraction_of_a_scalar_is_any_where_it_reaches_the_next_whole_number():
    got = run_intervals(fraction_of, {"x": between([2.25, 2.75], [2.5, 3.25])}, VULKAN)["value"]
    assert ends(got) == [(0.25, 0.5), (-0.25, 1.25)]


def test_a_body_splits_one_position():
    with pytest.raises(StageError, match="a body splits two positions between texels; put one of them into a function"):
        run_intervals(two_positions, {"a": vec2(row(1), row(1)), "b": vec2(row(2), row(2))}, VULKAN)


def test_a_position_that_may_lie_in_more_than_two_cells_may_lie_in_any():
    wide = vec2(between([0.5, 0.5, 0.5], [0.9, 1.5, 2.5]), row(1.5, 1.5, 1.5))
    got = run_intervals(cell_of, {"position": wide}, VULKAN)["value"]
    assert ends(got) == [(0, 0), (0, 1), (-(2.0**31), 2.0**31)]


def test_what_is_undefined_is_unbounded():
    got = run_intervals(root_of_inverse, {"x": between([4, -1, 0], [4, 1, 0])}, VULKAN)["value"]
    assert got.unbounded.tolist() == [False, True, True]


@pytest.mark.parametrize("stage_", [bilinear_value, repeated_value], ids=lambda s: s.name)
def test_a_bilinear_sample_is_as_wide_as_its_coordinates_make_it(stage_):
    rng = np.random.default_rng(3)
    picture = rng.random((5, 8)).astype(F)
    low = rng.uniform(0, 0.99, (2, 2000)).astype(F)
    high = low + F(2e-3)
    uv = vec2(*(Interval(a, b) for a, b in zip(low, high, strict=True)))
    got = run_intervals(stage_, {"picture": Texture(picture), "uv": uv}, VULKAN)["value"]
    least, most = np.full(2000, np.inf), np.full(2000, -np.inf)
    for share in rng.random((400, 2, 1)):
        at = vec2(*(low + (high - low) * share).astype(F))
        sample = stage_(Texture(picture), at).value
        least, most = np.minimum(least, sample), np.maximum(most, sample)
    assert (got.value.low <= least).all() and (most <= got.value.high).all()
    slack = 2 * (2e-3 * 8 + 2.0**-7)  # texels: the range's own width and twice the position's slack, on two axes
    assert (got.value.high - got.value.low <= (most - least) + slack).all()


# Rebased: every stage of a rendering on the oracle's own buffers


class Recording:
    """The array interpreter, which keeps what it was handed."""

    run_vertices = staticmethod(arrays.run_vertices)

    def __init__(self):
        self.works = []

    def run_fragments(self, work, pool):
        self.works.append(work)
        return arrays.run_fragments(work, pool)


def works_of(scene, **overrides):
    """What each pass of a small rendering was handed."""
    small = {
        f"{table}.{side}": 128 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
    }
    loaded = sss_ref.load_scene(scene, **small, **overrides)
    method, recording = loaded.method, Recording()
    wanted, buffers, machine = set(method.outputs), {}, Machine(recording)
    for one in method.only(wanted).passes:
        buffers |= shaded(loaded, one, draw(loaded, one, buffers, machine), buffers, wanted, machine)
    return recording.works


def rebased(works, profile):
    """Stage by stage: its inputs, the oracle's values and the outcomes, each by buffer."""
    for work in works:
        at = np.nonzero(work.fragments.where)
        for stage_, inputs, results in arrays.run_stages(work, *at, arrays.draw_values(work, *at)):
            named = dict(zip(stage_.parameters, inputs, strict=True))
            yield stage_, named, results, run_intervals(stage_, named, profile)


def widths(outcome, value):
    """Of each component in ULP of the largest one at its pixel."""
    parts = components(outcome.value)
    largest = np.max([np.abs(v) for v in components(value)], axis=0)
    return np.array([(part.high.astype(float) - part.low) / np.spacing(largest.astype(F)) for part in parts])


SCENES = ["sphere", "figure3_with", "figure5"]
WIDEST = 64  # ULP, 19 of 20 pixels of a buffer
WIDER = {  # what may be wider, and why
    "entry_point": 128,  # light_position + direction * distance: the light is far, the point near the origin
    "phong": 208,  # the highlight, a 32nd power
    "gloss": 20000,  # the highlight alone, far from its peak
    "thickness": 300000,  # the difference of two points that almost coincide
    "scattered": 104,  # thirteen samples and their sum
    "scattered_irradiance": 104,
}


@pytest.fixture(scope="module", params=SCENES)
def works(request):
    return works_of(request.param)


def test_stages_on_the_oracles_buffers_give_narrow_intervals_around_the_oracles_values(works):
    """With float32 weights; the eight bits that a bilinear sample may have widen it by the picture's own slope."""
    for _, _, results, outcomes in rebased(works, replace(VULKAN, weight_bits=0)):
        for name, outcome in outcomes.items():
            assert not outside(outcome, components(results[name])).any()
            assert not outcome.unbounded.any()
            assert (outcome.doubt & CONDITION > 0).mean() <= 0.01 and (outcome.doubt > 0).mean() <= 0.025
            if components(outcome.value)[0].low.dtype == F:
                limit = WIDER.get(name.removeprefix("texel_"), WIDEST)
                assert np.percentile(widths(outcome, results[name]), 95) <= limit, name


def test_the_thickness_is_as_wide_as_its_ends(works):
    """Of a difference that cancels the ULP of the operands is the measure: that of the distance to the light."""
    checked = 0
    for stage_, inputs, _, outcomes in rebased(works, VULKAN):
        if stage_.name == "back_point":
            (thickness,) = (outcome for name, outcome in outcomes.items() if "thickness" in name)
            width = thickness.value.high.astype(float) - thickness.value.low
            assert np.percentile(width / np.spacing(inputs["stored_distance"]), 95) <= WIDEST
            checked += 1
    assert checked


def test_an_exponent_of_0_7501_is_found(works):
    checked = 0
    for stage_, inputs, results, outcomes in rebased(works, VULKAN):
        if stage_.name == translucency_ratio_throughout.name:
            with np.errstate(all="ignore"):
                (wrong,) = stage_(*{**inputs, "exponent": F(0.7501)}.values())
            (right,), (outcome,) = results.values(), outcomes.values()
            passing = inputs["shadow_uv"].x >= 0  # elsewhere nothing is known of the thickness
            assert passing.sum() > 500
            assert outside(outcome, [wrong])[passing].mean() > 0.95
            assert not outside(outcome, [right]).any()
            checked += 1
    assert checked
