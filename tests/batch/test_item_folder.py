import json

import pytest

from sss_ref.batch.item_folder import RECORD, item_folder, item_name, read_record, record_of
from sss_ref.errors import DumpError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

TINY = {f"{table}.{side}": 8 for table in ("camera", "shadow_map") for side in ("width", "height")}


@pytest.fixture
def scene():
    return load_scene("small", **TINY)


def test_the_name_is_that_of_the_resolved_scene_and_its_inputs_alone(scene, tmp_path, data_folder):
    name = item_name(scene, scene.input_hashes())
    written = tmp_path / "other.toml"
    written.write_text((data_folder / "scenes" / "small.toml").read_text())
    same = load_scene(written, **TINY, preset="paper")
    assert item_name(same, same.input_hashes()) == name
    turned = load_scene("small", **TINY, **{"camera.azimuth": 1})
    assert item_name(turned, turned.input_hashes()) != name
    mesh = data_folder / "meshes" / "tetrahedron.obj"
    mesh.write_text(mesh.read_text().replace("v 0 0 1", "v 0 0 0.5"))
    moved = load_scene("small", **TINY)
    assert item_name(scene, moved.input_hashes()) != name


def test_a_record_is_read_as_it_was_written(scene, tmp_path):
    result = render(scene, "arrays", keep="final")
    record = record_of(result, scene.input_hashes(), 0.25)
    assert record.buffers == result.hashes and record.settings["lights"][0]["far"] is not None
    folder = item_folder(tmp_path, "ab" * 16)
    assert folder == tmp_path / "items" / "ab" / ("ab" * 16)
    assert read_record(folder) is None
    folder.mkdir(parents=True)
    (folder / RECORD).write_text(record.model_dump_json())
    assert read_record(folder) == record


@pytest.mark.parametrize("text", [None, "", "{}", json.dumps({"format": "sss_ref item 1"})])
def test_a_damaged_record_is_told(tmp_path, text):
    if text is not None:
        (tmp_path / RECORD).write_text(text)
    with pytest.raises(DumpError, match=r"item.json: expected (the record of an item|what sss-ref batch writes)"):
        read_record(tmp_path)
