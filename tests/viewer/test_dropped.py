"""Dropped files: which are taken, where they lie, and what a scene may name."""

import pytest

from sss_ref.errors import MeshError, SceneError
from sss_ref.viewer.dropped import MOST_FILES, SIZE_LIMIT, DroppedFiles

GIVEN = {"mesh": {"path": "mine.obj", "texture": "skin.png"}, "layers": [{"path": "molar_dentine"}]}


@pytest.fixture
def files(tmp_path):
    return DroppedFiles(tmp_path)


def dropped(files, name, content=b"x"):
    file = files.announced(name, len(content), adopt=True)
    file.add(content)
    return files.keep(file)


@pytest.mark.parametrize("name", ["../a.obj", "a/b.obj", ".obj", ".a.obj", "", "a", "a.exe", "..", "a.obj/", "a.toml"])
def test_a_name_that_is_none_of_a_mesh_is_refused(files, name):
    with pytest.raises(MeshError, match=r": expected a file ending in \.obj, .*, got another; convert the mesh$"):
        files.announced(name, 1, adopt=True)


@pytest.mark.parametrize("size", [0, -1, SIZE_LIMIT + 1])
def test_a_size_out_of_bounds_is_refused(files, size):
    with pytest.raises(MeshError, match=rf"^a\.obj: expected 1 to {SIZE_LIMIT} bytes, got {size}; "):
        files.announced("a.obj", size, adopt=True)


def test_more_bytes_than_announced_are_refused(files):
    file = files.announced("a.obj", 3, adopt=True)
    file.add(b"ab")
    assert not file.is_whole
    with pytest.raises(MeshError, match=r"^a\.obj: expected 3 bytes as announced, got more; "):
        file.add(b"cd")


def test_only_so_many_are_kept_and_one_of_the_same_name_replaces(files):
    for number in range(MOST_FILES):
        dropped(files, f"{number}.obj")
    with pytest.raises(MeshError, match=rf"^a\.obj: expected at most {MOST_FILES} dropped files, got one more; "):
        files.announced("a.obj", 1, adopt=True)
    assert dropped(files, "3.obj", b"new").read_bytes() == b"new"
    assert len(files.names()) == MOST_FILES


def test_dropped_files_are_found_and_called_by_name_again(files):
    path = dropped(files, "ball.OBJ")
    data = {"mesh": {"path": "ball.OBJ", "color": [1, 1, 1]}, "layers": [{"path": "ball.OBJ"}]}
    located = files.located(data, GIVEN)
    assert located == {"mesh": {"path": str(path), "color": [1, 1, 1]}, "layers": [{"path": str(path)}]}
    assert (
        files.by_name(located)
        == data
        == {"mesh": {"path": "ball.OBJ", "color": [1, 1, 1]}, "layers": [{"path": "ball.OBJ"}]}
    )
    assert files.named(f"{path}: expected a vertex") == "ball.OBJ: expected a vertex"


@pytest.mark.parametrize(
    "data", [GIVEN, {"mesh": {"path": "bust"}}, {"mesh": {"path": "molar_dentine"}}, {}, {"mesh": 7}]
)
def test_what_the_scene_names_and_what_is_shipped_may_be_named(files, data):
    assert files.located(data, GIVEN) == data


@pytest.mark.parametrize(
    ("data", "key"),
    [
        ({"mesh": {"path": "/etc/passwd"}}, "mesh.path"),
        ({"mesh": {"path": "other.obj"}}, "mesh.path"),
        ({"mesh": {"path": "bust", "texture": "/etc/passwd"}}, "mesh.texture"),
        ({"mesh": {"path": "bust", "normal_map": "bust"}}, "mesh.normal_map"),
        ({"layers": [{"path": "molar_dentine"}, {"path": "~/x.obj"}]}, "layers.1.path"),
    ],
)
def test_no_other_file_is_named(files, data, key):
    with pytest.raises(SceneError, match=rf"^{key}: expected a shipped mesh or a dropped file, got "):
        files.located(data, GIVEN)


def test_how_large_and_how_many_dropped_files_may_be(files):
    assert (SIZE_LIMIT, MOST_FILES) == (64 * 1024 * 1024, 64)
    assert [files.announced("a.obj", size, adopt=False).size for size in (1, SIZE_LIMIT)] == [1, SIZE_LIMIT]
