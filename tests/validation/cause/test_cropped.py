"""What cut a draw off, moved it or mixed it with what was there is told from the buffer alone."""

import numpy as np
import pytest

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.cause.hypothesis import SETTING
from sss_ref.validation.scope import Scope
from sss_ref.validation.stage_by_stage import validate

SIZES = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SIZES, method="screen_space"), "arrays", threads=1)


def explained(oracle, changed):
    """The explanations of a dump with some buffers changed."""
    return validate(oracle, {**oracle.buffers, **changed}, explain=Scope(power=False, seconds=60)).finding.hypotheses


def first(oracle, changed):
    return explained(oracle, changed)[0]


def emptied(oracle, shown):
    """The triangles of the camera, none where not shown, bool (H, W)."""
    return {"triangle": np.where(shown, oracle["triangle"], np.int32(-1))}


def test_a_scissor_is_told_with_its_rectangle(oracle):
    shown = np.zeros_like(oracle["triangle"], bool)
    shown[10:20, 12:22] = True
    found = first(oracle, emptied(oracle, shown))
    assert found.text.startswith("nothing is drawn but in columns 12 to 21 and rows 10 to 19") and found.share == 1
    assert found.blames == SETTING


def test_nothing_at_all_is_told_beside_vertices_that_draw_nothing(oracle):
    vertices, test = explained(oracle, emptied(oracle, np.zeros_like(oracle["triangle"], bool)))
    assert vertices.text.startswith("mesh_vertex: clip_position is not divided by w")
    assert test.text.startswith("nothing is drawn: a test") and test.blames == SETTING


def test_depths_that_were_cleared_near_are_told(oracle):
    limit = np.float32(np.median(oracle["depth"][oracle["triangle"] >= 0]))
    found = first(oracle, emptied(oracle, oracle["depth"] < limit))
    nearest = oracle["depth"][(oracle["depth"] < limit)].max()
    assert found.text == f"nothing is drawn farther than depth {nearest:.4g}: the depths were cleared to that"


def test_a_viewport_that_lies_off_by_whole_pixels_is_told(oracle):
    moved = np.full_like(oracle["triangle"], -1)
    moved[3:, :-2] = oracle["triangle"][:-3, 2:]
    found = first(oracle, {"triangle": moved})
    assert found.text == "the picture lies 2 pixels too far left and 3 pixels too far up: a viewport"


def test_what_is_added_to_what_was_there_is_told(oracle):
    shown = oracle["light_triangle"] >= 0
    background = oracle["light_distance"][~shown][0]
    added = np.where(shown, oracle["light_distance"] + background, background)
    assert first(oracle, {"light_distance": added}).text == "it is added to what the target is cleared to: blending"
