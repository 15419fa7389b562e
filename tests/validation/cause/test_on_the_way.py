"""What happens to a buffer on its way is told, and whether a state or a matrix is to blame."""

import numpy as np
import pytest
from checked import check_of

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.cause.hypothesis import INPUT, SETTING
from sss_ref.validation.cause.on_the_way import changes_on_the_way, within
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


def explained(check):
    """In words -> the pixels that they explain, and those on which they can be told."""
    return {charge.text: (holds, where) for charge, holds, where in changes_on_the_way(check)}


def holds(expected, got, text, **others):
    """The pixels that are explained by what starts so."""
    (found,) = (each for words, each in explained(check_of(expected, got, **others)).items() if words.startswith(text))
    return found[0].tolist()


VALUES = np.float32([[0.25, -0.5, 1.5, 0.02]])
CHANGES = {
    "it was cut off at 0 and 1": [[0.25, 0, 1, 0.02]],
    "its sign is turned": [[-0.25, 0.5, -1.5, -0.02]],
    "it is n*.5+.5": [[0.625, 0.25, 1.25, 0.51]],
    "it is sRGB-encoded": [[*(1.055 * x ** (1 / 2.4) - 0.055 if x > 0 else 0 for x in (0.25, -0.5, 1.5, 0.02))]],
    "it is sRGB-decoded": [[(0.305 / 1.055) ** 2.4, 0, (1.555 / 1.055) ** 2.4, 0.02 / 12.92]],
}


@pytest.mark.parametrize("text", CHANGES)
def test_what_may_happen_to_numbers(text):
    assert holds(VALUES, CHANGES[text], text, reach=1e-6) == [[True] * 4]
    assert holds(VALUES, np.float32(CHANGES[text]) + 1e-3, text, reach=1e-6) == [[False] * 4]


DEPTHS = {
    "its z was made for the other convention": [[0.5, 0.625, 1]],
    "its z was made from -w to w": [[-1, -0.5, 1]],
    "it is reversed": [[1, 0.75, 0]],
}


@pytest.mark.parametrize("text", DEPTHS)
def test_what_may_happen_to_depths(text):
    depths = [[0.0, 0.25, 1.0]]
    assert holds(depths, DEPTHS[text], text, stage=RASTERIZER) == [[True] * 3]
    assert not any(words.startswith(text) for words in explained(check_of(depths, depths)))
    assert not set(CHANGES) & set(explained(check_of(depths, depths, stage=RASTERIZER)))


def test_channels_and_rows_that_changed_places():
    picture = np.arange(12, dtype=np.float32).reshape(2, 2, 3)
    assert holds(picture, picture[..., ::-1], "its channels are in reverse") == [[True] * 2] * 2
    assert holds(picture, picture[::-1], "its rows are upside down") == [[True] * 2] * 2
    assert not any("channels" in words for words in explained(check_of(picture[..., 0], picture[..., 0])))
    upwards = [[[0.25, 0.125], [0.5, 1.0]]]
    down = [[[0.25, 0.875], [0.5, 0.0]]]
    assert holds(upwards, down, "its v is measured from the top") == [[True, True]]
    assert not any("its v" in words for words in explained(check_of(picture, picture)))


def test_turned_rows_are_told_where_both_were_compared():
    picture, where = np.arange(6.0).reshape(3, 2), [[True, True], [True, False], [False, True]]
    _, told_at = explained(check_of(picture, picture, where=where))["its rows are upside down"]
    assert told_at.tolist() == [[False, True], [True, False], [False, True]]


def test_of_numbers_of_triangles_only_the_rows_are_tried():
    numbers = np.int32([[1, 2]])
    assert [*explained(check_of(numbers, numbers))] == ["its rows are upside down"]


def test_a_channel_that_is_the_same_all_over():
    expected = np.float32([[[1, 2, 3], [4, 5, 6]]])
    got = np.float32([[[1, 7, 3], [4, 7, 9]]])
    text = "its channel 1 is not written, and is 7 all over"
    assert holds(expected, got, text) == [[True, False]]
    assert [words for words in explained(check_of(expected, got)) if words.startswith("its channel ")] == [text]
    assert not any("is not written" in words for words in explained(check_of([[1.0, 2.0]], [[7.0, 7.0]])))


def test_within_reach_in_every_channel():
    expected, got = [[[1.0, 2.0], [1.0, 2.0]]], [[[1.5, 2.0], [1.5, 2.75]]]
    check = check_of(expected, got, reach=0.5)
    assert within(check, check.got, check.expected).tolist() == [[True, False]]
