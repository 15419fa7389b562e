"""Regions of bodies whose geometry is known: a sphere, a cube, a thin plate, and one that casts a shadow."""

from types import SimpleNamespace

import numpy as np
import pytest
from boxes import looking_down, parallel_light, shaded_plate, write_box

from sss_ref.scene.load import load_scene
from sss_ref.truth.media import volumes
from sss_ref.yardstick.regions import SAID, Regions, _grown

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


def of_a_row(places, unit=1.0, uv=None, upright=False, **light):
    """Regions of pixels beside each other, or above: x of the points that they show, and of the one light what is said.

    unit: a unit's length in diffusion lengths. cosine, reached, way: of every pixel; way in diffusion lengths.
    """
    found = Regions(SimpleNamespace(settings=None), SKIN)
    found.scene.settings = SimpleNamespace(mm_per_unit=found.length * unit)
    shape = (len(places), 1) if upright else (1, len(places))
    points = np.zeros((*shape, 3), np.float32)
    points[..., 0] = np.reshape(places, shape)
    buffers = {"coverage": np.ones(shape, np.uint8), "position_world": points}
    if uv is not None:
        buffers["uv"] = np.stack([np.reshape(uv, shape), np.zeros(shape)], axis=-1)
    lit = {"cosine": 1.0, "reached": True, "way": 0.0, **light}
    way = np.broadcast_to(lit["way"] * found.length, shape)
    lights = [(np.broadcast_to(lit["cosine"], shape), np.broadcast_to(lit["reached"], shape), way)]
    found.__dict__.update(_buffers=buffers, _lights=lights)
    return found


@pytest.mark.parametrize(
    ("cosine", "reached", "way", "region"),
    [
        (0.25, True, 0.0, "terminator"),
        (0.26, True, 0.0, "lit"),
        (0.26, False, 1.0, "dark"),
        (-0.25, False, 1.0, "terminator"),
        (-0.26, False, 2.0, "thin"),
        (-0.26, False, 2.01, "dark"),
        (-0.26, False, 0.01, "thin"),
        (-0.26, False, 0.0, "dark"),
    ],
)
def test_which_light_makes_which_region(cosine, reached, way, region):
    found = of_a_row([0, 1], cosine=cosine, reached=reached, way=way)
    assert {name: mask.sum() for name, mask in found.masks.items()} == {"everywhere": 2, region: 2}


@pytest.mark.parametrize("upright", [False, True])
@pytest.mark.parametrize(("gap", "at"), [(4, []), (4.01, [2, 3, 4, 5])])
def test_what_is_four_steps_apart_is_one_surface_and_what_is_farther_another(upright, gap, at):
    """Both pixels beside the gap, and those within a diffusion length, here a step."""
    places = [0, 1, 2, 3, 3 + gap, 4 + gap, 5 + gap, 6 + gap]
    found = of_a_row(places, upright=upright)
    assert np.flatnonzero(found._silhouette).tolist() == at


@pytest.mark.parametrize(("unit", "reach"), [(2.1, 1), (0.7, 1), (0.6, 2), (0.2, 5), (0.1, 8), (0.125, 8), (0.14, 7)])
def test_a_diffusion_length_in_pixels(unit, reach):
    assert of_a_row([0, 1, 2], unit).reach == reach


@pytest.mark.parametrize("upright", [False, True])
@pytest.mark.parametrize(("jump", "at"), [(0.625, []), (0.75, [3, 4])])
def test_texture_coordinates_that_change_five_times_as_fast_have_a_seam(upright, jump, at):
    uv = [0.125 * k + (jump - 0.125) * (k > 3) for k in range(8)]
    found = of_a_row(range(8), uv=uv, upright=upright)
    assert np.flatnonzero(found._seam).tolist() == at
    assert not of_a_row(range(8))._seam.any()


def test_the_edge_of_a_shadow_reaches_a_diffusion_length_to_both_sides():
    found = of_a_row(range(8), reached=np.arange(8) < 4)
    assert np.flatnonzero(found.masks["shadow edge"]).tolist() == [3, 4]
    grazed = of_a_row(range(8), reached=np.arange(8) < 4, cosine=0.25)
    assert "shadow edge" not in grazed.masks


def of_lights(*lights, covered=True):
    """Regions of pixels in a row: of each light N.L, whether it reaches them, and its way in diffusion lengths."""
    found = of_row_of(len(lights[0][0]))
    found._buffers["coverage"] = np.broadcast_to(np.uint8(covered), found._buffers["coverage"].shape)
    known = [
        (np.array([cosine], float), np.array([reached], bool), np.array([way], float) * found.length)
        for cosine, reached, way in lights
    ]
    found.__dict__["_lights"] = known
    return {name: np.flatnonzero(mask).tolist() for name, mask in found.masks.items()}


def of_row_of(count):
    return of_a_row(range(count))


def test_what_one_of_two_lights_does_is_done():
    """Two pixels face both or one of them, through two the light comes from behind, near enough or not."""
    one = [0.9, 0.9, -0.9, -0.9, 0.1], [1, 1, 0, 0, 1], [0, 0, 1, 5, 0]
    two = [0.9, -0.9, -0.9, -0.9, 0.9], [1, 0, 0, 0, 1], [0, 9, 5, 5, 0]
    assert of_lights(one, two) == {
        "everywhere": [0, 1, 2, 3, 4],
        "lit": [0, 1],
        "terminator": [4],
        "thin": [2],
        "dark": [3],
    }


def test_what_is_lit_at_all_is_not_thin():
    behind, ahead = ([-0.9] * 3, [0] * 3, [1] * 3), ([0.2, 0.3, -0.9], [1, 1, 0], [0, 0, 9])
    assert of_lights(behind, ahead) == {"everywhere": [0, 1, 2], "lit": [1], "terminator": [0], "thin": [2]}


def test_nothing_is_in_a_region_that_is_not_covered():
    assert of_lights(([0.9] * 2, [1] * 2, [0] * 2), covered=False) == {}


def test_a_body_of_one_pixel():
    """No neighbour says how far a step is: it counts as one unit."""
    assert of_a_row([0], unit=0.25).reach == 4
    assert of_a_row([0], uv=[0.5]).masks.keys() == {"everywhere", "lit"}


def test_the_usual_step_is_the_lower_quartile():
    """Of steps of 1, 1, 2, 2 and 8: 1; so 8 is another surface, and 4 is not."""
    assert of_a_row([0, 1, 2, 4, 6, 14], unit=0.5).reach == 2
    assert np.flatnonzero(of_a_row([0, 1, 2, 4, 6, 14])._silhouette).tolist() == [3, 4, 5]


def test_what_grows_grows_to_the_diagonals():
    """Of a pixel in the corner of 3 x 4, one and two steps."""
    mask = np.zeros((3, 4), bool)
    mask[0, 0] = True
    assert np.argwhere(_grown(mask, 0)).tolist() == [[0, 0]]
    assert np.argwhere(_grown(mask, 1)).tolist() == [[0, 0], [0, 1], [1, 0], [1, 1]]
    assert _grown(mask, 2).tolist() == [[True] * 3 + [False]] * 3


def test_a_texture_that_changes_as_fast_everywhere_has_no_seam():
    """However far pixels are apart, and where it does not change at all."""
    places = np.cumsum([0, 0.1, 0.1, 0.1, 0.39, 0.1, 0.1])
    assert not of_a_row(places, uv=places * [1, 1, 1, 1, 1.2, 1, 1])._seam.any()
    assert not of_a_row(range(8), uv=[0, 0, 0, 0, 0, 1, 2, 3])._seam.any()
    assert not of_a_row(range(3), uv=[0.5] * 3)._seam.any()


def test_pixels_four_steps_apart_have_a_seam_between_them():
    """Five times as fast; beyond four steps another surface begins, which is no seam."""
    for gap, at in ((4, [3, 4]), (4.01, [])):
        places = [0, 1, 2, 3, 3 + gap, 4 + gap, 5 + gap]
        uv = [0, 0.125, 0.25, 0.375, 0.375 + 3.0, 3.5, 3.625]
        assert np.flatnonzero(of_a_row(places, uv=uv)._seam).tolist() == at
