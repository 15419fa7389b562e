"""What the page that judges holds: the reference's buffers, and its exams, each with what a right device may draw."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from sss_ref.interpret.shader import ESSL
from sss_ref.language.pipeline import Pass
from sss_ref.rendering.fold import render
from sss_ref.rendering.result import Result
from sss_ref.results.manifest import package_version, scene_hash
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.scene import Scene
from sss_ref.webgl.content import inputs, texture
from sss_ref.webgl.exam_forms import Form, form_of_draw, forms_of_stage, key
from sss_ref.webgl.exam_of_draw import exam_of_draw
from sss_ref.webgl.exams import WEBGL, every_value, exams
from sss_ref.webgl.packing import deflated
from sss_ref.webgl.reference_draw import reference_draw


def judge_content(scene: Scene) -> dict[str, Any]:
    """All that the script of the page needs, as JSON has it; arrays are deflated.

    Raises RenderError, MeshError and SceneError as `sss_ref.render` does.
    """
    oracle = render(scene, "arrays", keep=every_value(scene))
    passes = [each for each in scene.method.passes if not each.on_demand]
    forms = [form for each in passes for form in _forms(oracle, each)]
    given = inputs(scene, deflated)
    varyings = {name for each in passes for name in each.draw.varyings}
    return {
        **given,
        "names": given["names"] | {ESSL.name(name): name for name in varyings},
        "about": _about(scene),
        "buffers": {name: texture(data, deflated) for name, data in _buffers(oracle, passes).items()},
        "exams": forms,
    }


def _forms(oracle: Result, this_pass: Pass) -> Iterator[Form]:
    """The exams of a pass: its draw, if it draws a mesh, then its stages in order."""
    if this_pass.draw.vertex_stages:
        yield form_of_draw(oracle, exam_of_draw(oracle, this_pass))
    for exam in exams(oracle, this_pass):
        yield from forms_of_stage(oracle.scene, exam)


def _buffers(oracle: Result, passes: list[Pass]) -> Mapping[str, np.ndarray]:
    """The reference's buffers, and what its draws of a mesh give."""
    found = dict(oracle.buffers)
    for each in passes:
        drawn = reference_draw(oracle, each)
        found |= {key(each, name): data for name, data in {**drawn.written, **drawn.varyings}.items()}
    return found


def _about(scene: Scene) -> dict[str, Any]:
    """What the page and its verdicts say of their origin."""
    return {
        "scene": scene.source,
        "settings": scene_hash(scene),
        "method": scene.method.name,
        "rules": RULES_VERSION,
        "version": package_version(),
        "subpixel_bits": WEBGL.subpixel_bits,
    }
