"""The scene file that `sss-ref init` writes: it is complete, holds the mesh, and its picture is good at once."""

import math
import tomllib
from pathlib import Path

import numpy as np
import pytest
from bodies import body as mesh_of
from scenes import cube, sphere, wedge, written

import sss_ref
from sss_ref.errors import SceneError
from sss_ref.scene.first_scene import first_scene, front_of, write_first_scene

SMALL = {f"{table}.{side}": 48 for table in ("camera", "shadow_map") for side in ("width", "height")}
BUST = Path(__file__).parents[2] / "data" / "meshes" / "bust.glb"


def first(tmp_path, mesh):
    write_first_scene(str(mesh), tmp_path / "scene.toml", replace=True)
    return sss_ref.load_scene(tmp_path / "scene.toml", **SMALL)


def picture(scene):
    """Luminance of the covered pixels, and the coverage."""
    result = sss_ref.render(scene, interpreter="arrays")
    covered = result["coverage"] == 1
    return (result.image @ np.float32([0.2126, 0.7152, 0.0722]))[covered], covered


@pytest.mark.parametrize(
    "body", [cube, wedge, lambda: (np.array([(0, 0, 0), (9, 0, 0), (0, 2, 0)]), np.array([[0, 1, 2]]))]
)
@pytest.mark.parametrize("moved", [(0, 0, 0), (40, -7, 12)])
def test_the_mesh_is_whole_in_the_picture_and_nothing_is_warned_of(tmp_path, body, moved):
    positions, triangles = body()
    scene = first(tmp_path, written(tmp_path / "body.obj", positions + moved, triangles))
    assert scene.warnings == ()
    clip = np.c_[scene.mesh.positions, np.ones(len(scene.mesh.positions))] @ scene.camera.clip_from(np.eye(4)).T
    beside = np.abs(clip[:, :2] / clip[:, 3:]).max()
    assert 0.8 < beside < 0.95
    assert (np.abs(clip[:, 2]) < clip[:, 3]).all()


def test_the_picture_is_neither_dark_nor_clipped(tmp_path):
    light, _ = picture(first(tmp_path, BUST))
    assert 0.15 < np.median(light) < 0.5
    assert np.percentile(light, 99) < 1
    assert np.percentile(light, 2) > 0.03


@pytest.mark.parametrize(
    ("head_at", "azimuths"), [(0.9, (25, -20, 200)), (-0.3, (25, -20, 200)), (-0.9, (205, 160, 20))]
)
def test_it_is_seen_from_where_its_head_is(tmp_path, head_at, azimuths):
    """From +Z, unless the upper quarter lies towards -Z by more than a fifth of the depth; the lights go with it."""
    body, triangles, _ = sphere(12)
    head = body * 0.3 + (0, 2, head_at)
    whole = np.concatenate([body, head]), np.concatenate([triangles, triangles + len(body)])
    settings = first(tmp_path, written(tmp_path / "animal.obj", *whole)).settings
    written_as = tomllib.loads((tmp_path / "scene.toml").read_text())
    assert (written_as["camera"]["azimuth"], *(light["azimuth"] for light in written_as["lights"])) == azimuths
    assert settings.camera.azimuth == azimuths[0]


def test_light_from_behind_goes_round_and_shadows_are_soft(tmp_path):
    """Where light and shade meet there is no dark line; T falls off as steeply as its scale was chosen for."""
    settings = first(tmp_path, BUST).settings
    translucency = settings.translucency
    assert settings.shadow_map.test == "kernel"
    assert translucency.combine == "transmit_wrapped"
    assert translucency.scale == pytest.approx(0.05, rel=0.02)  # the bust is two units high


def test_the_picture_is_the_same_in_any_unit(tmp_path):
    """Blur and translucency know lengths; both are written for the size of the mesh, with three digits."""
    positions, triangles, _ = sphere(12)
    pictures = [
        picture(first(tmp_path, written(tmp_path / "body.obj", positions * unit, triangles)))
        for unit in (1, 0.01, 1000)
    ]
    for light, covered in pictures[1:]:
        assert (covered != pictures[0][1]).mean() < 0.01
        both = covered & pictures[0][1]
        assert np.abs(light[both[covered]] - pictures[0][0][both[pictures[0][1]]]).mean() < 0.005


def test_the_path_is_seen_from_the_scene_file_and_any_name_is_written(tmp_path, monkeypatch):
    (tmp_path / "meshes").mkdir()
    (tmp_path / "scenes").mkdir()
    name = 'a "head" \\ of\nits ow\x7fn é.obj'
    written(tmp_path / "meshes" / name, *cube())
    monkeypatch.chdir(tmp_path)
    write_first_scene(f"meshes/{name}", tmp_path / "scenes" / "a.toml", replace=False)
    data = tomllib.loads((tmp_path / "scenes" / "a.toml").read_text(encoding="utf-8"))
    assert data["mesh"]["path"] == f"../meshes/{name}"
    assert sss_ref.load_scene(tmp_path / "scenes" / "a.toml").mesh.name == name
    write_first_scene("tetrahedron", tmp_path / "scenes" / "b.toml", replace=False)
    assert tomllib.loads((tmp_path / "scenes" / "b.toml").read_text())["mesh"]["path"] == "tetrahedron"


def test_a_file_that_cannot_be_written(tmp_path):
    with pytest.raises(SceneError, match=r"a\.toml: expected a file that can be written, got No such file"):
        write_first_scene("tetrahedron", tmp_path / "nowhere" / "a.toml", replace=False)
    (tmp_path / "folder.toml").mkdir()
    with pytest.raises(
        SceneError, match=r"folder\.toml: expected a file that can be written, got Is a directory; choose another"
    ):
        write_first_scene("tetrahedron", tmp_path / "folder.toml", replace=True)


@pytest.mark.parametrize("name", ["tetrahedrn", ""])
def test_a_name_that_is_no_file_and_not_shipped(tmp_path, name):
    with pytest.raises(SceneError) as error:
        write_first_scene(name, tmp_path / "a.toml", replace=False)
    expected = "expected a mesh file or a shipped mesh's name, got neither; choose one (tetrahedron)"
    assert str(error.value) == f"{name or chr(34) * 2}: {expected}"
    assert not (tmp_path / "a.toml").exists()


@pytest.mark.parametrize("unit", [2e-12, 5e11])
def test_a_mesh_of_a_size_that_can_just_be_drawn(tmp_path, unit):
    positions, triangles = cube()
    body = written(tmp_path / "body.obj", positions / np.ptp(positions) * unit, triangles)
    light, _ = picture(first(tmp_path, body))
    assert 0.15 < np.median(light) < 1


@pytest.mark.parametrize(("unit", "side"), [(1e-30, "1e-30"), (1e30, "1e\\+30")])
def test_a_mesh_of_no_usual_size(tmp_path, unit, side):
    positions, triangles = cube()
    body = written(tmp_path / "body.obj", positions / np.ptp(positions) * unit, triangles)
    problem = (
        rf"body\.obj: expected a mesh whose longest side is 1e-12 to 1e\+12 units, got {side}; export it in another"
    )
    with pytest.raises(SceneError, match=problem):
        write_first_scene(str(body), tmp_path / "a.toml", replace=False)
    assert not (tmp_path / "a.toml").exists()


BOX = [(x, y, z) for x in (9.0, 11.0) for y in (-4.0, 4.0) for z in (-1.0, 2.0)]  # 2 x 8 x 3, around (10, 0, 0.5)


def distance_that_holds(points, azimuth):
    """How far away an eye 5 degrees above holds them with 12 % to spare, within 30 degrees; a loop over points."""
    turned, raised = math.radians(azimuth), math.radians(5)
    backward = np.array([math.cos(raised) * math.sin(turned), math.sin(raised), math.cos(raised) * math.cos(turned)])
    right = np.array([math.cos(turned), 0, -math.sin(turned)])
    up = np.cross(backward, right)
    halves = [max(abs(point @ right), abs(point @ up)) / math.tan(math.radians(15)) for point in points]
    return max(point @ backward + 1.12 * half for point, half in zip(points, halves, strict=True))


def test_every_number_of_a_file(tmp_path):
    """A box of 8 units, 250 mm: the scale of T is .05 on 2 units, and on 8 it is 4^.75 times that."""
    data = tomllib.loads(first_scene(mesh_of(BOX), "a/b.obj"))
    far = distance_that_holds(np.array(BOX) - (10, 0, 0.5), 25)
    distance, radius = float(f"{far:.3g}"), math.sqrt(1 + 16 + 1.5 * 1.5)
    near, beyond = ((far - radius) / 2, 2 * (far + radius))
    lamp = {"distance": distance}
    assert data == {
        "preset": "robust",
        "mm_per_unit": 31.2,
        "mesh": {"path": "a/b.obj", "color": [0.82, 0.52, 0.41]},
        "camera": {
            **{
                "type": "orbit",
                "target": [10, 0, 0.5],
                "azimuth": 25,
                "elevation": 5,
                "distance": distance,
                "fov_y": 30,
            },
            "near": float(f"{near:.3g}"),
            "far": float(f"{beyond:.3g}"),
        },
        "lights": [
            {"azimuth": -20, "elevation": 35, **lamp, "color": [1, 0.96, 0.92], "intensity": 0.85},
            {"azimuth": 200, "elevation": 20, **lamp, "color": [1, 0.45, 0.28], "intensity": 0.7},
        ],
        "phong": {"ambient": 0.04, "specular": 0.3},
        "translucency": {"combine": "transmit_wrapped", "exponent": 0.75, "d_min": 0.12, "scale": 0.141},
        "output": {"background": [0.012, 0.016, 0.022], "exposure": 0},
    }


def test_a_picture_over_uvs_is_offered_where_there_are_any():
    offer = "color = [0.82, 0.52, 0.41]              # linear RGB; or texture = a picture that lies over its UVs\n"
    bare, laid_out = (first_scene(mesh_of(BOX, uvs=uvs), "a") for uvs in (None, [(0, 0)] * 8))
    assert offer in laid_out and offer not in bare
    assert laid_out.replace("; or texture = a picture that lies over its UVs", "") == bare


@pytest.mark.parametrize(("depth", "front"), [(-5.0, 180), (-2.25, 180), (-2.0, 0), (0, 0), (5, 0)])
@pytest.mark.parametrize("moved", [(0, 0, 0), (1, -8, 16)])
def test_it_is_seen_from_behind_where_its_head_is_beyond_a_fifth_of_its_depth(depth, front, moved):
    points = np.array([(0, 0, -5), (0, 0, 5), (0, 8, depth)])
    assert front_of(mesh_of(points + moved)) == front


@pytest.mark.parametrize(("height", "front"), [(6, 0), (5.875, 180), (7, 0)])
def test_the_head_is_the_upper_quarter(height, front):
    """Of a height of 8 it is what is 6 or higher: then it reaches from -5 to 5."""
    assert front_of(mesh_of([(0, 0, -5), (0, 0, 5), (0, 8, -5), (0, height, 5)])) == front


def test_a_head_is_where_its_middle_is():
    """From -5 to 1 the middle is -2, on the border; from -5 to 0.9 it is beyond."""
    ends = [(0, 0, -5), (0, 0, 5), (0, 8, -5)]
    assert (front_of(mesh_of([*ends, (0, 7, 1)])), front_of(mesh_of([*ends, (0, 7, 0.9)]))) == (0, 180)


@pytest.mark.parametrize(("side", "drawn"), [(2.0**-39, True), (2.0**39, True), (9e-13, False), (1.1e12, False)])
def test_sides_that_can_be_drawn(side, drawn):
    mesh = mesh_of([(0, 0, 0), (side, 0, 0), (0, side, 0)])
    if drawn:
        assert tomllib.loads(first_scene(mesh, "a"))["camera"]["fov_y"] == 30
    else:
        with pytest.raises(
            SceneError, match=r"body\.obj: expected a mesh whose longest side is 1e-12 to 1e\+12 units, got"
        ):
            first_scene(mesh, "a")


@pytest.mark.parametrize(("low", "drawn"), [(-4096.0, True), (-4097.0, False)])
def test_the_longest_side_that_is_drawn_is_a_million_millions(low, drawn):
    mesh = mesh_of([(low, 0, 0), (999999995904.0, 0, 0), (0, 1, 0)])
    if drawn:
        assert "[camera]" in first_scene(mesh, "a")
    else:
        with pytest.raises(SceneError, match="expected a mesh whose longest side is"):
            first_scene(mesh, "a")


def test_a_file_that_is_there_is_kept_unless_it_may_go(tmp_path):
    target = tmp_path / "a.toml"
    write_first_scene("tetrahedron", target, replace=False)
    first = target.read_text()
    target.write_text("mine")
    with pytest.raises(
        SceneError, match=r"a\.toml: expected a new file, got one that is there; choose another with -o, or"
    ):
        write_first_scene("tetrahedron", target, replace=False)
    assert target.read_text() == "mine"
    write_first_scene("tetrahedron", target, replace=True)
    assert target.read_text() == first


@pytest.mark.parametrize(("name", "came"), [("a.txt", ".txt"), ("a", "none")])
def test_a_scene_file_ends_in_toml(tmp_path, name, came):
    with pytest.raises(SceneError, match=rf"{name}: expected a file name that ends in \.toml, got {came}; add it"):
        write_first_scene("tetrahedron", tmp_path / name, replace=True)
