"""A bundle alone is enough to draw the scene, bit for bit as with the package."""

import json

import numpy as np
import pytest
import trimesh
from bundle_player import Player
from opengl import needs_mesa

from sss_ref.bundle.writing import write_bundle
from sss_ref.cli import main
from sss_ref.errors import DumpError
from sss_ref.gl import draw
from sss_ref.gl.context import open_context
from sss_ref.scene.load import load_scene

SMALL = {f"{t}.{s}": 64 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}


@needs_mesa
@pytest.mark.parametrize("name", ["figure3_with", "figure5", "figure4_wax", "default", "lesson_halo", "figure2"])
def test_the_bundle_alone_gives_the_same_buffers(name, tmp_path):
    scene = load_scene(name, **SMALL)
    folder = write_bundle(scene, tmp_path / "bundle")
    expected = draw(scene)
    context = open_context()
    try:
        played = Player(context, folder).play()
    finally:
        context.release()
    assert set(played) == set(expected)
    for buffer, values in expected.items():
        assert played[buffer].tobytes() == values.tobytes(), buffer


def test_the_files_of_a_bundle(tmp_path, capsys):
    assert main(["bundle", "figure5", "-o", str(tmp_path / "b"), "--size", "32x32"]) == 0
    assert capsys.readouterr().out == f"{tmp_path / 'b'}: read PORTING.md first\n"
    names = {path.name for path in (tmp_path / "b").iterdir()}
    assert names == {
        "PORTING.md",
        "mapping.toml",
        "mesh",
        "mesh.glb",
        "passes.json",
        "scene.json",
        "shaders",
        "textures",
        "uniforms.json",
    }
    scene = load_scene("figure5")
    for name, array in (("position", scene.mesh.positions), ("normal", scene.mesh.normals), ("uv", scene.mesh.uvs)):
        stored = np.load(tmp_path / "b" / "mesh" / f"{name}.npy")
        assert stored.dtype == np.float32 and stored.tobytes() == array.tobytes()
    uniforms = json.loads((tmp_path / "b" / "uniforms.json").read_text())
    stored = np.array(uniforms["light_clip_from_model"]["value"], np.float32)
    assert stored.tobytes() == scene.lights[0].view.clip_from(scene.world_from_model).tobytes()
    assert len(uniforms["tap_offset"]["value"]) == 13 and uniforms["tap_count"] == {"type": "int", "value": 13}
    shown = trimesh.load(tmp_path / "b" / "mesh.glb", process=False, force="mesh")
    assert len(shown.faces) == len(scene.mesh.triangles)
    assert np.array_equal(np.float32(shown.vertices), scene.mesh.positions)
    guide = (tmp_path / "b" / "PORTING.md").read_text()
    assert "1. `shadow_map`, 2048 x 2048: `distance_to_light`, `uv_at_light`." in guide
    assert "sss-ref validate . ../dump" in guide


def test_a_bundle_replaces_a_bundle_and_nothing_else(tmp_path):
    scene = load_scene("wedge", **SMALL)
    folder = write_bundle(scene, tmp_path / "bundle")
    (folder / "stale.txt").write_text("")
    assert write_bundle(scene, folder) == folder and not (folder / "stale.txt").exists()
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "passes.json").write_text("[]")
    with pytest.raises(DumpError, match="expected a new folder, an empty one or an earlier bundle, got other files"):
        write_bundle(scene, tmp_path / "mine")
