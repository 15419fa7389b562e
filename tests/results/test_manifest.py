import json
import re
from importlib.metadata import version

import pytest

from sss_ref.errors import DumpError
from sss_ref.results.manifest import manifest_of, read_manifest, scene_hash
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.load import load_scene


def test_comes_back_as_written(result, saved):
    assert read_manifest(saved) == manifest_of(result, "kernel", 2)


def test_holds_what_a_stranger_needs(result, saved):
    document = json.loads((saved / "manifest.json").read_text())
    assert list(document)[:4] == ["format", "format_version", "package_version", "rules_version"]
    assert document["rules_version"] == RULES_VERSION
    assert document["scene"]["source"] == result.scene.source
    assert document["scene"]["mesh_file"].endswith("tetrahedron.obj")
    assert document["inputs"] == result.scene.mesh.hashes()
    assert (document["interpreter"], document["threads"]) == ("kernel", 2)
    assert document["samples"] == 1
    assert set(document["milliseconds"]) == {"shadow_map", "camera", "blur", "composite"}
    assert document["environment"]["numba"] == version("numba")
    assert document["row_order"] == {"npy": "bottom row first", "exr": "top row first", "png": "top row first"}


def test_buffer_table(result, saved):
    table = {record.name: record for record in read_manifest(saved).buffers}
    assert list(table) == list(result.buffers)
    assert {name: record.sha256 for name, record in table.items()} == result.hashes
    uv, distance = table["shadow_uv"], table["light_distance"]
    assert (uv.dtype, uv.shape, uv.background, uv.file) == ("<f4", [32, 48, 2], -1, "buffers/shadow_uv.npy")
    far = result.scene.settings.lights[0].far
    assert distance.background == pytest.approx(2 * far, rel=1e-7) and distance.unit == "scene units from the light"
    assert table["image"].background == [0, 0, 0]
    assert (table["triangle"].dtype, table["coverage"].dtype) == ("<i4", "|u1")


def test_its_settings_load_to_the_same_scene(result, saved):
    recorded = read_manifest(saved).scene
    again = load_scene(recorded.settings, **{"mesh.path": recorded.mesh_file})
    mesh = again.settings.mesh.model_copy(update={"path": result.scene.settings.mesh.path})
    assert again.settings.model_copy(update={"mesh": mesh}) == result.scene.settings


def test_scene_hash_follows_the_settings(result, scene_file):
    assert scene_hash(load_scene(scene_file)) == scene_hash(result.scene)
    assert scene_hash(load_scene(scene_file, **{"phong.ambient": 0.25})) != scene_hash(result.scene)


def test_no_manifest(tmp_path):
    with pytest.raises(
        DumpError, match=r"manifest\.json: expected a folder written by sss-ref render, got No such file"
    ):
        read_manifest(tmp_path)


@pytest.mark.parametrize(
    "damage, told",
    [
        (lambda text: text[:100], "file"),
        (lambda text: "[" * 100_000, "file"),
        (lambda text: text.replace('"rules_version": 2', '"rules_version": "2"'), "rules_version"),
        (lambda text: text.replace('"format_version": 1', '"format_version": 9'), "format_version"),
        (lambda text: text.replace('"sha256": "', '"sha256": "x', 1), "buffers.0.sha256"),
        (lambda text: re.sub(r'"blur": [0-9.]+', '"blur": 1e999', text), "milliseconds.blur"),
    ],
)
def test_damaged(saved, damage, told):
    path = saved / "manifest.json"
    path.write_text(damage(path.read_text()))
    with pytest.raises(DumpError) as error:
        read_manifest(saved)
    expected = "expected what sss-ref render writes, got something else"
    assert str(error.value) == f"{path}: {told}: {expected}; the manifest is damaged, render the scene again"


def test_a_manifest_without_end_is_never_read(tmp_path):
    (tmp_path / "manifest.json").symlink_to("/dev/zero")
    with pytest.raises(DumpError, match=r"expected a folder written by sss-ref render, got no regular file; "):
        read_manifest(tmp_path)
