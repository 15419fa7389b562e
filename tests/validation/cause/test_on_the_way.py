"""What happens to a buffer on its way is told, and whether a state or a matrix is to blame."""

import numpy as np
import pytest

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.cause.hypothesis import INPUT, SETTING
from sss_ref.validation.scope import Scope
from sss_ref.validation.stage_by_stage import validate

SIZES = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SIZES, method="screen_space"), "arrays", threads=1)


def first(oracle, name, buffer):
    """The first explanation of a dump in which a buffer is another."""
    dumped = {**oracle.buffers, name: buffer.astype(np.float32)}
    return validate(oracle, dumped, explain=Scope(power=False, seconds=60)).finding.hypotheses[0]


def test_a_masked_channel_is_told(oracle):
    masked = oracle["position_world"] * np.array([1, 1, 0], np.float32)
    found = first(oracle, "position_world", masked)
    assert (found.text, found.blames) == ("its channel 2 is not written, and is 0 all over", SETTING)


def test_a_z_of_the_other_convention_is_a_matrix_or_a_state(oracle):
    """Our matrices are made for -w to w."""
    depth = oracle["depth"].astype(np.float64)
    made = first(oracle, "depth", depth * 0.5 + 0.5)
    assert made.text.startswith("its z was made for the other convention") and made.blames == INPUT
    taken = first(oracle, "depth", depth * 2 - 1)
    assert taken.text.startswith("its z was made from -w to w") and taken.blames == SETTING


def test_a_format_is_a_setting(oracle):
    found = first(oracle, "phong", oracle["phong"].astype(np.float16))
    assert found.text.startswith("it was stored as float16") and found.blames == SETTING
