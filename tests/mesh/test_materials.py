"""Colours of the mesh file's materials, and the triangles they belong to."""

import numpy as np
import pytest

from sss_ref.mesh.materials import Material
from sss_ref.scene import load_mesh

POSITIONS = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
PARTS = "mtllib a.mtl\n" + POSITIONS + "usemtl red\nf 1 2 3\nusemtl grey\nf 2 4 3\nusemtl red\nf 2 5 4\n"


def loaded(folder, mtl, obj=PARTS):
    (folder / "a.obj").write_text(obj)
    if mtl is not None:
        (folder / "a.mtl").write_text(mtl)
    return load_mesh(folder / "a.obj")


def material_at(mesh, corner):
    """The material of the triangle that has a corner at this position."""
    (number,) = np.flatnonzero((mesh.positions[mesh.triangles] == corner).all(axis=2).any(axis=1))
    return mesh.materials[mesh.material[number]]


def test_mtl(tmp_path):
    mesh = loaded(tmp_path, "newmtl red\nKd 0.7 0.1 0.013\nnewmtl grey\nKd .25 .25 .25\n")
    red, grey = Material("red", (0.7, 0.1, 0.013)), Material("grey", (0.25, 0.25, 0.25))
    assert set(mesh.materials) == {red, grey} and mesh.material.dtype == np.int32
    assert material_at(mesh, (0, 0, 0)) == material_at(mesh, (2, 1, 0)) == red
    assert sorted(np.bincount(mesh.material).tolist()) == [1, 2]


@pytest.mark.parametrize("mtl", [None, "newmtl red\nKs 1 1 1\nnewmtl grey\nKd nan 0 0\n", "newmtl red\nKd -1 0 0\n"])
def test_materials_without_a_colour(tmp_path, mtl):
    assert {material.color for material in loaded(tmp_path, mtl).materials} == {None}


def test_a_library_changes_nothing_but_the_colours(tmp_path):
    bare = loaded(tmp_path, None)
    full = loaded(tmp_path, "newmtl red\nKd 1 0 0\nnewmtl grey\nKd 0.5 0.5 0.5\n")
    assert bare.hashes() == full.hashes() and bare.materials == (Material("red"), Material("grey"))


def test_asset_in_obj(asset):
    mesh = load_mesh(asset("ict_face/generic_neutral_mesh.obj"))
    counts = {material.name: int((mesh.material == k).sum()) for k, material in enumerate(mesh.materials)}
    faces = {"M_Face": 18460, "M_BackHead": 9608, "M_Teeth": 8696, "M_GumsTongue": 5808, "M_EyeLashes": 2160}
    assert len(counts) == 12 and sum(counts.values()) == 52220 and counts.items() >= faces.items()
    gums = next(material for material in mesh.materials if material.name == "M_GumsTongue")
    assert gums == Material("M_GumsTongue", (0.3, 0.03, 0.06))


def test_asset_in_glb(asset):
    mesh = load_mesh(asset("gltf/AlphaBlendModeTest.glb"))
    counts = {material.name: int((mesh.material == k).sum()) for k, material in enumerate(mesh.materials)}
    assert counts == {
        "MatOpaque": 21,
        "MatBlend": 4,
        "MatCutoff75": 2,
        "MatCutoffDefault": 2,
        "MatCutoff25": 2,
        "MatBed": 30,
    }
    assert all(material.textured and material.color == (1, 1, 1) for material in mesh.materials)
