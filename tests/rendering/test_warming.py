"""After a warm-up no rendering of a shipped scene meets a stage that is not compiled."""

import pytest

from sss_ref.interpret.kernel.modules import CODES
from sss_ref.methods.stages import all_stages
from sss_ref.rendering.fold import render
from sss_ref.rendering.warming import SMALL, steps
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.shipped import scene_names


def counted():
    """Signature -> how many bodies of it are compiled."""
    return {signature: len(codes) for signature, codes in CODES.items()}


@pytest.fixture(scope="module")
def warmed():
    """The keys of what a warm-up compiles, in the place of all that this process did before."""
    before = dict(CODES)
    CODES.clear()
    said = [*steps()]
    assert said[0] == "the rasterizer" and {*scene_names()} < {*said}
    yield counted()
    CODES.update(before)


def test_every_stage_is_compiled(warmed):
    assert {name for name, *_ in warmed} >= {*all_stages()}


@pytest.mark.parametrize("name", scene_names())
def test_a_shipped_scene_compiles_nothing_more(warmed, name):
    scene = load_scene(name, **SMALL)
    render(scene)
    render(scene, keep="taps" if "taps" in scene.method.on_demand else "final")
    assert counted() == warmed
