"""One small scene in a folder of its own, rendered once for all tests of this folder."""

import pytest

from sss_ref.rendering.fold import render
from sss_ref.results.folder import save
from sss_ref.scene.load import load_scene

# A tetrahedron with texture coordinates, counter-clockwise seen from outside.
TETRAHEDRON = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vt 0 0
vt 1 0
vt 0 1
vt 1 1
f 1/1 3/3 2/2
f 1/1 2/2 4/4
f 1/1 4/4 3/3
f 2/2 3/3 4/4
"""

SCENE = """# A tetrahedron for tests.
[mesh]
path = "tetrahedron.obj"
[camera]
type = "orbit"
distance = 3
azimuth = 20
elevation = 30
width = 48
height = 32
[shadow_map]
width = 64
height = 64
[[lights]]
position = [2, 3, 4]
"""


@pytest.fixture
def scene_file(tmp_path):
    """A scene file and its mesh, which a test may change."""
    (tmp_path / "tetrahedron.obj").write_text(TETRAHEDRON)
    (tmp_path / "small.toml").write_text(SCENE)
    return tmp_path / "small.toml"


@pytest.fixture(scope="session")
def result(tmp_path_factory):
    """The scene with all buffers; the shadow map is larger than the image on one side and the image wider than high."""
    folder = tmp_path_factory.mktemp("scene")
    (folder / "tetrahedron.obj").write_text(TETRAHEDRON)
    (folder / "small.toml").write_text(SCENE)
    return render(load_scene(folder / "small.toml"))


@pytest.fixture
def saved(result, tmp_path):
    """A folder that holds the result."""
    return save(result, tmp_path / "out", "kernel", 2)
