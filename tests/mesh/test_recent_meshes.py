"""A mesh is read again when its file changes, or any that it refers to, and only then."""

import numpy as np
import pytest
from scenes import cube, written

from sss_ref.errors import MeshError
from sss_ref.mesh import recent_meshes
from sss_ref.mesh.recent_meshes import recent_mesh


@pytest.fixture
def reads(monkeypatch):
    """How often a mesh was really read."""
    found, load = [], recent_meshes.load_mesh
    monkeypatch.setattr(recent_meshes, "load_mesh", lambda path: found.append(path.name) or load(path))
    monkeypatch.setattr(recent_meshes, "MESHES", recent_meshes.Recent())
    return found


@pytest.fixture
def path(tmp_path):
    """A cube whose material file has a colour, and names a picture that is not there."""
    path = tmp_path / "cube.obj"
    written(path, *cube())
    path.write_text("mtllib cube.mtl\nusemtl a\n" + path.read_text())
    (tmp_path / "cube.mtl").write_text("newmtl a\nKd 1 0 0\nmap_Kd skin.png\n")
    return path


def test_an_unchanged_mesh_is_read_once_and_everybody_has_an_own(path, reads):
    first, again = recent_mesh(path), recent_mesh(path)
    assert reads == ["cube.obj"]
    assert first.hashes() == again.hashes()
    again.positions[:] = 0
    assert recent_mesh(path).hashes() == first.hashes() and reads == ["cube.obj"]


def test_any_file_counts(path, reads):
    colors = [recent_mesh(path).materials[0].color]
    material = path.with_name("cube.mtl")
    material.write_text(material.read_text().replace("1 0 0", "0 1 0"))
    colors.append(recent_mesh(path).materials[0].color)
    assert colors[0] != colors[1] and len(reads) == 2
    path.with_name("skin.png").write_bytes(b"")  # named, but not there before
    recent_mesh(path)
    assert len(reads) == 3
    path.with_name("skin.png").write_bytes(b"its content is not read")
    recent_mesh(path)
    assert len(reads) == 3
    material.unlink()
    recent_mesh(path)
    path.write_text(path.read_text().replace("usemtl a", "usemtl b"))
    recent_mesh(path)
    assert len(reads) == 5


def test_one_that_is_written_while_it_is_read_is_not_kept(path, reads, monkeypatch):
    load = recent_meshes.load_mesh

    def load_and_write(path):
        mesh = load(path)
        path.write_text(path.read_text() + f"# {len(reads)}\n")
        return mesh

    monkeypatch.setattr(recent_meshes, "load_mesh", load_and_write)
    before = path.read_text()
    recent_mesh(path)
    path.write_text(before)
    recent_mesh(path)
    assert len(reads) == 2


def test_a_mesh_that_is_refused_is_refused_again(path, reads):
    path.write_text("v 0 0 0\nf 1 2 3\n")
    for _ in range(2):
        with pytest.raises(MeshError):
            recent_mesh(path)
    assert len(reads) == 2
    with pytest.raises(MeshError):
        recent_mesh(path.with_name("nowhere.obj"))


def test_another_place_is_another_mesh(path, reads, tmp_path):
    (tmp_path / "other").mkdir()
    other = tmp_path / "other" / "ball.obj"
    other.write_bytes(path.read_bytes())
    assert (recent_mesh(path).name, recent_mesh(other).name) == ("cube.obj", "ball.obj")
    assert np.array_equal(recent_mesh(path).positions, recent_mesh(other).positions)
