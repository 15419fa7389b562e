"""The files that a mesh refers to: which may be read, and whether they are as they were."""

import hashlib

import pytest

from sss_ref.errors import MeshError
from sss_ref.mesh import untrusted
from sss_ref.mesh.untrusted import OwnFolder, referred_to, unchanged


@pytest.fixture
def mesh(tmp_path):
    folder = tmp_path / "own"
    (folder / "below").mkdir(parents=True)
    (folder / "a.mtl").write_bytes(b"one")
    (folder / "below" / "b c.png").write_bytes(b"two")
    (tmp_path / "outside.png").write_bytes(b"three")
    return folder / "model.obj"


ONE = hashlib.sha256(b"one").hexdigest()


@pytest.mark.parametrize(
    ("references", "same"),
    [
        ({}, True),
        ({"a.mtl": ONE}, True),
        ({"a.mtl": ""}, True),
        ({"none.mtl": None}, True),
        ({"a.mtl": ONE, "none.mtl": ""}, False),
        ({"a.mtl": hashlib.sha256(b"two").hexdigest()}, False),
        ({"a.mtl": None}, False),
        ({"none.mtl": ONE}, False),
        ({"../outside.png": ""}, False),
    ],
)
def test_files_are_as_they_were(mesh, references, same):
    assert unchanged(mesh, references) is same


def test_what_is_asked_for_is_noted_and_what_was_read_stays_so(mesh):
    folder = OwnFolder(mesh)
    with referred_to() as references:
        assert folder.get("a.mtl") == b"one" and folder.holds("a.mtl")
        assert folder.holds("below/b%20c.png") and not folder.holds("none.png")
    assert references == {"a.mtl": ONE, "below/b%20c.png": "", "none.png": None}
    folder.holds("below/b c.png")
    assert len(references) == 3


@pytest.mark.parametrize("name", ["../outside.png", "/etc/hostname", "below/../../outside.png"])
def test_what_is_elsewhere_is_refused_whatever_is_asked(mesh, name):
    for ask in (OwnFolder(mesh).get, OwnFolder(mesh).holds, OwnFolder(mesh).check):
        with pytest.raises(MeshError, match="references to files in its own folder"):
            ask(name)


def test_a_link_that_leads_out_is_refused(mesh):
    (mesh.parent / "link.png").symlink_to(mesh.parent.parent / "outside.png")
    with pytest.raises(MeshError, match="references to files in its own folder"):
        OwnFolder(mesh).get("link.png")


def test_all_files_together_have_a_limit(mesh, monkeypatch):
    monkeypatch.setattr(untrusted, "BYTE_LIMIT", 6)
    folder = OwnFolder(mesh)
    assert folder.get("a.mtl") + folder.get("below/b c.png") == b"onetwo"
    with pytest.raises(MeshError, match="at most 6 bytes in the files it refers to"):
        folder.get("a.mtl")
