"""Trying out a technique: a scene that runs a stage of your own in the place of one of ours."""

from dataclasses import replace
from typing import Any

import numpy as np

from sss_ref.errors import SceneError
from sss_ref.language import Stage
from sss_ref.language.layout import WRITTEN
from sss_ref.language.pipeline import PIXEL, Method
from sss_ref.language.typing_rules import type_name
from sss_ref.scene.scene import Scene


def with_stage(scene: Scene, in_place_of: str, stage: Stage, **values: Any) -> Scene:
    """A scene whose method runs `stage` where it ran the stage named `in_place_of`.

    With several lights it runs once for each, as ours did.
    stage: writes at least what that one wrote, with the same types; other outputs are new buffers, of float, vec2,
    vec3, int or bool. It may read every buffer of the passes and stages before it and every uniform, by name, and
    uniforms of its own. values: those, each a number or a sequence of them, rounded to float32.
    Raises SceneError where names or types do not fit.
    """
    _check_outputs(scene.method, in_place_of, stage)
    own = {name: np.array(value, np.float32) for name, value in values.items()}
    changed = replace(
        scene,
        own_stages={**scene.own_stages, in_place_of: stage},
        own_uniforms={**scene.own_uniforms, **{name: v if v.ndim else v[()] for name, v in own.items()}},
    )
    _check_reads(changed.method, stage, set(changed.uniforms))
    return changed


def _check_outputs(method: Method, name: str, stage: Stage) -> None:
    stages = method.stages
    if name not in stages:
        raise SceneError(f"with_stage: expected a stage of the scene ({', '.join(stages)}), got {name!r}")
    for own, kind in stages[name].outputs.items():
        if stage.outputs.get(own) != kind:
            came = f"it as {type_name(stage.outputs[own])}" if own in stage.outputs else "none"
            expected = f"{stage.name} to write {own} as {type_name(kind)}, as {name} does"
            raise SceneError(f"with_stage: expected {expected}, got {came}; add it to what it returns")
    for own, kind in stage.outputs.items():
        if own not in stages[name].outputs and kind not in WRITTEN:
            expected = f"{stage.name} to write {own} as {', '.join(map(type_name, WRITTEN[:-1]))} or bool"
            raise SceneError(f"with_stage: expected {expected}, got {type_name(kind)}; write its parts")


def _check_reads(method: Method, stage: Stage, known: set[str]) -> None:
    there = known | {PIXEL}
    for this_pass in method.passes:
        there |= {*this_pass.draw.outputs, *this_pass.draw.varyings}
        for each in this_pass.stages:
            missing = sorted(set(each.reads.values()) - there)
            if each.python is stage.python and missing:
                raise SceneError(
                    f"with_stage: expected what {stage.name} reads to be there before it, got no {missing[0]}; give it "
                    f"as a value, or read one of {', '.join(sorted(there))}"
                )
            there |= set(each.writes.values())
