from pathlib import Path

import pytest

from sss_ref.errors import SceneError
from sss_ref.scene import load_scene, mesh_names, mesh_path, scene_names, scene_path
from sss_ref.scene_file import shipped


def test_names_and_paths(data_folder):
    (data_folder / "meshes" / "README.md").write_text("not a mesh")
    assert (scene_names(), mesh_names()) == (("small",), ("tetrahedron",))
    assert scene_path("small") == data_folder / "scenes" / "small.toml"
    assert mesh_path("tetrahedron") == data_folder / "meshes" / "tetrahedron.obj"


@pytest.mark.parametrize("find, known", [(scene_path, "scene (small)"), (mesh_path, "mesh (tetrahedron)")])
def test_unknown_name(find, known):
    with pytest.raises(SceneError) as error:
        find("../large")
    assert str(error.value) == f"../large: expected a shipped {known}, got another name"


def test_scene_by_name():
    scene = load_scene("small")
    assert (scene.source, scene.mesh.name, len(scene.mesh.triangles)) == ("small", "tetrahedron.obj", 4)


def test_a_file_beside_the_scene_comes_before_a_shipped_mesh(tmp_path, data_folder):
    (tmp_path / "tetrahedron").mkdir()  # a folder is no mesh
    assert shipped.find_mesh("tetrahedron", tmp_path) == data_folder / "meshes" / "tetrahedron.obj"
    (tmp_path / "other.obj").write_text("")
    assert shipped.find_mesh("other.obj", tmp_path) == tmp_path / "other.obj"
    assert shipped.find_mesh("x" * 5000, tmp_path) is None and shipped.find_mesh("a\0b", tmp_path) is None


def test_a_mesh_given_to_a_command(tmp_path, data_folder, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert shipped.given_mesh("tetrahedron") == data_folder / "meshes" / "tetrahedron.obj"
    for left_to_the_reader in ("none.obj", "."):
        assert shipped.given_mesh(left_to_the_reader) == Path(left_to_the_reader)
    for name, shown in {"tetrahedrn": "tetrahedrn", "x" * 5000: "x" * 5000, "a\0b": r"a\x00b"}.items():
        with pytest.raises(SceneError) as error:
            shipped.given_mesh(name)
        expected = "expected a mesh file or a shipped mesh's name, got neither; choose one (tetrahedron)"
        assert str(error.value) == f"{shown}: {expected}"
