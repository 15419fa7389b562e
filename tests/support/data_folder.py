"""A data folder with one mesh and one scene, and a scene dictionary that loads."""

import pytest

from sss_ref.scene_file import shipped

# A tetrahedron, counter-clockwise seen from outside.
TETRAHEDRON = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""

SMALL_SCENE = """
[mesh]
path = "tetrahedron"
[camera]
type = "orbit"
distance = 5
[[lights]]
position = [0, 0, 9]
"""


@pytest.fixture(autouse=True)
def data_folder(tmp_path_factory, monkeypatch):
    """Stands in for the shipped data."""
    folder = tmp_path_factory.mktemp("data")
    (folder / "meshes").mkdir()
    (folder / "scenes").mkdir()
    (folder / "meshes" / "tetrahedron.obj").write_text(TETRAHEDRON)
    (folder / "scenes" / "small.toml").write_text(SMALL_SCENE)
    monkeypatch.setattr(shipped, "data_folder", lambda: folder)
    return folder


@pytest.fixture
def small():
    """The smallest scene that loads, as a dictionary that a test may change."""
    return {
        "mesh": {"path": "tetrahedron"},
        "camera": {"type": "orbit", "distance": 5},
        "lights": [{"position": [0, 0, 9]}],
    }
