"""A colour texture as an input of a recorded rendering: where it was, what it held, and where it is found again."""

import pytest
from PIL import Image

from sss_ref.rendering.fold import render
from sss_ref.results.folder import save
from sss_ref.results.manifest import read_manifest
from sss_ref.results.verify import verify
from sss_ref.scene.load import load_scene


@pytest.fixture
def textured(scene_file):
    """A result whose scene, mesh and texture lie beside it."""
    scene_file.write_text(scene_file.read_text().replace("[camera]", 'texture = "skin.png"\n[camera]'))
    Image.effect_noise((8, 4), 90).save(scene_file.parent / "skin.png")
    return save(render(load_scene(scene_file), keep="final"), scene_file.parent / "out")


def test_recorded_and_verified(textured):
    manifest = read_manifest(textured)
    assert manifest.scene.texture_file == str(textured.parent / "skin.png")
    assert manifest.scene.settings["mesh"]["texture"] == "skin.png"
    assert "albedo_map" in manifest.inputs and verify(textured).equal


def test_a_specular_map_is_found_as_well(scene_file):
    scene_file.write_text(scene_file.read_text().replace("[camera]", 'specular_map = "dull.png"\n[camera]'))
    Image.effect_noise((8, 4), 90).save(scene_file.parent / "dull.png")
    folder = save(render(load_scene(scene_file), keep="final"), scene_file.parent / "out")
    there = str(scene_file.parent / "dull.png")
    assert read_manifest(folder).scene.other_files == {"mesh.specular_map": there} and verify(folder).equal
    (scene_file.parent / "new").mkdir()
    for name in ("out", "dull.png"):
        (scene_file.parent / name).rename(scene_file.parent / "new" / name)
    assert verify(scene_file.parent / "new" / "out").equal


def test_other_texels_are_another_input(textured):
    Image.new("RGB", (8, 4)).save(textured.parent / "skin.png")
    assert verify(textured).message.startswith("input differs: albedo_map of ")


def test_found_beside_a_moved_result(textured, tmp_path_factory):
    new = tmp_path_factory.mktemp("new") / "place"
    textured.parent.rename(new)
    assert verify(new / "out").equal
