"""Exams as JSON has them: shaders, what they read, and between which numbers lies what is right."""

import inspect
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any, get_origin

from sss_ref.interpret.shader import ESSL, array_lengths, draws, fragment_shader, vertex_shader
from sss_ref.language.layout import CHANNELS
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import Texture
from sss_ref.language.typing_rules import type_name
from sss_ref.passes.buffers import described
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.rasterizer.candidates import FAR
from sss_ref.webgl.allowed import Allowed
from sss_ref.webgl.content import output, pass_settings
from sss_ref.webgl.exam_of_draw import ExamOfDraw
from sss_ref.webgl.exams import Exam
from sss_ref.webgl.packing import Packed, deflated
from sss_ref.webgl.planting import wrong_lines, wrong_vertex_lines
from sss_ref.webgl.varyings_shader import DEPTH, TRIANGLE, varyings_draws

Form = dict[str, Any]


def forms_of_stage(scene: Scene, exam: Exam) -> Iterator[Form]:
    """The exam of a fragment stage: one form for each draw that it takes, which is one but for very large stages."""
    alone, lengths = exam.alone, array_lengths(scene.uniforms)

    def shader(outputs: tuple[str, ...], stage: Stage) -> str:
        of_stage = Pass(alone.name, alone.target, alone.draw, (stage,))
        return fragment_shader(of_stage, exam.given, outputs, lengths, ESSL)

    for name, outputs in draws(alone, alone.values, ESSL).items():
        draw = {
            "name": name,
            "vertex": vertex_shader(alone, lengths, ESSL),
            "fragment": shader(outputs, exam.stage),
            "outputs": [output(each, alone.values[each], scene.clear(each)) for each in outputs],
        }
        wrong = wrong_lines(exam, scene.uniforms, partial(shader, outputs))
        yield {
            **_about(scene, exam.of, exam.stage),
            **pass_settings(alone, scene),
            "edit": "fragment",
            "draws": [draw],
            "given": {each: key(exam.of, each) for each in exam.given},
            "right": {each: _right(each, exam.right[each]) for each in outputs},
            "mistakes": [vars(each) for each in wrong],
        }


def form_of_draw(oracle: Result, exam: ExamOfDraw) -> Form:
    """The exam of a draw of a mesh: its vertex stage, which our own fragment shaders show. oracle: the rendering."""
    scene, this_pass, (stage,) = oracle.scene, exam.of, exam.of.draw.vertex_stages
    lengths, draws_of = array_lengths(scene.uniforms), f"{this_pass.name}/{stage.name}"
    mesh_draw = this_pass.draw
    assert isinstance(mesh_draw, MeshDraw)

    def shader(vertex: Stage) -> str:
        return vertex_shader(replace(this_pass, draw=replace(mesh_draw, vertex=vertex)), lengths, ESSL)

    listed = [
        {
            "name": draws_of,
            "vertex": shader(stage),
            "fragment": each["fragment"],
            "outputs": [output(name, kind, _beside(name)) for name, kind in each["outputs"].items()],
        }
        for each in varyings_draws(this_pass, list(exam.varyings))
    ]
    columns = {
        name: {"first": first, "channels": CHANNELS[this_pass.draw.varyings[name]]}
        for name, first in exam.varyings.items()
    }
    return {
        **_about(scene, this_pass, stage),
        **pass_settings(this_pass, scene),
        **{"rounds": 1, "feedback": {}, "edit": "vertex", "draws": listed},
        "given": {name: name for name in set(this_pass.draw.reads) & set(scene.method.values)},
        "candidates": _candidates(exam),
        "varyings": columns,
        "mistakes": [
            vars(each) for each in wrong_vertex_lines(stage, exam.inputs(oracle), list(exam.varyings), shader)
        ],
        "shown": {name: key(this_pass, name) for name in (*exam.reference.written, *exam.varyings)},
    }


def key(this_pass: Pass, name: str) -> str:
    """Where the page has a buffer: what the draw of a pass gives under the pass's name, all else under its own."""
    return f"{this_pass.name}/{name}" if name in {TRIANGLE, DEPTH, *this_pass.draw.varyings} else name


def _about(scene: Scene, this_pass: Pass, stage: Stage) -> Form:
    """What the page says of a stage, and what it reads, by its own names."""
    return {
        "pass": this_pass.name,
        "stage": stage.name,
        "about": inspect.cleandoc(stage.description).partition("\n\n")[0].replace("\n", " "),
        "source_of": stage.source,
        "reads": [
            {"own": own, "name": stage.reads[own], "type": type_name(kind), "whole": get_origin(kind) is Texture}
            for own, kind in stage.parameters.items()
        ],
    }


def _right(name: str, right: Allowed) -> Form:
    """Between which numbers a buffer's lie, as steps from the reference's own."""
    return {
        "unit": described(name).unit,
        "below": deflated(right.below),
        "above": deflated(right.above),
        "state": deflated(right.state),
    }


def _candidates(exam: ExamOfDraw) -> dict[str, Packed]:
    """What each pixel of a draw may show."""
    named = {"covered": exam.covered, "first": exam.first, "triangle": exam.triangle, "low": exam.low}
    return {name: deflated(array) for name, array in (named | {"high": exam.high}).items()}


def _beside(name: str) -> float:
    """What an output of a mesh's draw holds where nothing is drawn."""
    return {TRIANGLE: -1, DEPTH: FAR}.get(name.partition("_")[0], 0)
