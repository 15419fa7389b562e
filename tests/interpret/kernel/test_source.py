"""The modules that are written for stages: the same in every process, one for all lights, nothing fused."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from example_stages import by_fragments, by_turns

from sss_ref.interpret.kernel.source import StageSource
from sss_ref.interpret.kernel.stage_rows import StageCall
from sss_ref.methods.stages import all_stages
from sss_ref.passes import blur, phong, shadow_map, translucency

STAGES = all_stages()
MODULES = Path(__file__).parent / "modules"
PRINT_SOURCES = """
import hashlib
from sss_ref.interpret.kernel.source import StageSource
from sss_ref.methods.stages import all_stages
uniform = {"x", "y", "exponent", "d_min", "translucency_neutral"}
texts = [StageSource(stage, each).text for stage in all_stages().values() for each in (set(), uniform)]
print(hashlib.sha256("".join(texts).encode()).hexdigest())
"""
OF_THE_MATERIAL = {"x", "y", "exponent", "d_min", "translucency_neutral"}


def test_the_source_does_not_depend_on_the_order_of_sets():
    """A source that changed between processes would be compiled again in each of them."""
    printed = [
        subprocess.run(
            [sys.executable, "-c", PRINT_SOURCES],
            env=os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(sys.path)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2", "3")
    ]
    assert len(printed[0]) == 65 and len(set(printed)) == 1


@pytest.mark.parametrize("name", STAGES)
def test_every_source_is_python(name):
    compile(StageSource(STAGES[name], set()).text, "<source>", "exec")


def test_a_stage_without_elementary_functions_is_one_loop():
    source = StageSource(shadow_map.back_point, {"light_position"})
    assert source.calls == [StageCall("back_point_0")]
    assert source.text.count("for k in range(count):") == 1


def test_names_that_a_pass_gives_are_not_in_the_source():
    """So that one module serves all lights."""
    first, second = (
        shadow_map.back_point.renamed(lambda name, number=number: f"{name}_{number}") for number in ("1", "2")
    )
    assert StageSource(first, {"light_position"}).text == StageSource(second, {"light_position"}).text


def test_an_elementary_function_is_called_between_two_loops():
    source = StageSource(phong.phong_shading, {"shininess"})
    assert [(call.function, call.elementary, call.single) for call in source.calls] == [
        ("phong_shading_0", False, False),
        ("pow", True, False),
        ("phong_shading_1", False, False),
    ]
    assert "_scalar" not in source.text


def test_an_elementary_function_of_uniforms_alone_is_computed_once_a_strip():
    source = StageSource(translucency.translucency_ratio, OF_THE_MATERIAL)
    assert [call.single for call in source.calls if call.elementary] == [True, False]


def test_a_loop_of_the_language_stands_around_the_loop_over_fragments():
    source = StageSource(blur.scatter, {"tap_count", "pixel_scale"})
    start, turns, *inside = (line for line in source.text.splitlines() if line.lstrip().startswith("for "))
    assert start == "    for k in range(count):" and turns.startswith("    for tap_wide in range(")
    assert [line.strip() for line in inside] == [
        "for k in range(count):",
        "for side in range(2):",
        "for k in range(begin, end):",
        "for k in range(np.int64(low), np.int64(high)):",
    ]


def test_a_turn_is_written_twice_where_texels_may_lie_side_by_side():
    """Once with each texel's number computed, once with it counted on from that of the fragment in the middle."""
    _, computed = StageSource(blur.scatter, {"tap_count", "pixel_scale"}).text.split("range(begin, end):")
    computed, counted = computed.split("range(np.int64(low), np.int64(high)):")
    assert counted.count("_first + k\n") == 4 and "_first" not in computed
    assert "np.int32(texel_clamped_place + I_1)" in computed and "= texel_clamped_place + I_1\n" in counted


def test_a_loop_whose_turns_differ_between_fragments_stands_inside():
    source = StageSource(blur.scatter, {"pixel_scale"})
    assert "        for tap_wide in range(" in source.text and source.text.count("for k in range(count):") == 1


def test_float_literals_are_float32_constants():
    """A bare literal would make numba compute in float64."""
    text = StageSource(shadow_map.shadow_lookup_nearest, set()).text
    assert "F_0_5 = np.float32(0.5)" in text
    body = text.split("\ndef ")[1]
    assert "F_0_5" in body and " 0.5" not in body


@pytest.mark.parametrize(
    ("example", "uniform", "calls", "rows"),
    [
        (
            by_turns,
            {"count", "exponent"},
            [
                StageCall("by_turns_0"),
                StageCall("by_turns_1"),
                StageCall("pow", (10, 11, 12), elementary=True),
                StageCall("exp2", (9, 13), elementary=True, single=True),
                StageCall("by_turns_2"),
            ],
            (4, 5, 14),
        ),
        (by_fragments, {"turned", "always"}, [StageCall("by_fragments_0")], (7, 5, 12)),
    ],
    ids=["by_turns", "by_fragments"],
)
def test_the_module_of_an_example(example, uniform, calls, rows):
    """All that is written, for many ways of writing it give the same bits and differ in the time they take."""
    source = StageSource(example, uniform)
    assert source.text == (MODULES / f"{example.name}.txt").read_text()
    assert source.calls == calls
    assert (source.rows.inputs, source.rows.outputs, len(source.rows.rows)) == rows
