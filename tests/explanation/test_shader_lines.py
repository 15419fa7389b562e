"""The lines of one stage at one fragment, as GLSL has them; nothing is rendered."""

import numpy as np

from sss_ref.explanation.shader_lines import glsl_lines
from sss_ref.explanation.traces import StageTrace
from sss_ref.interpret.trace import trace
from sss_ref.language import vec3
from sss_ref.passes.shadow_map import back_point


def traced(stage, *inputs):
    steps, writes = trace(stage, inputs)
    return StageTrace(stage, dict(zip(stage.reads.values(), inputs, strict=True)), steps, writes)


def vector(*parts):
    return vec3(*map(np.float32, parts))


def test_what_has_a_name_is_a_line_and_what_is_called_in_it_is_none():
    told = traced(back_point, vector(0, 0, 2), vector(0, 0, 4), np.float32(1), np.True_)
    translate = glsl_lines(told)
    assert [translate(step) for step in told.steps if step.text != step.name] == [
        "precise vec3 direction = normalize_(position_world - light_position);",
        "precise vec3 entry_point = shadow_valid ? light_position + direction * stored_distance : position_world;",
        "precise float thickness = length_(position_world - entry_point);",
    ]
    called = [inner for step in told.steps for inner in step.inner if not inner.name]
    assert called and {translate(inner) for inner in called} == {""}
