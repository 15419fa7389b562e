import json

import numpy as np
import pytest
from small_batches import small_sweep

from sss_ref.batch.plan import Shard
from sss_ref.batch.run import BatchExecution, run
from sss_ref.batch.transforms import intrinsics, world_from_camera
from sss_ref.errors import DumpError
from sss_ref.scene.load import load_scene

ARRAYS = BatchExecution(interpreter="arrays", threads=1)
CLOSE = 1 / 256  # pixels: to that corners are snapped, and a position is interpolated between them
LENS = {"fl_x", "fl_y", "cx", "cy", "w", "h"}


def written(tmp_path, **changes):
    batch = run(small_sweep(**{"olat": {"count": 2}, **changes}), tmp_path, ARRAYS)
    assert {each.state for each in batch.outcomes} == {"rendered"}
    return json.loads((tmp_path / "transforms.json").read_text())


def projected(point, frame, lens, applied):
    """Column and row of a point of our world, by the words of nerfstudio's page on data conventions alone."""
    world = np.array([*applied, [0, 0, 0, 1]]) @ [*point, 1]
    right, up, back, _ = np.linalg.inv(np.array(frame["transform_matrix"])) @ world
    return lens["cx"] + lens["fl_x"] * right / -back, lens["cy"] - lens["fl_y"] * up / -back


CAMERAS = [
    {"camera.azimuth": [0, 70, 200], "camera.elevation": [25]},
    {"camera": [{"type": "free", "position": [0.2, 0.9, 3], "yaw": 4, "pitch": -9, "width": 33, "height": 20}]},
    {"camera": [{"type": "look_at", "eye": [2, 3, 1], "up": [1, 0, 1], "fov_y": 50, "width": 17, "height": 40}]},
]


@pytest.mark.parametrize("vary", CAMERAS, ids=["orbit", "free", "look at"])
def test_a_point_falls_onto_the_pixel_that_shows_it(tmp_path, vary):
    table = written(tmp_path, vary=vary)
    assert len(table["frames"]) == 2 * len(next(iter(vary.values())))
    for frame in table["frames"]:
        with np.load(tmp_path / frame["buffers_path"]) as buffers:
            positions, covered = buffers["position_world"], buffers["coverage"] == 1
        assert covered.sum() > 5
        for row, column in np.argwhere(covered):
            x, y = projected(positions[row, column], frame, table, table["applied_transform"])
            assert abs(x - (column + 0.5)) < CLOSE and abs(y - (table["h"] - 1 - row + 0.5)) < CLOSE


def test_what_all_frames_share_stands_once(tmp_path):
    table = written(tmp_path / "one", vary={"camera.azimuth": [0, 9]})
    assert table.keys() >= LENS and not any(LENS & frame.keys() for frame in table["frames"])
    assert (table["w"], table["h"], table["cx"], table["cy"]) == (32, 24, 16, 12)
    assert table["camera_model"] == "OPENCV" and [table[key] for key in ("k1", "k2", "p1", "p2")] == [0] * 4
    table = written(tmp_path / "two", vary={"camera.fov_y": [30, 40]})
    assert not LENS & table.keys() and all(frame.keys() >= LENS for frame in table["frames"])


def test_every_frame_has_its_picture_and_its_light(tmp_path):
    table = written(tmp_path, vary={"camera.azimuth": [0]}, olat={"count": 2, "distance": 6, "intensity": 2})
    for frame in table["frames"]:
        assert (tmp_path / frame["file_path"]).is_file()
    (light,) = table["frames"][0]["lights"]  # from azimuth 0, elevation 30: +Z of our world is -Y of theirs
    assert np.allclose(light["towards"], [0, -np.sqrt(3) / 2, 0.5], atol=1e-12)
    assert np.allclose(light["position"], [0.5, -0.5 - 3 * np.sqrt(3), 0.5 + 3], atol=1e-12)
    assert (light["type"], light["intensity"], light["color"]) == ("point", 2.0, [1.0, 1.0, 1.0])
    directional = written(tmp_path / "far", vary={"camera.azimuth": [0]})["frames"][0]["lights"][0]
    assert "position" not in directional and np.allclose(directional["towards"], light["towards"], atol=1e-12)


def test_a_camera_by_hand():
    """At (0, 0, 5), looking along -Z of our world, which is +Y of one where Z is up; 90 degrees over 24 rows."""
    view = load_scene("small", **{"camera.fov_y": 90, "camera.width": 32, "camera.height": 24}).camera
    assert intrinsics(view)["fl_x"] == intrinsics(view)["fl_y"] == 12
    assert world_from_camera(view).tolist() == [[1, 0, 0, 0], [0, 0, -1, -5], [0, 1, 0, 0], [0, 0, 0, 1]]


def test_a_part_has_cameras_of_its_own_and_failed_items_none(tmp_path):
    sweep = small_sweep(vary={"camera.fov_y": [30, 400, 50]}, cameras=True)
    run(sweep, tmp_path, ARRAYS, Shard(2, 2))
    assert json.loads((tmp_path / "transforms-2-of-2.json").read_text())["frames"] == []
    run(sweep, tmp_path, ARRAYS)
    assert [frame["item"] for frame in json.loads((tmp_path / "transforms.json").read_text())["frames"]] == [0, 2]


def test_a_camera_without_perspective_is_refused(tmp_path):
    drawing = {"type": "orthographic", "eye": [0, 0, 5], "view_height": 3, "width": 8, "height": 8}
    with pytest.raises(DumpError, match=r"item 0: camera: expected one with a perspective, got one of type \"ortho"):
        run(small_sweep(vary={"camera": [drawing]}, cameras=True), tmp_path, ARRAYS)
