"""Pictures as they are ordered, and that what is out of date is given up."""

import os
import tomllib
from types import SimpleNamespace

import pytest
from scenes import around, sphere, two_squares, written
from tabs import SMALL

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.reading import Document
from sss_ref.viewer import studio as studio_module
from sss_ref.viewer.dropped import DroppedFiles
from sss_ref.viewer.keeping import kept_file
from sss_ref.viewer.studio import Order, Studio, Superseded, starting_point


def studio_of(folder, document=None):
    (folder / "files").mkdir()
    return Studio(document or starting_point("default", SMALL), DroppedFiles(folder / "files"))


def never():
    return False


def test_a_stale_picture_is_given_up_before_its_next_pass(tmp_path):
    studio, asked = studio_of(tmp_path), []

    def is_stale():
        asked.append(None)
        return len(asked) == 2

    with pytest.raises(Superseded):
        studio.picture(Order(studio.document.data, "image", False), is_stale)
    assert len(asked) == 2


@pytest.mark.parametrize("buffer", ["image", "normal_world", "triangle", "coverage", "uv", "light_distance_1"])
def test_a_buffer_comes_with_its_hash_range_and_colours(tmp_path, buffer):
    picture = studio_of(tmp_path).picture(Order(starting_point("default", SMALL).data, buffer, False), never)
    facts = picture.facts
    assert facts["hash"] == render(load_scene("default", **SMALL), keep=[buffer]).hashes[buffer]
    assert len(picture.pixels) == 4 * facts["width"] * facts["height"]
    assert bool(facts["ramp"]) == (buffer == "light_distance_1")
    assert (facts["low"] is None) == (buffer == "image")
    assert facts["ofCamera"] == (buffer != "light_distance_1")


def test_a_buffer_that_another_method_has_not_gives_the_image(tmp_path):
    studio = studio_of(tmp_path)
    data = {**studio.document.data, "method": "texture_space"}
    assert studio.picture(Order(data, "scattered", False), never).facts["buffer"] == "image"


def test_a_mesh_file_that_changes_is_read_again(tmp_path):
    path = tmp_path / "mesh.obj"
    written(path, *sphere(6))
    data = around("mesh.obj", 64)
    studio = studio_of(tmp_path, Document(data, "scene.toml", tmp_path))
    before = studio.scene(data)
    assert studio.scene(data).mesh is before.mesh
    written(path, *two_squares())
    os.utime(path, ns=(1, 1))
    assert len(studio.scene(data).mesh.triangles) == 4


def test_the_scene_file_names_what_is_beside_the_scene_by_its_whole_path(tmp_path):
    written(tmp_path / "mesh.obj", *sphere(6))
    data = around("mesh.obj", 64)
    studio = studio_of(tmp_path, Document(data, "scene.toml", tmp_path))
    (tmp_path / "elsewhere").mkdir()
    saved = tmp_path / "elsewhere" / "scene.toml"
    saved.write_bytes(kept_file("scene", studio, data))
    assert render(load_scene(saved)).hashes["image"] == render(studio.scene(data)).hashes["image"]


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
@pytest.mark.parametrize("preset", ["paper", "robust"])
def test_the_picture_file_is_that_of_render(tmp_path, method, preset):
    studio = studio_of(tmp_path)
    data = {**studio.document.data, "method": method, "preset": preset}
    render(studio.scene(data)).save(tmp_path / "out")
    assert kept_file("picture", studio, data) == (tmp_path / "out" / "image.png").read_bytes()


def test_a_bundle_is_a_scene_to_start_with(tmp_path):
    from sss_ref.bundle.writing import write_bundle

    folder = write_bundle(load_scene("default", **SMALL), tmp_path / "bundle")
    studio = studio_of(tmp_path, starting_point(str(folder), {}))
    picture = studio.picture(Order(studio.document.data, "image", False), never)
    assert picture.facts["hash"] == render(load_scene("default", **SMALL), keep=["image"]).hashes["image"]


def test_a_dropped_file_is_named_as_it_was_dropped_even_where_the_scene_has_one_of_its_name(tmp_path):
    written(tmp_path / "mesh.obj", *sphere(6))
    data = around("mesh.obj", 64)
    studio = studio_of(tmp_path, Document(data, "scene.toml", tmp_path))
    written(tmp_path / "files" / "mesh.obj", *two_squares())
    assert len(studio.scene(data).mesh.triangles) == 4
    assert tomllib.loads(kept_file("scene", studio, data).decode())["mesh"]["path"] == "mesh.obj"


@pytest.mark.parametrize("is_draft", [True, False])
def test_what_is_told_of_a_picture(tmp_path, monkeypatch, is_draft):
    """A quarter of a second is far too long for a draft: the next one is smaller. The whole picture says nothing."""
    large = SMALL | {"camera.width": 600, "camera.height": 300}
    studio = studio_of(tmp_path, starting_point("default", large))
    monkeypatch.setattr(studio_module, "time", SimpleNamespace(perf_counter=iter([7.0, 7.25]).__next__))
    picture = studio.picture(Order(studio.document.data, "image", is_draft), never)
    facts = picture.facts
    size = (256, 128) if is_draft else (600, 300)
    assert (facts["kind"], facts["draft"], facts["ms"], facts["size"]) == ("picture", is_draft, 250, [600, 300])
    assert (facts["width"], facts["height"]) == size and len(picture.pixels) == 4 * size[0] * size[1]
    assert (facts["hash"] is None) == is_draft and picture.scene.settings.camera.width == 600
    assert studio.pace.side == (224 if is_draft else 256)
