"""The faults that are drawn on OpenGL, in WGSL on lavapipe: the same stages are named, by another compiler."""

from dataclasses import replace
from functools import partial

import pytest
from edited import SHIPPED, blamed, drawn_edited, rendered
from faults import SCREEN_SPACE, TEXTURE_SPACE
from lavapipe import LAVAPIPE, needs_lavapipe
from wgsl_words import ONLY_OF, edits_in_wgsl

from sss_ref import webgpu
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.interpret.shader import WGSL
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_lavapipe

FREE = replace(PROFILES["vulkan"], contraction="free")  # as WGSL allows
QUICK = ("exponent 0.601", "taps swapped")
TABLES = {"screen": SCREEN_SPACE, "texture": TEXTURE_SPACE}


def cases():
    """Every fault of both tables; the long way in full."""
    for table, faults in TABLES.items():
        for name in faults:
            quick = table == "screen" and name in QUICK
            yield pytest.param(table, name, marks=() if quick else pytest.mark.full, id=f"{table}: {name}")


draw = partial(webgpu.draw, adapter=LAVAPIPE)


@pytest.mark.parametrize(("table", "name"), list(cases()))
def test_the_stage_with_the_fault_is_named(table, name, tmp_path):
    fault = TABLES[table][name]
    files = ONLY_OF.get(name, fault.files)
    drawing = drawn_edited(fault.scene, edits_in_wgsl(name, fault.edits), tmp_path, files, WGSL, draw)
    found = validate(rendered(fault.scene), drawing, profile=FREE, explain=False)
    assert not found.passed and blamed(found.culprit) == [fault.at]


@pytest.mark.full
@pytest.mark.parametrize("scene", ["slabs", *SHIPPED])
def test_the_scenes_that_show_the_faults_pass_without_them(scene, tmp_path):
    found = validate(rendered(scene), drawn_edited(scene, {}, tmp_path, "", WGSL, draw), profile=FREE, explain=False)
    assert found.passed, found.summary
