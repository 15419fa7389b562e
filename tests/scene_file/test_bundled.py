"""scene.json of a bundle: what it says of a scene, and what of it cannot be rendered again."""

import json

import pytest
from pydantic import ValidationError

from sss_ref.errors import SceneError
from sss_ref.rules import RULES_VERSION
from sss_ref.scene_file.bundled import bundle_record, bundled_settings
from sss_ref.scene_file.layers import filled
from sss_ref.scene_file.settings import SceneFile


def record_of(small, **mesh):
    layer = {"path": "inner.obj", "extinction_per_mm": [1, 2, 3]}
    data = {**small, "mm_per_unit": 2.0, "layers": [layer], "mesh": {"path": "a.obj", "unwrap": True, **mesh}}
    return bundle_record(SceneFile.model_validate(filled(data)), "a.toml", ["b", "a"])


def test_what_a_scene_names_is_what_lies_in_the_bundle(small):
    """Its UVs are there, so they are not made again."""
    record = record_of(small, texture="t.jpg", specular_map="s.png")
    mesh = record.settings["mesh"]
    assert (mesh["path"], mesh["unwrap"], mesh["texture"]) == ("mesh", False, "textures/albedo.png")
    assert (mesh["normal_map"], mesh["specular_map"]) == (None, "textures/specular_map.npy")
    assert record.settings["layers"][0]["path"] == "inner_mesh"
    assert (record.source, record.own_stages, record.rules_version) == ("a.toml", ("a", "b"), RULES_VERSION)
    with pytest.raises(ValidationError, match="frozen"):
        record.source = "b.toml"


def test_a_scene_without_pictures_has_none_in_the_bundle(small):
    mesh = record_of(small).settings["mesh"]
    assert [mesh[key] for key in ("texture", "normal_map", "specular_map")] == [None] * 3


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"own_stages": ["a", "b"]}, ": expected our stages, got others for a, b; use sss_ref.validate with the scene"),
        ({"rules_version": RULES_VERSION + 1}, f": expected rules version {RULES_VERSION}, got {RULES_VERSION + 1}; w"),
        ({"more": 1}, ": more: expected what sss-ref bundle writes, got something else; write the bundle again"),
        ({"settings": 1}, ": settings: expected what sss-ref bundle writes, got something else; write the bundle"),
    ],
)
def test_what_cannot_be_rendered_again(small, tmp_path, changes, said):
    content = {**record_of(small).model_dump(mode="json"), "own_stages": []}
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(content))
    assert bundled_settings(tmp_path) == content["settings"]
    path.write_text(json.dumps({**content, **changes}))
    with pytest.raises(SceneError) as caught:
        bundled_settings(tmp_path)
    assert str(caught.value).startswith(f"{path}{said}")


def test_text_that_is_no_record(tmp_path):
    (tmp_path / "scene.json").write_text("[")
    with pytest.raises(SceneError, match=r"scene\.json: file: expected what sss-ref bundle writes, got something else"):
        bundled_settings(tmp_path)
