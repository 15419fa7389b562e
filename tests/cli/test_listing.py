"""What `sss-ref scenes` and `info` print, letter by letter."""

import json

import numpy as np
import pytest

from sss_ref.cli import main
from sss_ref.mesh.triangles import Mesh
from sss_ref.scene_file import shipped


def test_scenes_are_two_columns_without_a_heading(tmp_path, monkeypatch, capsys):
    (tmp_path / "scenes").mkdir()
    texts = {"a": "# A [head] of wax.\nx = 1", "longer": "x = 1 # no comment on the whole", "none": ""}
    for name, text in texts.items():
        (tmp_path / "scenes" / f"{name}.toml").write_text(text)
    monkeypatch.setattr(shipped, "data_folder", lambda: tmp_path)
    assert main(["scenes"]) == 0
    assert (
        capsys.readouterr().out
        == "a       A [head] of wax.  \nlonger                    \nnone                      \n"
    )


def mesh(**changes):
    """A triangle of 2 x 4 units with notes."""
    positions = np.array([[1, 2, 3], [3, 2, 3], [1, 6, 3.5]], np.float32)
    about = {
        "name": "t[1].obj",
        "positions": positions,
        "normals": np.array([[0, 0, 1]] * 3, np.float32),
        "uvs": None,
        "triangles": np.array([[0, 1, 2]], np.int32),
        "material": np.zeros(1, np.int32),
        "materials": (),
        "normals_source": "file",
        "notes": ("one [of] two",),
    }
    return Mesh(**{**about, **changes})


@pytest.fixture
def informed(monkeypatch, capsys):
    """Runs the command on a mesh that is given; its lines, or its JSON."""

    def run(found, *words):
        monkeypatch.setattr("sss_ref.mesh.mesh_file.load_mesh", lambda path: found)
        monkeypatch.setattr("sss_ref.scene_file.shipped.given_mesh", lambda name: name)
        assert main(["info", "mesh", *words]) == 0
        return capsys.readouterr().out

    return run


def test_the_facts_of_a_mesh_are_two_columns(informed):
    size = "62.5 if the longest side is 250 mm; the scene has to say it"
    assert [line.rstrip() for line in informed(mesh()).splitlines()] == [
        "mesh         t[1].obj",
        "triangles    1",
        "vertices     3",
        "bounds       (1, 2, 3) to (3, 6, 3.5)",
        "size         (2, 4, 0.5)",
        f"mm_per_unit  {size}",
        "d_min        0.06, 1.5 % of the longest side; see sss-ref init",
        "normals      from the file",
        "watertight   no: inside and outside are not known",
        "UVs          none; for the texture-space method set mesh.unwrap = true",
        "note         one [of] two",
    ]


def test_the_facts_of_uvs(informed):
    uvs = np.array([[0.25, 0.5], [0.5, 0.5], [0.25, 1.5]], np.float32)
    lines = informed(mesh(uvs=uvs, normals_source="computed")).splitlines()
    assert [line.rstrip() for line in lines[7:]] == [
        "normals          computed, weighted by area",
        "watertight       no: inside and outside are not known",
        "UV bounds        (0.25, 0.5) to (0.5, 1.5)",
        "UV outside 0..1  1 vertices, 0 triangles moved from other tiles",
        "UV mirrored      0 of 1 triangles",
        "UV without area  0 of 1 triangles",
        "UV seams         0 edges",
        "note             one [of] two",
    ]


def test_the_facts_as_json(informed):
    assert json.loads(informed(mesh(), "--json")) == {
        "name": "t[1].obj",
        "triangles": 1,
        "vertices": 3,
        "low": [1, 2, 3],
        "high": [3, 6, 3.5],
        "size": [2, 4, 0.5],
        "mm_per_unit": 62.5,
        "d_min": 0.06,
        "normals": "file",
        "watertight": False,
        "uv": None,
        "notes": ["one [of] two"],
    }
