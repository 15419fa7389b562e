"""The scene file that `sss-ref init` writes: it is complete, holds the mesh, and its picture is good at once."""

import tomllib
from pathlib import Path

import numpy as np
import pytest
from scenes import cube, sphere, wedge, written

import sss_ref
from sss_ref.errors import SceneError
from sss_ref.scene.first_scene import write_first_scene

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
    with pytest.raises(SceneError, match=r"a\.toml: expected a file to write, got No such file or directory; choose"):
        write_first_scene("tetrahedron", tmp_path / "nowhere" / "a.toml", replace=False)
    (tmp_path / "folder.toml").mkdir()
    with pytest.raises(SceneError, match=r"folder\.toml: expected a file to write, got Is a directory; choose another"):
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
