"""The method on one page is the method: every buffer of examples/one_page.py has the oracle's bits."""

import ast
import math
import runpy
import sys
from pathlib import Path

import numpy as np
import pytest
from scenes import around, cube, sphere, written

import sss_ref

PAGE = Path(__file__).parents[1] / "examples" / "one_page.py"
OF_THE_PACKAGE = {"sss_ref", "sss_ref.numerics.elementary", "sss_ref.pictures.png_file", "sss_ref.view.matrices"}
HARD = {"shadow_map.test": "slope", "blur.unit": "pixel"}  # of preset robust the page draws neither
MOST_LINES = 210  # that are not empty


@pytest.fixture(scope="module")
def page():
    return runpy.run_path(str(PAGE))


def small(name, **overrides):
    """A shipped scene at 48 x 40 pixels, with a shadow map of 64 x 56."""
    sizes = {"camera.width": 48, "camera.height": 40, "shadow_map.width": 64, "shadow_map.height": 56}
    return sss_ref.load_scene(name, **sizes, **overrides)


def assert_same_bits(page, scene):
    found, right = page["render"](scene), sss_ref.render(scene).buffers
    assert set(found) == set(right)
    for buffer, expected in right.items():
        assert found[buffer].dtype == expected.dtype, buffer
        assert np.array_equal(found[buffer].view(np.uint8), expected.view(np.uint8)), buffer


@pytest.mark.parametrize("preset", ["paper", "robust"])
@pytest.mark.parametrize("name", ["figure3_with", "teaching", "wedge"])
def test_every_buffer_has_the_bits_of_the_oracle(page, name, preset):
    assert_same_bits(page, small(name, preset=preset, **HARD))


def test_edges_on_samples_ties_of_depth_and_taps_beside_the_model(page, tmp_path):
    """Two cubes in one place; the outline of the face that is seen, and its diagonal, run through pixel centres."""
    positions, triangles = cube()
    scene = around(written(tmp_path / "twice.obj", positions, np.concatenate([triangles, triangles])), size=48)
    half_height = 12.5 / 24  # of the face, in halves of the picture; it stands 3.5 before the eye
    scene["camera"] |= {"azimuth": 0, "elevation": 0, "fov_y": 2 * math.degrees(math.atan(1 / (3.5 * half_height)))}
    far_taps = {"kernel": [[9.0, 0.0, 0.5, 0.3, 0.2]]}
    assert_same_bits(
        page, sss_ref.load_scene(scene | {"preset": "robust", "blur": far_taps}, **{"shadow_map.test": "slope"})
    )


def test_grazing_light(page, tmp_path):
    shadow_map = {"width": 24, "height": 24, "bias_slope": 0.1, "test": "slope"}
    scene = around(written(tmp_path / "sphere.obj", *sphere(16)), size=64, preset="robust", shadow_map=shadow_map)
    assert_same_bits(page, sss_ref.load_scene(scene))


@pytest.mark.parametrize(
    ("name", "overrides"),
    [
        ("default", {}),
        ("figure4_wax", {}),
        ("figure3_with", {}),
        ("teaching", {}),
        ("lesson_speckle", {}),
        ("lesson_halo", {}),
        ("teaching", HARD | {"lights.0.falloff": "inverse_square"}),
        ("teaching", HARD | {"camera.distance": 0.4, "camera.near": 0.01}),
    ],
    ids=[
        "two lights",
        "the printed figures",
        "a kernel in mm",
        "soft shadows",
        "literal test",
        "no mask",
        "falloff",
        "a mesh that leaves the view",
    ],
)
def test_what_the_page_does_not_draw_it_refuses(page, name, overrides):
    with pytest.raises(ValueError, match="expected"):
        page["render"](small(name, **overrides))


def test_the_page_writes_the_picture_that_the_oracle_saves(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", [str(PAGE), "teaching", "32"])
    runpy.run_path(str(PAGE), run_name="__main__")
    sizes = dict.fromkeys(("camera.width", "camera.height", "shadow_map.width", "shadow_map.height"), 32)
    folder = sss_ref.render(sss_ref.load_scene("teaching", **sizes, **HARD)).save("saved")
    assert Path("one_page.png").read_bytes() == (folder / "image.png").read_bytes()


def test_the_page_takes_no_more_of_the_package_than_it_says():
    nodes = ast.walk(ast.parse(PAGE.read_text()))
    names = {node.module if isinstance(node, ast.ImportFrom) else node.names[0].name for node in nodes if imports(node)}
    assert names - OF_THE_PACKAGE == {"numpy", "pathlib", "sys"}


def imports(node):
    return isinstance(node, ast.Import | ast.ImportFrom)


def test_the_page_stays_a_page():
    assert sum(bool(line.strip()) for line in PAGE.read_text().splitlines()) <= MOST_LINES
