"""A scene as its paths meet it: its triangles, lights, camera and material."""

from dataclasses import replace

import numpy as np
import pytest
from boxes import looking_down, parallel_light, write_box

from sss_ref.scene.load import load_scene
from sss_ref.truth.photon import Volume
from sss_ref.truth.tracing import Tracing

MEDIUM = Volume(2.0, 0.5, 0.3, 1.4), Volume(3.0, 0.25), Volume(1.0, 1.0)


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return write_box(tmp_path_factory.mktemp("box") / "box.obj", (-1.0, -2.0, -3.0), (1.0, 2.0, 3.0))


def traced(box, lights=None, border="matched", **keys):
    scene = looking_down(box, lights or [parallel_light((0.0, 0.6, 0.8))], **{"mm_per_unit": 4.0, **keys})
    return Tracing(load_scene(scene), MEDIUM, border)


def test_lights_are_places_or_directions_with_their_power(box):
    lights = [
        {**parallel_light((0.0, 0.6, 0.8), 2.0), "color": [1.0, 0.5, 0.25]},
        {"position": [1.0, 2.0, 9.0], "falloff": "inverse_square", "intensity": 3.0},
        {"position": [1.0, 2.0, 9.0], "falloff": "none"},
    ]
    found = traced(box, lights).scenery.lights
    assert found.place == pytest.approx(np.array([(0, 0.6, 0.8), (1, 2, 9), (1, 2, 9)]), abs=1e-12)
    assert (found.parallel.tolist(), found.fades.tolist()) == ([True, False, False], [False, True, False])
    assert found.power.tolist() == [[2, 1, 0.5], [3, 3, 3], [1, 1, 1]]


@pytest.mark.parametrize(
    ("border", "flags"), [("matched", (True, False)), ("diffuse", (False, True)), ("entered", (False, False))]
)
def test_what_a_border_does(box, border, flags):
    found = traced(box, border=border).scenery
    assert (found.is_matched, found.is_dimmed) == flags


def test_the_material_is_per_scene_unit(box):
    assert traced(box).volumes_per_unit == (Volume(8, 2, 0.3, 1.4), Volume(12, 1), Volume(4, 4))
    unit = looking_down(box, [parallel_light((0.0, 0.6, 0.8))])
    del unit["mm_per_unit"]
    assert Tracing(load_scene(unit), MEDIUM).volumes_per_unit == MEDIUM


def test_a_camera_without_perspective(box):
    """At distance 1, and at any other, its picture is 3 x 2 units."""
    camera = {"type": "orthographic", "eye": [0, 0, 50.0], "view_height": 2.0, "width": 6, "height": 4}
    eye = traced(box, camera=camera).eye
    assert (eye.is_parallel, eye.width, eye.height, eye.spread) == (True, 6, 4, 0)
    vectors = [each.tolist() for each in (eye.origin, eye.ahead, eye.across, eye.up)]
    assert vectors == [[0, 0, 50], [0, 0, -1], [1.5, 0, 0], [0, 1, 0]]


def test_a_camera_with_perspective(box):
    camera = {"type": "look_at", "eye": [0, 0, 50.0], "fov_y": 90.0, "width": 6, "height": 4}
    eye = traced(box, camera=camera).eye
    assert not eye.is_parallel
    assert (eye.across, eye.up) == (pytest.approx([1.5, 0, 0]), pytest.approx([0, 1, 0]))
    assert replace(traced(box), across_pixel=True).eye.spread == 1


def test_triangles_without_an_area_are_left_out_and_all_turn_outwards(box, tmp_path):
    tree = traced(box).scenery.tree
    assert len(tree.corner) == 12
    lines = box.read_text().splitlines()
    turned = [f"f {' '.join(reversed(line.split()[1:]))}" if line.startswith("f") else line for line in lines]
    for name, extra in (("turned.obj", []), ("flat.obj", ["f 1//1 2//1 1//1"])):
        (tmp_path / name).write_text("\n".join((turned if name == "turned.obj" else lines) + extra))
        found = traced(tmp_path / name).scenery.tree
        assert len(found.corner) == 12
        assert ((found.corner * np.cross(found.edge1, found.edge2)).sum(axis=1) > 0).all()


def test_all_that_decides_a_radiance_is_in_the_identity(box):
    """As it has been since the sums of a folder have one."""
    one = traced(box)
    others = [
        traced(box, lights=[parallel_light((0.0, 0.8, 0.6))]),
        replace(one, volumes=MEDIUM[::-1]),
        replace(one, border="entered"),
        replace(one, across_pixel=True),
        replace(one, seed=1),
    ]
    assert len({each.identity for each in (one, *others)}) == 6
    assert traced(box).identity == one.identity and len(one.identity) == 64
