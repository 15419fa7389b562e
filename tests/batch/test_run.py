import csv
import os

import numpy as np
import pytest
from small_batches import items_of, small_sweep

from sss_ref.batch import workshop
from sss_ref.batch.executors import in_processes
from sss_ref.batch.item_folder import item_folder
from sss_ref.batch.plan import Shard
from sss_ref.batch.run import BatchExecution, run
from sss_ref.rendering.fold import render
from sss_ref.results.folder import save
from sss_ref.scene.load import load_scene

ARRAYS = BatchExecution(interpreter="arrays", threads=1)
FLAT = {"camera.width": 32, "camera.height": 24, "shadow_map.width": 32, "shadow_map.height": 32}


def states(batch):
    return [each.state for each in batch.outcomes]


def test_an_item_is_what_render_gives(tmp_path):
    batch = run(small_sweep(outputs=["png", "npz"], keep=["image", "thickness"]), tmp_path / "batch", ARRAYS)
    assert states(batch) == ["rendered"] * 4
    result = render(load_scene("small", **FLAT, **{"camera.azimuth": 90}), keep=["image", "thickness"])
    assert batch.outcomes[1].hashes == result.hashes
    folder = item_folder(batch.folder, batch.outcomes[1].name)
    assert sorted(os.listdir(folder)) == ["buffers.npz", "image.png", "item.json"]
    alone = save(result, tmp_path / "alone")
    assert (folder / "image.png").read_bytes() == (alone / "image.png").read_bytes()
    with np.load(folder / "buffers.npz") as buffers:
        assert {name: buffers[name].tobytes() for name in buffers} == {
            name: buffer.tobytes() for name, buffer in result.buffers.items()
        }


def test_the_exr_of_an_item_is_that_of_a_result(tmp_path):
    batch = run(small_sweep(outputs=["exr"], vary={"camera.azimuth": [0]}), tmp_path / "batch", ARRAYS)
    alone = save(render(load_scene("small", **FLAT), keep="final"), tmp_path / "alone")
    item = item_folder(batch.folder, batch.outcomes[0].name)
    assert (item / "buffers.exr").read_bytes() == (alone / "buffers.exr").read_bytes()


def test_what_is_there_is_not_rendered_again(tmp_path, monkeypatch):
    first = run(small_sweep(), tmp_path, ARRAYS)
    monkeypatch.setattr(workshop, "render", lambda *_: pytest.fail("rendered"))
    second = run(small_sweep(), tmp_path, ARRAYS)
    assert states(second) == ["there"] * 4
    assert [each.hashes for each in second.outcomes] == [each.hashes for each in first.outcomes]
    assert [each.seconds for each in second.outcomes] == [each.seconds for each in first.outcomes]


def test_a_failing_item_leaves_the_others_alone(tmp_path):
    told = []
    batch = run(small_sweep(vary={"camera.fov_y": [30, 400, 40]}), tmp_path, ARRAYS, on_outcome=told.append)
    assert states(batch) == ["rendered", "failed", "rendered"]
    assert batch.outcomes[1].message.startswith(
        "override: camera.fov_y: expected an angle between 0 and 180 degrees, got 400"
    )
    assert told == list(batch.outcomes) and len(items_of(tmp_path)) == 2
    with batch.tables[0].open(newline="") as file:
        assert [row["state"] for row in csv.DictReader(file)] == ["rendered", "failed", "rendered"]


def test_a_fault_of_the_package_is_told_as_one(tmp_path, monkeypatch):
    monkeypatch.setattr(workshop, "render", lambda *_: 1 / 0)
    batch = run(small_sweep(), tmp_path, ARRAYS)
    assert batch.outcomes[0].message.startswith(
        "item 0: expected a picture, got ZeroDivisionError, a fault of this package"
    )
    assert states(batch) == ["failed"] * 4


def test_a_mesh_is_read_once(tmp_path, monkeypatch):
    read, seen = workshop.read_mesh, []
    monkeypatch.setattr(workshop, "read_mesh", lambda *key: seen.append(key) or read(*key))
    run(small_sweep(vary={"mesh.rotate_degrees": [[0, 0, 0], [0, 9, 0]]}), tmp_path, ARRAYS)
    assert len(seen) == 1


def test_shards_render_what_the_whole_renders(tmp_path):
    whole = run(small_sweep(), tmp_path / "whole", ARRAYS)
    parts = [run(small_sweep(), tmp_path / "parts", ARRAYS, Shard(number, 3)) for number in (1, 2, 3)]
    assert [len(each.outcomes) for each in parts] == [2, 1, 1]
    hashes = {each.item: each.hashes for part in parts for each in part.outcomes}
    assert hashes == {each.item: each.hashes for each in whole.outcomes}
    assert states(run(small_sweep(), tmp_path / "parts", ARRAYS)) == ["there"] * 4


def test_an_executor_changes_no_hash(tmp_path, data_folder):
    """Processes know the shipped files, so the scene is given as one."""
    scene = tmp_path / "scene.toml"
    scene.write_text((data_folder / "scenes" / "small.toml").read_text().replace("tetrahedron", "tetrahedron.obj"))
    (tmp_path / "tetrahedron.obj").write_text((data_folder / "meshes" / "tetrahedron.obj").read_text())
    sweep = small_sweep(scene=str(scene))
    here = run(sweep, tmp_path / "here", ARRAYS)
    there = run(sweep, tmp_path / "there", BatchExecution(in_processes(2), "arrays", 1))
    assert [each.hashes for each in here.outcomes] == [each.hashes for each in there.outcomes]
    assert states(there) == ["rendered"] * 4
    assert [each.name for each in here.outcomes] == [each.name for each in there.outcomes]
