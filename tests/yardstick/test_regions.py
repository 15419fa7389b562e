"""Regions of bodies whose geometry is known: a sphere, a cube, a thin plate, and one that casts a shadow."""

import numpy as np
import pytest
from boxes import looking_down, parallel_light, shaded_plate, write_box

from sss_ref.scene.load import load_scene
from sss_ref.truth.media import volumes
from sss_ref.yardstick.regions import SAID, Regions

SKIN = volumes("skin2")
LOOK = {"shadow_map.test": "slope", "preset": "robust", "camera.width": 48, "camera.height": 48}


def regions(scene, unit=10.0, **more):
    return Regions(load_scene(scene, **{**LOOK, "mm_per_unit": unit, **more}), SKIN)


@pytest.fixture(scope="module")
def sphere():
    return regions("sphere", 60.0)


def test_of_the_sphere(sphere):
    """Its normals are its points; the light is at (3.2, 2.2, -0.4)."""
    points = sphere._buffers["position_world"].astype(np.float64)
    towards = np.array([3.2, 2.2, -0.4]) - points
    cosine = (points * towards).sum(axis=-1) / np.linalg.norm(towards, axis=-1)
    masks = sphere.masks
    inside = sphere.covered & (abs(abs(cosine) - 0.25) > 0.02)  # its triangles are flat
    assert (masks["terminator"][inside] == (np.abs(cosine) < 0.25)[inside]).all()
    assert (cosine[masks["lit"]] > 0.23).all() and (cosine[masks["dark"]] < -0.23).all()
    assert "shadow edge" not in masks and masks["lit"].any() and masks["dark"].any()


def test_every_pixel_of_the_body_is_somewhere_and_none_beside_it(sphere):
    apart = [mask for name, mask in sphere.masks.items() if name != "everywhere"]
    assert (np.logical_or.reduce(apart) == sphere.masks["everywhere"]).all()
    assert list(sphere.masks) == [name for name in SAID if name in sphere.masks]


def test_the_silhouette_is_as_wide_as_light_goes(sphere):
    """In mm: where a unit is longer, fewer pixels."""
    wide = regions("sphere", 10.0)
    assert wide.reach > sphere.reach == 1
    assert wide.masks["silhouette"].sum() > 2 * sphere.masks["silhouette"].sum()


def test_a_cubes_seams_are_where_its_faces_meet():
    found = regions("lesson_seam")
    normals = found._buffers["normal_world"]
    turns = (np.abs(np.diff(normals, axis=1)).sum(axis=-1) > 0.5) & found.covered[:, 1:] & found.covered[:, :-1]
    assert turns.sum() > 10
    assert found.masks["seam"][:, 1:][turns].all()
    assert found.masks["seam"].sum() < 0.4 * found.covered.sum()


def test_a_plate_lit_from_behind_is_thin_and_a_thick_one_dark(tmp_path):
    light = [parallel_light((0.3, 0.0, -0.954))]
    for thickness, name, other in ((3.0, "thin", "dark"), (30.0, "dark", "thin")):
        plate = write_box(tmp_path / f"{name}.obj", (-30, -30, -thickness), (30, 30, 0))
        found = regions(looking_down(plate, light, view_height=40.0), 1.0)
        assert found.masks[name].all() and other not in found.masks


def test_a_plate_that_light_grazes_from_behind_is_terminator_alone(tmp_path):
    """N.L is -.2, and light goes 1 mm through it."""
    plate = write_box(tmp_path / "plate.obj", (-30, -30, -0.2), (30, 30, 0))
    found = regions(looking_down(plate, [parallel_light((0.98, 0.0, -0.2))], view_height=40.0), 1.0)
    assert found.masks["terminator"].all() and "thin" not in found.masks and found.length > 0.5


def test_a_shadow_has_an_edge(tmp_path):
    found = regions(shaded_plate(tmp_path / "plates.obj"), 1.0)
    across = found._buffers["position_world"][..., 0]
    edge = found.masks["shadow edge"]
    assert edge.any() and np.abs(across[edge] - 16.0).max() < found.length + 2 * 40 / 48
