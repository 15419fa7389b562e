"""Whole scenes on WebGL 2 beside the oracle with as many subpixel bits: same coverage, close values."""

import numpy as np
import pytest
from chromium import SUBPIXEL_BITS, needs_chromium
from scenes import around, sphere, two_squares, written

from sss_ref import webgl
from sss_ref.errors import ShaderError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.webgl import content

pytestmark = needs_chromium

SIZE = 96
NEAR_TIES = 2  # pixels of a picture where two triangles share the sample and nearly the depth
SMALL = {
    f"{table}.{side}": SIZE for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
}


def both(scene):
    """The buffers of the oracle and of WebGL."""
    expected = render(scene, "arrays", threads=1, subpixel_bits=SUBPIXEL_BITS).buffers
    got = webgl.draw(scene)
    assert list(got) == list(expected)
    for name, buffer in got.items():
        assert (buffer.dtype, buffer.shape) == (expected[name].dtype, expected[name].shape)
    return expected, got


def body(tmp_path, size=64, **tables):
    positions, triangles, uvs = sphere(12)
    path = written(tmp_path / "sphere.obj", positions, triangles, uvs)
    return load_scene(around(path, size, irradiance_map={"width": size, "height": size}, **tables))


def assert_same_coverage(got, expected):
    for name in ("coverage", "irradiance_mask", "irradiance_filled_mask"):
        if name in expected:
            np.testing.assert_array_equal(got[name], expected[name])
    for name in {"triangle", "light_triangle"} & set(expected):
        np.testing.assert_array_equal(got[name] < 0, expected[name] < 0)
        assert (got[name] != expected[name]).sum() <= NEAR_TIES


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
@pytest.mark.parametrize("scene", ["wedge", "teaching"])
def test_the_same_pixels_show_the_same_triangles_and_the_pictures_agree(scene, method):
    expected, got = both(load_scene(scene, **SMALL, method=method))
    assert_same_coverage(got, expected)
    for name in ("phong", "image"):
        apart = np.abs(got[name] - expected[name]).max(axis=-1)
        assert np.quantile(apart, 0.98) < 6e-4  # the wide snap moves what lies between the vertices
        assert np.ptp(expected[name]) > 0.05


def test_a_body_is_seen_through_another_one():
    expected, got = both(load_scene("teeth_layers", **SMALL))
    for name in ("coverage", "inner_coverage"):
        np.testing.assert_array_equal(got[name], expected[name])
    for name in ("inner_lit", "way_to_inner", "image"):
        apart = np.abs(got[name] - expected[name])
        assert np.quantile(apart, 0.98) < 2e-3 * np.ptp(expected[name])


def test_other_subpixel_bits_cover_other_pixels():
    scene = load_scene("teaching", **SMALL)
    got, fine = webgl.draw(scene, ["triangle"]), render(scene, "arrays", threads=1, keep=["triangle"])
    assert list(got) == ["triangle"]
    assert (got["triangle"] != fine["triangle"]).sum() > NEAR_TIES


@pytest.mark.parametrize("distance", [0.3, 1.2], ids=["from inside", "through the surface"])
def test_triangles_cut_by_the_near_plane_and_beyond_the_sides(tmp_path, distance):
    camera = {"distance": distance, "near": 0.25, "fov_y": 100.0}
    scene = body(tmp_path, **{"camera": around("any", 64)["camera"] | camera})
    names = ["triangle", "coverage"]
    expected = render(scene, "arrays", threads=1, keep=names, subpixel_bits=SUBPIXEL_BITS).buffers
    assert 0 < expected["coverage"].mean() <= 1
    assert_same_coverage(webgl.draw(scene, names), expected)


def test_the_printed_figures(tmp_path):
    """A texture read in the vertex shader, and targets of eight bits."""
    expected, got = both(body(tmp_path, preset="published", shadow_map={"width": 64, "height": 64}))
    assert_same_coverage(got, expected)
    steps = np.rint((got["image"] - expected["image"]) * 255)
    assert np.abs(steps).max() <= 2 and (steps == 0).mean() > 0.9
    assert len(np.unique(expected["image"])) > 50


@pytest.mark.parametrize("overlap", ["first", "last"])
def test_the_policy_decides_which_of_two_triangles_owns_a_texel(tmp_path, overlap):
    """Two squares, one behind the other, with the same UVs: in the mode `distance` they differ."""
    path = written(tmp_path / "squares.obj", *two_squares())
    layout = {"width": 32, "height": 32, "overlap": overlap, "mode": "distance"}
    scene = load_scene(around(path, 32, method="texture_space", irradiance_map=layout))
    expected = render(scene, "arrays", threads=1, keep=["irradiance"], subpixel_bits=SUBPIXEL_BITS)
    np.testing.assert_allclose(webgl.draw(scene, ["irradiance"])["irradiance"], expected["irradiance"], rtol=1e-5)


def test_a_shader_that_does_not_compile_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(content, "vertex_shader", lambda *_: "#version 300 es\nvoid main( {}")
    with pytest.raises(ShaderError, match=r"got shadow_map: expected shaders that compile, got ERROR"):
        webgl.draw(body(tmp_path))
