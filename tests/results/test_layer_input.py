"""The mesh of a layer as an input of a recorded rendering."""

import pytest
from scenes import around, cube, written

from sss_ref.rendering.fold import render
from sss_ref.results.folder import save
from sss_ref.results.manifest import read_manifest
from sss_ref.results.verify import verify
from sss_ref.scene.load import load_scene


@pytest.fixture
def result(tmp_path):
    """A result whose meshes lie beside it."""
    positions, triangles = cube()
    paths = [written(tmp_path / f"{name}.obj", positions * size, triangles) for name, size in (("a", 1), ("b", 0.5))]
    layers = [{"path": paths[1], "extinction_per_mm": [1, 2, 3]}]
    return save(render(load_scene(around(paths[0], 16, layers=layers)), keep="final"), tmp_path / "out")


def test_recorded_and_verified(result):
    manifest = read_manifest(result)
    assert manifest.scene.other_files == {"layers.0.path": str(result.parent / "b.obj")}
    assert "inner_positions" in manifest.inputs and verify(result).equal


def test_found_beside_the_result(result):
    new = result.parent / "new"
    new.mkdir()
    for name in ("out", "a.obj", "b.obj"):
        (result.parent / name).rename(new / name)
    assert verify(new / "out").equal


def test_another_mesh_is_another_input(result):
    path = result.parent / "b.obj"
    path.write_text(path.read_text().replace("0.5", "0.25"))
    found = verify(result)
    assert not found.equal and found.message.startswith("input differs: inner_positions")
