"""What cut a draw off, moved it or mixed it with what was there is told from the buffer alone."""

from types import SimpleNamespace

import numpy as np
import pytest
from checked import check_of

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.cause.cropped import cropped, undrawn
from sss_ref.validation.cause.hypothesis import SETTING
from sss_ref.validation.clock import Limit
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


CLEAR = 9.0


def case_of(depth=None, clear=CLEAR):
    """A case whose buffer is cleared to a number, with the depths of its pass if there are any."""
    this_pass = SimpleNamespace(draw=SimpleNamespace(depth="depth"))
    scene = SimpleNamespace(clear=lambda name: clear, method={"pass": this_pass})
    buffers = {} if depth is None else {"depth": np.float32(depth)}
    return SimpleNamespace(oracle=SimpleNamespace(scene=scene, buffers=buffers))


def told(expected, got, case=None, seconds=60, **others):
    """In words -> the pixels that they explain."""
    found = cropped(case or case_of(), check_of(expected, got, **others), Limit(seconds))
    return {charge.text: holds.tolist() for charge, holds in found}


def picture(height=12, width=14):
    return np.arange(height * width, dtype=np.float32).reshape(height, width) / 8 + 10


def shifted(values, up, right):
    """A picture moved by whole pixels, pixel by pixel."""
    moved = np.full_like(values, CLEAR)
    for row, column in np.ndindex(values.shape):
        if 0 <= row - up < values.shape[0] and 0 <= column - right < values.shape[1]:
            moved[row, column] = values[row - up, column - right]
    return moved


def test_a_rectangle_is_that_of_what_is_shown():
    right = picture(5, 6)
    got = np.full_like(right, CLEAR)
    got[1:4, 2:5] = right[1:4, 2:5]
    got[2, 3] += 0.5
    (text,) = (text for text in told(right, got) if text.startswith("nothing is drawn but"))
    assert text == "nothing is drawn but in columns 2 to 4 and rows 1 to 3: a scissor, or a viewport"
    expected = np.ones((5, 6), bool)
    expected[2, 3] = False
    assert told(right, got)[text] == expected.tolist()


OFFSETS = [(8, 0), (-8, 0), (0, 8), (0, -8), (1, -1), (-1, 1), (-2, 3), (-8, -8)]
WORDS = {
    (8, 0): "8 pixels too far up",
    (-8, 0): "8 pixels too far down",
    (0, 8): "8 pixels too far right",
    (0, -8): "8 pixels too far left",
    (1, -1): "1 pixel too far left and 1 pixel too far up",
    (-1, 1): "1 pixel too far right and 1 pixel too far down",
    (-2, 3): "3 pixels too far right and 2 pixels too far down",
    (-8, -8): "8 pixels too far left and 8 pixels too far down",
}


@pytest.mark.parametrize(("up", "right"), OFFSETS)
def test_a_picture_may_lie_off_by_eight_pixels(up, right):
    got = shifted(picture(), up, right)
    assert all(all(row) for row in told(picture(), got)[f"the picture lies {WORDS[up, right]}: a viewport"])


@pytest.mark.parametrize(("up", "right"), [(9, 0), (0, -9)])
def test_but_no_farther(up, right):
    found = told(picture(), shifted(picture(), up, right))
    assert not any("pixels too far" in text and all(all(row) for row in holds) for text, holds in found.items())


@pytest.mark.parametrize(("up", "right"), [(2, 0), (-2, 0), (0, 4), (0, -4), (1, -3)])
def test_a_small_picture_may_lie_off_by_all_but_its_edge(up, right):
    """Of 3 by 5 pixels."""
    found = told(picture(3, 5), shifted(picture(3, 5), up, right))
    assert any("too far" in text and all(all(row) for row in holds) for text, holds in found.items())


def test_a_picture_that_lies_right_lies_nowhere_else():
    assert not any("too far" in text for text in told(picture(), picture()))


def test_of_two_offsets_that_fit_alike_the_first_is_told():
    flat = np.full((12, 14), 10.0)
    got = flat.copy()
    got[0] = CLEAR
    assert [text for text in told(flat, got) if "too far" in text] == [
        "the picture lies 1 pixel too far up: a viewport"
    ]


def test_an_offset_is_told_that_brings_a_single_pixel_back():
    found = told([[10.0, 11.0]], [[5.0, 10.0]])
    assert found["the picture lies 1 pixel too far right: a viewport"] == [[False, True]]


def test_the_search_for_an_offset_ends_with_its_time():
    assert not any("too far" in text for text in told(picture(), shifted(picture(), 1, 0), seconds=0))


def test_depths_cleared_near_hide_what_is_as_far_or_farther():
    depth = [[0.1, 0.2, 0.3, 0.4, 0.25, 0.2]]
    right = np.float32([[1, 2, 3, 4, 5, 6]])
    got = np.float32([[1, 2, CLEAR, CLEAR, CLEAR, 7]])
    found = told(right, got, case_of(depth))
    assert found["nothing is drawn farther than depth 0.2: the depths were cleared to that"] == [[True] * 5 + [False]]
    hidden = np.float32([[1, CLEAR, 3, CLEAR, CLEAR, 6]])  # the second is nearer than what is shown
    found = told(right, hidden, case_of(depth))
    words = "nothing is drawn farther than depth 0.3: the depths were cleared to that"
    assert found[words] == [[True, False, True, True, False, True]]
    as_far = np.float32([[1, CLEAR, 3, 4, 5, 6]])  # as deep as what is shown at the end
    found = told(right[:, [0, 1, 5]], as_far[:, [0, 1, 5]], case_of([[0.1, 0.2, 0.2]]))
    assert found["nothing is drawn farther than depth 0.2: the depths were cleared to that"] == [[True] * 3]
    for case, drawn in ((case_of(), got), (case_of(depth), right)):
        assert not any("depths were cleared" in text for text in told(right, drawn, case))
    where = [[False, False, True, True, True, False]]
    assert not any("depths were cleared" in text for text in told(right, got, case_of(depth), where=where))


BLENDED = {"added to": 2.5 + 9.0, "subtracted from": 9.0 - 2.5, "multiplied with": 2.5 * 9.0}


@pytest.mark.parametrize("words", BLENDED)
def test_what_blending_makes_of_a_number(words):
    text, value = f"it is {words} what the target is cleared to: blending", BLENDED[words]
    near = value * (1 + 2.0**-16 * np.array([0.9, -0.9, 1.2, -1.2]))
    assert told([[2.5] * 4], [near])[text] == [[True, True, False, False]]
    assert told([[2.5] * 4], [near], reach=value * 2.0**-17)[text] == [[True] * 4]
    assert told([[[2.5, 2.5]]], [[[value, 0]]])[text] == [[False]]


def test_nothing_multiplied_is_nothing():
    """Where nothing may be off, what is as it is explained to be counts."""
    text = "it is multiplied with what the target is cleared to: blending"
    assert told([[0.0, 0.0]], [[0.0, 2.0**-20]])[text] == [[True, False]]


def test_numbers_of_triangles_are_not_blended():
    assert not any("blending" in text for text in told([[1, 2]], [[1, 2]], case_of(clear=-1)))


def test_where_nothing_is_shown_nothing_is_cut_off_but_all_undrawn():
    empty = np.full((2, 3), CLEAR)
    assert not told(picture(2, 3), empty)
    ((charge, holds),) = undrawn(case_of(), check_of(picture(2, 3), empty))
    assert charge.text == "nothing is drawn: a test that nothing passes, or a mask" and holds.all()
    assert not [*undrawn(case_of(), check_of(picture(2, 3), picture(2, 3)))]
    colours = np.full((1, 2, 3), CLEAR)
    colours[0, 1, 2] = 1
    assert not [*undrawn(case_of(), check_of(colours, colours))]
