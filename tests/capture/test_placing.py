"""A few files placed among the buffers of a small rendering: what is told, what is asked for, what is left."""

from pathlib import Path

import numpy as np
import pytest

from sss_ref.capture.placing import place
from sss_ref.capture.surfaces import Unnamed
from sss_ref.dump.texels import StoredTexels
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

SIZES = {"camera.width": 20, "camera.height": 20, "shadow_map.width": 24, "shadow_map.height": 24}
STORAGES = {"f": "float32", "i": "int32", "u": "uint8"}


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SIZES), "arrays", threads=1)


def picture(data, file, **more):
    data = data.reshape(*data.shape[:2], -1)
    texels = StoredTexels(data, tuple("RGBA"[: data.shape[2]]), STORAGES[data.dtype.kind])
    return Unnamed(Path(file), texels, **more)


def found(oracle, *pictures):
    """Buffer -> its file, and the first row and channels of it; questions; files that nothing is like."""
    arranged = place(list(pictures), oracle)
    places = {
        name: (str(each.surface), each.candidate.origin, each.candidate.channels)
        for name, each in arranged.placements.items()
    }
    questions = [([str(each) for each in one.surfaces], one.names) for one in arranged.questions]
    return places, questions, [str(each) for each in arranged.unknown]


def noise(like, size):
    return np.random.default_rng(1).random(like.shape, np.float32) * np.float32(size)


def test_places_are_told_in_stage_order(oracle):
    files = picture(oracle["phong"], "a.npy"), picture(oracle["thickness"][::-1], "b.npy")
    places = {"thickness": ("b.npy", "top", (0,)), "phong": ("a.npy", "bottom", (0, 1, 2))}
    assert found(oracle, *files) == (places, [], [])
    assert list(place([*files], oracle).placements) == ["thickness", "phong"]


def test_two_files_that_fit_a_buffer_alike_are_asked_for(oracle):
    near = picture(oracle["thickness"] * np.float32(1.00001), "a.npy")
    same = picture(oracle["thickness"], "b.npy")
    assert found(oracle, near, same) == ({}, [(["a.npy", "b.npy"], ("thickness",))], [])
    assert found(oracle, same, near) == ({}, [(["b.npy", "a.npy"], ("thickness",))], [])


def test_a_file_that_fits_two_buffers_alike_is_asked_for(oracle):
    """Of a sphere all that is seen has light behind it; what sees the light is another set of pixels."""
    asked = [(["a.npy"], ("coverage", "inside_shadow_valid"))]
    valid = picture(oracle["shadow_valid"], "b.npy")
    assert found(oracle, picture(oracle["coverage"], "a.npy")) == ({}, asked, [])
    places = {"shadow_valid": ("b.npy", "bottom", (0,))}
    assert found(oracle, picture(oracle["coverage"], "a.npy"), valid) == (places, asked, [])


def test_what_is_like_nothing_is_left(oracle):
    """Noise, one colour, and a picture of another size."""
    size = np.zeros((20, 20, 3), np.float32)
    files = picture(noise(size, 1), "a.npy"), picture(size + 1, "b.npy"), picture(oracle["thickness"][:9], "c.npy")
    assert found(oracle, *files) == ({}, [], ["a.npy", "b.npy", "c.npy"])


def test_what_is_called_like_a_buffer_is_that_if_it_may_be(oracle):
    """Of two the one that is more like it; of two names the first; never one of another size."""
    thickness = oracle["thickness"]
    twice = picture(thickness * 2, "a.npy", labels=("thickness",))
    near = picture(thickness * np.float32(1.5), "b.npy", labels=("x", "thickness"))
    assert found(oracle, twice, near) == ({"thickness": ("b.npy", "bottom", (0,))}, [], ["a.npy"])
    assert place([near], oracle).placements["thickness"].margin == 1
    both = picture(thickness, "a.npy", labels=("translucency", "thickness"))
    assert list(found(oracle, both)[0]) == ["thickness"]
    assert found(oracle, picture(thickness[:9], "a.npy", labels=("thickness",))) == ({}, [], ["a.npy"])


def test_a_spare_picture_counts_where_no_other_is_the_buffer(oracle):
    spare, other = picture(oracle["depth"], "a.npy", is_spare=True), picture(oracle["depth"], "b.npy")
    assert found(oracle, spare, other) == ({"depth": ("b.npy", "bottom", (0,))}, [], ["a.npy"])
    assert found(oracle, spare) == ({"depth": ("a.npy", "bottom", (0,))}, [], [])


def test_two_buffers_may_share_a_file(oracle):
    packed = picture(np.dstack([oracle["thickness"], oracle["phong"]]), "a.npy")
    places = {"thickness": ("a.npy", "bottom", (0,)), "phong": ("a.npy", "bottom", (1, 2, 3))}
    assert found(oracle, packed) == (places, [], [])


def test_an_opacity_is_no_mask_where_another_file_is(oracle):
    """Here of the pixels that see the light, as no buffer is alike."""
    with_alpha = np.dstack([oracle["phong"], oracle["shadow_valid"].astype(np.float32)])
    alone, beside = picture(with_alpha, "a.npy"), picture(oracle["shadow_valid"], "b.npy")
    phong = {"phong": ("a.npy", "bottom", (0, 1, 2))}
    assert found(oracle, alone) == ({"shadow_valid": ("a.npy", "bottom", (3,)), **phong}, [], [])
    assert found(oracle, alone, beside) == ({"shadow_valid": ("b.npy", "bottom", (0,)), **phong}, [], [])


@pytest.fixture(scope="module")
def nearly_even(oracle):
    """A depth that hardly tells which row comes first."""
    half = ((oracle["depth"] + oracle["depth"][::-1]) / 2).astype(np.float32)
    return picture(half + noise(half, 1e-4), "a.npy")


def test_rows_that_nothing_tells_are_asked_for(oracle, nearly_even):
    assert found(oracle, nearly_even) == ({}, [(["a.npy"], ("depth",))], [])
    even = ((oracle["depth"] + oracle["depth"][::-1]) / 2).astype(np.float32)
    assert found(oracle, picture(even, "a.npy"))[0] == {"depth": ("a.npy", "bottom", (0,))}, "they make no difference"


def test_rows_that_nothing_tells_run_as_in_other_files_of_the_kind(oracle, nearly_even):
    """As long as all of these agree."""
    normal = oracle["normal_world"]
    for rows, origin in ((normal, "bottom"), (normal[::-1], "top")):
        places = found(oracle, nearly_even, picture(rows, "b.npy"))[0]
        assert places["depth"] == ("a.npy", origin, (0,)) and places["normal_world"][1] == origin
    asked = [(["a.npy"], ("depth",))]
    turned = picture(normal[::-1], "b.npy")
    assert found(oracle, nearly_even, picture(normal[::-1], "b.exr"))[1] == asked
    assert found(oracle, nearly_even, turned, picture(oracle["position_world"], "c.npy"))[1] == asked


def test_an_order_of_channels_that_nothing_tells_is_that_of_three_others(oracle):
    """Of the same kind, and all of them in order."""
    phong = oracle["phong"]
    grey = picture(phong.mean(axis=2, keepdims=True) + noise(phong, 1e-3), "a.npy")
    two = [picture(oracle[name], f"{name}.npy") for name in ("normal_world", "position_world")]
    asked = [(["a.npy"], ("phong",))]
    assert found(oracle, grey)[1] == found(oracle, grey, *two)[1] == asked
    places, questions, _ = found(oracle, grey, *two, picture(oracle["uv"], "c.npy"))
    assert places["phong"] == ("a.npy", "bottom", (0, 1, 2)) and questions == []
    for other in (picture(oracle["uv"][..., ::-1], "c.npy"), picture(oracle["uv"], "c.exr")):
        assert found(oracle, grey, *two, other)[1] == asked
    one_channel = picture(oracle["thickness"], "c.npy")
    assert found(oracle, grey, *two, one_channel)[1] == asked


def test_what_is_drawn_wrong_keeps_its_place_and_is_followed(oracle):
    """All that comes after a thickness too large by a fifth is what its stage makes of it."""
    thick = (oracle["thickness"] * np.float32(1.2)).astype(np.float32)
    places = place([picture(thick, "a.npy"), picture(oracle["translucency"], "b.npy")], oracle).placements
    assert places["thickness"].candidate.close < 0.5 < places["thickness"].candidate.score
    assert places["translucency"].candidate.score == pytest.approx(1)
