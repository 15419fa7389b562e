"""Warnings of scenes that show nothing, each with the number that mends it; none for scenes that are right."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from bodies import body
from scenes import around, cube, sphere, written

from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.surprises import _far_light, _is_far, surprises_inside
from sss_ref.view.light_fit import Bounds


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("bodies")


@pytest.fixture(scope="module")
def ball(folder):
    return ball_of(folder, "ball")


def ball_of(folder, name, radius=1.0, centre=(0, 0, 0)):
    positions, triangles, _ = sphere(8)
    return written(folder / f"{name}.obj", positions * radius + centre, triangles)


def seen_from(path, eye, light, **tables):
    camera = {"type": "look_at", "eye": eye, "width": 32, "height": 32}
    return {**around(path, size=32), "camera": camera, "lights": [{"position": light}], **tables}


def warned(scene, **overrides):
    """The only warning of a scene."""
    (line,) = load_scene(scene, **overrides).warnings
    return line


def covered(scene, **overrides):
    loaded = load_scene(scene, **overrides)
    return loaded.warnings, int(render(loaded, interpreter="arrays", keep="coverage")["coverage"].sum())


@pytest.mark.parametrize(
    "path",
    [
        "spot/spot_triangulated.obj",
        "blub/blub_triangulated.obj",
        "bunny/bunny_hr.obj",
        "ict_face/generic_neutral_mesh.obj",
    ],
)
def test_real_meshes_well_framed_are_drawn_without_a_word(path, asset):
    file = asset(path)
    mesh = load_mesh(file)
    bounds = Bounds.around(mesh.positions.astype(float))
    eye, light = (bounds.centre + 4 * bounds.radius * np.array(way) for way in ((0, 0, 1), (0.6, 0.6, 0.5)))
    camera = {"type": "look_at", "eye": eye.tolist(), "target": bounds.centre.tolist()}
    camera |= {"near": bounds.radius, "far": 10 * bounds.radius}
    scene = load_scene({"mesh": {"path": str(file)}, "camera": camera, "lights": [{"position": light.tolist()}]})
    assert scene.warnings == tuple(f"mesh: {note}" for note in mesh.notes)


def test_mesh_beyond_far(folder):
    scene = seen_from(ball_of(folder, "mm", 100), [0, 0, 400], [300, 200, 400])
    assert warned(scene) == "camera: the whole mesh lies beyond far = 100, from 300 on; set camera.far = 550"
    assert covered(scene)[1] == 0 and covered(scene, **{"camera.far": 550})[0] == ()
    assert covered(scene, **{"camera.far": 550})[1] > 100


def test_mesh_before_near(folder):
    scene = seen_from(ball_of(folder, "m", 0.01), [0, 0, 0.04], [0.03, 0.02, 0.04])
    assert warned(scene) == "camera: the whole mesh lies before near = 0.1, up to 0.05; set camera.near = 0.027"
    mended = covered(scene, **{"camera.near": 0.027})
    assert covered(scene)[1] == 0 and mended[0] == () and mended[1] > 100


def test_a_far_plane_that_cuts_shows_something(ball):
    assert load_scene(seen_from(ball, [0, 0, 4], [3, 2, 4]), **{"camera.far": 4.0}).warnings == ()


@pytest.mark.parametrize(
    "camera, line",
    [
        (
            {"type": "look_at", "eye": [0, 0, 4], "target": [0, 0, 9]},
            "camera: the whole mesh is behind it; set camera.target = [0, 0, 0]",
        ),
        (
            {"type": "look_at", "eye": [0, 0, 4], "target": [9, 0, 0]},
            "camera: the whole mesh is beside its picture; set camera.target = [0, 0, 0]",
        ),
        (
            {"type": "look_at", "eye": [0, 0, 4], "target": [0, 9, 0]},
            "camera: the whole mesh is beside its picture; set camera.target = [0, 0, 0]",
        ),
        (
            {"type": "free", "position": [4, 4, 0], "yaw": -90},
            "camera: the whole mesh is behind it; set camera.yaw = 90 and camera.pitch = -45",
        ),
    ],
)
def test_camera_looking_away(ball, camera, line):
    size = {"width": 32, "height": 32}
    scene = {**seen_from(ball, [0, 0, 4], [3, 2, 4]), "camera": camera | size}
    assert warned(scene) == line and covered(scene)[1] == 0
    keys = line.partition("; set ")[2].split(" and ")
    mended = {key: json.loads(value) for key, value in (each.split(" = ") for each in keys)}
    assert covered(scene, **mended)[0] == () and covered(scene, **mended)[1] > 50


def test_mesh_of_a_few_pixels(ball):
    scene = seen_from(ball, [0, 0, 90], [3, 2, 4])
    assert warned(scene) == ("camera: the mesh is 0.86 of its 32 x 32 pixels wide; set camera.fov_y = 1.34")
    assert covered(scene, **{"camera.fov_y": 1.34})[1] > 400


def test_light_too_far(ball):
    scene = seen_from(ball, [0, 0, 4], [0, 0, 1e7])
    assert warned(scene) == (
        "lights[0]: it is 1e+07 away, where float32 distances are 1 apart, and the mesh is 2 thick; "
        "set lights.0.position = [0, 0, 1000]: from there its rays are as good as parallel"
    )
    assert load_scene(scene, **{"lights.0.position": [0, 0, 1000]}).warnings == ()
    dimmer = warned(scene, **{"lights.0.falloff": "inverse_square", "lights.0.intensity": 1e14})
    assert "set lights.0.position = [0, 0, 1000] and lights.0.intensity = 1e+06: " in dimmer


@pytest.mark.parametrize("distance, told", [(16000.0, False), (17000.0, False), (32760.0, False), (33000.0, True)])
def test_a_light_is_too_far_where_float32_spacing_reaches_a_thousandth_of_the_mesh(ball, distance, told):
    """Numbers from 16384 to 32768 are 2^-9 = 0.00195 apart, just below a thousandth of the diameter 2; then 2^-8."""
    assert bool(load_scene(seen_from(ball, [0, 0, 4], [0, 0, distance])).warnings) == told


def test_thickness_from_a_light_that_is_not_warned_of(ball):
    """It is right to a thousandth of the mesh at the largest spacing without a warning, and not at the next."""
    near, far, too_far = (
        render(load_scene(seen_from(ball, [0, 0, -4], [0, 0, z])), interpreter="arrays")["thickness"]
        for z in (1000.0, 32000.0, 64000.0)
    )
    assert np.abs(far - near).max() < 0.002 < np.abs(too_far - near).max()


def test_map_coordinates_brought_back(folder):
    path = ball_of(folder, "far", 1, (500000, 800000, 0))
    scene = seen_from(path, [0, 0, 4], [3, 2, 4], mesh={"path": path, "translate": [-500000.0, -800000.0, 0.0]})
    line = warned(scene)
    assert line.startswith(
        "mesh: in its file it is more than 100 radii from the origin, where float32 positions are 0.062"
    )
    assert line.endswith("comes too late, subtract [500000, 800000, 0] from the positions in the file")


def test_triangles_without_area(folder):
    positions, triangles = np.outer(range(4), np.ones(3)), np.array([(0, 1, 2), (1, 2, 3)])
    scene = seen_from(written(folder / "line.obj", positions, triangles), [0, 0, 9], [3, 2, 9])
    assert warned(scene) == "mesh: none of its 2 triangles has an area, so none is drawn; export the mesh again"
    positions[3, 2] += 1e-3  # one sliver is enough
    sliver = written(folder / "sliver.obj", positions, triangles)
    assert load_scene(seen_from(sliver, [0, 0, 9], [3, 2, 9])).warnings == ()


def test_a_flattened_mesh(folder):
    positions, triangles, _ = sphere(8)
    scene = seen_from(written(folder / "flat.obj", positions * (1, 0, 0), triangles), [0, 0, 9], [3, 2, 9])
    assert warned(scene).endswith("so none is drawn; give back the coordinate that is the same for all")


def test_shadow_map_that_looks_away(folder):
    scene = around(written(folder / "cube.obj", *cube()), size=32)
    away = {"position": [0.0, 0.0, 5.0], "target": [0, 0, 9], "fov_y": 40, "near": 1, "far": 9}
    assert warned({**scene, "lights": [away]}) == (
        "lights[0]: of its shadow map: the whole mesh is behind it; set lights.0.target = [0, 0, 0], "
        "or leave target, fov_y, near and far to be fitted"
    )
    wide = {"position": [0.0, 0.0, 2.5], "fov_y": 179.9}
    assert (
        "lights[0]: of its shadow map: the mesh is 0.019 of its 32 x 32 pixels wide; set lights.0.fov_y = 93.3"
        in warned({**scene, "lights": [wide]})
    )


@pytest.mark.parametrize(
    ("key", "value", "asking"),
    [
        ("blur.unit", "mm", 'blur.unit = "mm"'),
        ("translucency.form", "gaussians", 'translucency.form = "gaussians"'),
        ("layers", [{"path": "tetrahedron", "extinction_per_mm": [1, 1, 1]}], "layers"),
    ],
)
def test_millimetres_without_a_unit(ball, key, value, asking):
    scene = seen_from(ball, [0, 0, 4], [3, 3, 3], preset="robust")
    expected = f"mm_per_unit: it is not given, so for {asking} a unit is 1 mm; set mm_per_unit"
    assert load_scene(scene, **{key: value}).warnings[0] == expected
    assert not any("mm_per_unit" in line for line in load_scene(scene, **{key: value, "mm_per_unit": 1.0}).warnings)
    assert load_scene(scene).warnings == ()


AROUND = Bounds(np.array([-3.0, -2, -1]), np.array([5.0, 6, 7]), np.array([1.0, 2, 3]), 4.0)


@pytest.mark.parametrize(
    ("falloff", "fainter"),
    [("none", ""), ("inverse_square", " and lights.1.intensity = 0.0305")],
)
def test_a_light_too_far_from_a_large_mesh_that_lies_aside(falloff, fainter):
    """A radius of 4: it comes to 4000 from the centre, by 4000/131072, and 32.8 times the square of that is 0.0305."""
    light = SimpleNamespace(position=AROUND.centre + np.array([0, 0, 131072.0]), falloff=falloff, intensity=32.8)
    (line,) = _far_light(AROUND, light, "lights.1")
    assert line == (
        "it is 1.31e+05 away, where float32 distances are 0.016 apart, and the mesh is 8 thick; "
        f"set lights.1.position = [1, 2, 4003]{fainter}: from there its rays are as good as parallel"
    )


@pytest.mark.parametrize(
    ("distance", "radius", "told"),
    [(2.0**16, 4.0, False), (2.0**17, 4.0, True), (2.0**17, 8.0, False), (2.0**16, 3.90625, False)],
)
def test_a_spacing_of_a_thousandth_of_the_diameter_is_too_coarse(distance, radius, told):
    """From 2^16 on numbers are 2^-7 = 0.0078 apart, from 2^17 on 0.0156; the mesh is 8 or 16 thick."""
    bounds = Bounds(AROUND.low, AROUND.high, AROUND.centre, radius)
    light = SimpleNamespace(position=AROUND.centre + np.array([distance, 0, 0]), falloff="none", intensity=1.0)
    assert bool([*_far_light(bounds, light, "lights.0")]) == told


@pytest.mark.parametrize(("away", "is_far"), [(400.0, False), (400.5, True), (-401.0, True)])
def test_far_from_the_origin_is_a_hundred_radii(away, is_far):
    assert _is_far(Bounds(AROUND.low, AROUND.high, np.array([0, away, 0]), 4.0)) == is_far


@pytest.mark.parametrize("out", [0, 1, 2])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_layer_reaches_out_where_one_of_its_corners_does(out, sign):
    outer = PlacedMesh(body([(-1, -1, -1), (1, 1, 1), (1, -1, 1)]), np.eye(4))
    corners = np.array([(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5), (0.5, -0.5, 0.5)])
    assert [*surprises_inside(outer, PlacedMesh(body(corners), np.eye(4)))] == []
    corners[(sign + 1) // 2, out] = 1.5 * sign
    assert [*surprises_inside(outer, PlacedMesh(body(corners), np.eye(4)))] == [
        "layers[0]: it reaches out of the mesh, and beside that is not seen; give one that lies inside"
    ]
