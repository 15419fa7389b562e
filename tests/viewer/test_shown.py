"""Which pass draws a buffer, what else must be kept to show it, and the order of its pixels."""

import numpy as np
import pytest
from tabs import SMALL

from sss_ref.scene.load import load_scene
from sss_ref.viewer.shown import needed, opaque, pass_of


@pytest.fixture(scope="module")
def scene():
    return load_scene("figure3_with", **SMALL)


@pytest.mark.parametrize(
    ("name", "drawn_in", "kept"),
    [
        ("image", "camera", {"image"}),
        ("normal_world", "camera", {"normal_world", "triangle"}),
        ("light_distance", "shadow_map", {"light_distance", "light_triangle"}),
    ],
)
def test_a_buffer_is_shown_where_its_pass_drew(scene, name, drawn_in, kept):
    assert name in pass_of(scene, name).values and pass_of(scene, name).target == drawn_in
    assert needed(scene, name) == kept


def test_the_top_row_comes_first_and_nothing_shines_through():
    colours = np.arange(18, dtype=np.uint8).reshape(3, 2, 3)
    found = opaque(colours)
    assert (found.shape, found.dtype) == ((3, 2, 4), np.uint8)
    assert found[0].tolist() == [[12, 13, 14, 255], [15, 16, 17, 255]]
    assert found[2].tolist() == [[0, 1, 2, 255], [3, 4, 5, 255]]
