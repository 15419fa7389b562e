"""The surface's colour as the scene file asks for it: what becomes a uniform, what is refused, what is told."""

import numpy as np
import pytest
from PIL import Image

from sss_ref.errors import RenderError, SceneError
from sss_ref.rendering.fold import render
from sss_ref.scene import load_scene
from sss_ref.validation.stage_by_stage import validate

WITH_UVS = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
FACES = "usemtl skin\nf 1/1 3/3 2/2\nf 1/1 2/2 4/3\nf 1/1 4/2 3/3\nusemtl hair\nf 2/1 3/2 4/3\n"


@pytest.fixture
def textured(small, tmp_path):
    """A scene on a mesh with UVs and materials, and a picture of one dark texel above a white one."""
    (tmp_path / "a.obj").write_text(WITH_UVS + FACES)
    (tmp_path / "a.mtl").write_text("newmtl skin\nKd 0.5 0.25 0.125\nnewmtl hair\nKd 0.1 0 0\n")
    Image.fromarray(np.array([[[55, 55, 55]], [[255, 255, 255]]], np.uint8)).save(tmp_path / "a.png")
    return {**small, "mesh": {"path": str(tmp_path / "a.obj")}}


def refusal(scene, **overrides):
    with pytest.raises(SceneError) as error:
        load_scene(scene, **overrides)
    return str(error.value)


def test_one_colour(small):
    assert list(load_scene(small).albedo) == ["mesh_color"]
    assert np.array_equal(load_scene(small).albedo["mesh_color"], np.float32([0.7, 0.4, 0.4]))


def test_texture(textured, tmp_path):
    scene = load_scene(textured, **{"mesh.texture": str(tmp_path / "a.png"), "mesh.color": "material"})
    assert list(scene.albedo) == ["albedo_map"]  # the texture replaces the colour
    assert scene.albedo["albedo_map"].shape == (2, 1, 3) and scene.albedo["albedo_map"][0, 0, 0] == 1


def test_texture_beside_the_scene_file(textured, tmp_path):
    lines = ('[mesh]\npath = "a.obj"\ntexture = "a.png"\n[camera]\ntype = "orbit"\ndistance = 5\n', "[[lights]]\n")
    (tmp_path / "scene.toml").write_text("".join(lines) + "position = [0, 0, 9]\n")
    assert load_scene(tmp_path / "scene.toml").albedo["albedo_map"].shape == (2, 1, 3)


def test_texels_are_an_input(textured, tmp_path):
    before = load_scene(textured, **{"mesh.texture": str(tmp_path / "a.png")}).input_hashes()
    Image.new("RGB", (1, 2)).save(tmp_path / "a.png")
    after = load_scene(textured, **{"mesh.texture": str(tmp_path / "a.png")}).input_hashes()
    assert {name for name in before if before[name] != after[name]} == {"albedo_map"}


def test_colours_of_the_file(textured):
    scene = load_scene(textured, **{"mesh.color": "material"})
    colors = scene.albedo["material_color"][scene.albedo["triangle_material"]]
    at_origin = (scene.mesh.positions[scene.mesh.triangles] == 0).all(axis=2).any(axis=1)
    assert np.count_nonzero(at_origin) == 3 and scene.warnings == ()
    assert np.array_equal(colors, np.where(at_origin[:, None], np.float32([0.5, 0.25, 0.125]), np.float32([0.1, 0, 0])))
    assert "material_color" in scene.input_hashes()


def test_colours_that_are_not_there(small):
    assert refusal(small, **{"mesh.color": "material"}) == (
        "scene: mesh.color: expected a material with a colour for every triangle, got 4 of 4 without; "
        "give mesh.color as RGB, or put the material file beside the mesh"
    )


def test_textures_inside_the_file_are_told_of(asset, small):
    mesh = {"path": str(asset("spot/cow.glb")), "color": "material"}
    assert load_scene({**small, "mesh": mesh}).warnings == (
        "mesh: textures inside the file are not read (of material_1); give one as mesh.texture",
    )


def test_texture_on_a_mesh_without_uvs(small, textured, tmp_path):
    assert refusal(small, **{"mesh.texture": str(tmp_path / "a.png")}) == (
        "scene: mesh.texture: expected a mesh with UVs, got tetrahedron.obj without; "
        "give the mesh it was painted for, or set mesh.unwrap = true if any UVs will do"
    )


def test_texture_that_is_no_picture(textured, tmp_path):
    (tmp_path / "a.png").write_bytes(b"text")
    found = refusal(textured, **{"mesh.texture": str(tmp_path / "a.png")})
    assert found == "scene: mesh.texture: expected a PNG or JPEG picture, got another kind of file; export it again"


def drawn(scene, interpreter):
    """Rendered, without a shadow map to speak of."""
    return render(load_scene(scene, **{"shadow_map.width": 8, "shadow_map.height": 8}), interpreter)


@pytest.mark.parametrize("interpreter", ["arrays", "kernel"])
def test_a_uv_that_overflows_is_an_error_and_reads_no_texel_elsewhere(textured, tmp_path, interpreter):
    """Infinity less infinity is NaN, and the integer that it becomes is no place in the texture."""
    textured["mesh"]["texture"] = str(tmp_path / "a.png")
    (tmp_path / "a.obj").write_text((WITH_UVS + FACES).replace("vt 1 0", "vt 3e38 0").replace("vt 0 1", "vt -3e38 0"))
    with pytest.raises(RenderError, match=r"^stage surface, pixel .*: result is not finite; "):
        drawn(textured, interpreter)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_dumped_uv_that_is_no_number_is_judged(textured, tmp_path, value):
    textured["mesh"]["texture"] = str(tmp_path / "a.png")
    ours = drawn(textured, "arrays")
    dumped = {"uv": ours["uv"].copy(), "albedo": ours["albedo"]}
    dumped["uv"][tuple(np.argwhere(ours["coverage"])[0])] = value
    report = validate(ours, dumped, profile="ieee", explain=False)
    assert "stage surface" in report.summary and not report.passed
