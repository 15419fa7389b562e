import json
from dataclasses import replace

import numpy as np
import pytest

from sss_ref.errors import DumpError, MeshError, SceneError
from sss_ref.rendering.fold import render
from sss_ref.results import verify as verify_module
from sss_ref.results.folder import save
from sss_ref.results.verify import verify
from sss_ref.scene.load import load_scene


@pytest.fixture
def own(scene_file):
    """A result whose scene and mesh lie beside it."""
    return save(render(load_scene(scene_file)), scene_file.parent / "out")


@pytest.mark.parametrize("interpreter, threads", [("kernel", None), ("arrays", 1)])
def test_equal(own, interpreter, threads):
    verdict = verify(own, interpreter, threads)
    assert verdict.equal and verdict.message == "verified: 22 buffers equal in every bit"


def test_only_the_kept_buffers_count(scene_file):
    folder = save(render(load_scene(scene_file), keep="final"), scene_file.parent / "out")
    assert verify(folder).message == "verified: 1 buffer equal in every bit"


def test_passes_are_told(own):
    told = []
    verify(own, on_pass=told.append)
    assert told == ["shadow_map", "camera", "blur", "composite"]


def test_other_rules(own):
    path = own / "manifest.json"
    path.write_text(path.read_text().replace('"rules_version": 2', '"rules_version": 0'))
    verdict = verify(own)
    assert not verdict.equal and verdict.message == "made under other rules (0 -> 2)"


def test_changed_file(own):
    path = own / "buffers" / "thickness.npy"
    data = bytearray(path.read_bytes())
    data[-1] ^= 1
    path.write_bytes(data)
    verdict = verify(own)
    assert not verdict.equal
    assert verdict.message == "the file buffers/thickness.npy was changed since (1 such file)"


def test_file_of_another_type(own):
    path = own / "buffers" / "depth.npy"
    np.save(path, np.float64(1))
    np.save(own / "buffers" / "image.npy", np.zeros((2, 2, 3), np.float32))
    assert verify(own).message == "the file buffers/depth.npy was changed since (2 such files)"


def test_missing_file(own):
    (own / "buffers" / "depth.npy").unlink()
    with pytest.raises(DumpError, match=r"depth\.npy: expected a buffer in NPY format"):
        verify(own)


def test_changed_mesh(own, scene_file):
    mesh = scene_file.parent / "tetrahedron.obj"
    mesh.write_text(mesh.read_text().replace("v 0 0 1", "v 0 0 1.5"))
    verdict = verify(own)
    assert not verdict.equal
    assert verdict.message == f"input differs: positions, normals of the mesh {mesh}"


def test_mesh_that_moved_along_is_found(own, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    moved = own.rename(elsewhere / "out")
    (own.parent / "tetrahedron.obj").rename(elsewhere / "tetrahedron.obj")
    assert verify(moved).equal


def test_mesh_that_is_gone(own):
    (own.parent / "tetrahedron.obj").unlink()
    with pytest.raises(SceneError, match="expected a mesh file"):
        verify(own)


def test_mesh_that_is_broken(own):
    (own.parent / "tetrahedron.obj").write_text("v 0 0 0\n")
    with pytest.raises(MeshError):
        verify(own)


def test_other_computation(own, monkeypatch):
    def slightly_wrong(*arguments):
        result = render(*arguments)
        scattered, image = result.buffers["scattered"].copy(), result.buffers["image"].copy()
        scattered[16, 24, 1] = np.nextafter(scattered[16, 24, 1], np.float32(2))
        scattered[20, 1] = image[0, 0] = 3
        return replace(result, buffers={**result.buffers, "scattered": scattered, "image": image})

    recorded = np.load(own / "buffers" / "scattered.npy")[16, 24]
    now = np.nextafter(recorded[1], np.float32(2))
    assert recorded[1] > 0
    monkeypatch.setattr(verify_module, "render", slightly_wrong)
    verdict = verify(own)
    assert not verdict.equal
    assert verdict.message.startswith(
        "computation differs: buffer scattered, first at pixel 24,16 (column,row; row 0 at the bottom): recorded "
    )
    green = f"{recorded[1]!s} (0x{recorded.view(np.uint32)[1]:08x})", f"{now!s} (0x{now.view(np.uint32):08x})"
    before, after = verdict.message.split(", now ")
    assert green[0] in before and green[1] in after
    assert after.endswith("; 2 of 1536 pixels differ")


def test_edited_settings_are_another_computation(own):
    path = own / "manifest.json"
    document = json.loads(path.read_text())
    document["scene"]["settings"]["camera"]["width"] = 40
    path.write_text(json.dumps(document))
    assert verify(own).message == ("computation differs: buffer triangle, its shape: recorded (32, 48), now (32, 40)")
