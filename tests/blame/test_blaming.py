"""One planted fault of each class is blamed on the right one, and a right picture on nobody."""

from dataclasses import replace

import numpy as np
import pytest
from opengl import needs_mesa

from sss_ref.blame.blaming import COMPILER, INPUT, NOBODY, SETTING, SHADER, UNKNOWN, Suspicion
from sss_ref.blame.stacks import ESSL, GLSL, WGSL, Stack, language_of, stacks_here
from sss_ref.cli import main
from sss_ref.errors import ShaderError
from sss_ref.gl.drawing import draw, draw_pass
from sss_ref.gl.shaders import shader_folder
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.dumped import Drawing

SIDE = 32
SIZES = {f"{table}.{side}": SIDE for table in ("camera", "shadow_map") for side in ("width", "height")}
KEYS = {"preset": "robust", "method": "screen_space", "shadow_map.test": "slope"}
RIGHT, WRONG = "normalize_(camera_position - position_world)", "normalize_(camera_position + position_world)"

pytestmark = needs_mesa


@pytest.fixture(scope="module")
def scene():
    return load_scene("sphere", **SIZES, **KEYS)


@pytest.fixture(scope="module")
def folder(scene, tmp_path_factory):
    return written(scene, tmp_path_factory.mktemp("right"))


@pytest.fixture(scope="module")
def wrong_folder(scene, tmp_path_factory):
    return written(scene, tmp_path_factory.mktemp("wrong"), RIGHT, WRONG)


def written(scene, folder, before="", after=""):
    for name, text in shader_files(scene.method, array_lengths(scene.uniforms)).items():
        (folder / name).write_text(text.replace(before, after) if before else text)
    return folder


def files(folder, scene):
    return shader_folder(folder, scene.settings)


def blamed(scene, buffers, shaders, stacks=None, device=None):
    found = stacks_here(GLSL) if stacks is None else stacks
    return Suspicion(scene, Drawing(buffers, device=device), shaders, found, seconds=30.0).blame()


def test_a_right_picture_is_nobodys_fault(scene, folder):
    assert blamed(scene, draw(scene), files(folder, scene)).whose == NOBODY


def test_a_wrong_source_is_the_shaders_fault(scene, wrong_folder):
    shaders = files(wrong_folder, scene)
    said = blamed(scene, draw(scene, shaders), shaders)
    assert said.whose == SHADER
    assert str(said).startswith("shader: fail: stage phong_shading of pass camera ")
    assert "phong_shading is wrong on llvmpipe" in str(said)


def test_a_right_source_that_comes_out_wrong_is_the_compilers_fault(scene, folder, wrong_folder):
    """What was drawn is what a compiler would have made that took one operator for another."""
    said = blamed(scene, draw(scene, files(wrong_folder, scene)), files(folder, scene))
    assert said.whose == COMPILER
    assert "right on llvmpipe" in str(said)


def test_what_drew_it_and_draws_our_own_wrong_as_well_is_the_compilers_fault(scene, folder, wrong_folder):
    wrong = files(wrong_folder, scene)
    device = Stack("A broken GPU", GLSL, lambda scene, one, buffers, _: draw_pass(scene, one, buffers, wrong))
    buffers, both = draw(scene, wrong), [*stacks_here(GLSL), device]
    said = blamed(scene, buffers, files(folder, scene), both, "a broken gpu")
    assert said.whose == COMPILER and "as well, which drew it" in str(said)
    elsewhere = blamed(scene, buffers, files(folder, scene), both, "another")
    assert "A broken GPU" not in str(elsewhere)


def test_what_drew_it_and_draws_the_source_right_is_no_compiler(scene, folder, wrong_folder):
    """The picture of a mistaken source that the user does not have: without it, something else was given."""
    said = blamed(scene, draw(scene, files(wrong_folder, scene)), files(folder, scene), device="llvmpipe")
    assert said.whose == INPUT and "draws the source right" in str(said)


def test_a_source_that_comes_out_otherwise_on_one_of_two_stacks_is_the_compilers_fault(scene, folder, wrong_folder):
    (sound,) = stacks_here(GLSL)

    def miscompiled(scene, this_pass, buffers, shaders):
        return sound.draw(scene, this_pass, buffers, files(wrong_folder, scene) if shaders else shaders)

    other = Stack("another compiler", GLSL, miscompiled)
    said = blamed(scene, draw(scene, files(wrong_folder, scene)), files(folder, scene), [sound, other])
    assert said.whose == COMPILER
    assert "phong_shading is wrong on another compiler" in str(said)


def test_a_format_and_a_clear_value_are_settings(scene, folder):
    buffers = draw(scene)
    half = buffers | {"phong": buffers["phong"].astype(np.float16).astype(np.float32)}
    assert blamed(scene, half, files(folder, scene)).whose == SETTING
    cleared = np.where(buffers["light_triangle"] < 0, np.float32(0), buffers["light_distance"])
    assert blamed(scene, buffers | {"light_distance": cleared}, files(folder, scene)).whose == SETTING


def test_a_depth_that_is_no_matrixs_is_a_setting(scene, folder):
    buffers = draw(scene)
    blended = np.where(buffers["triangle"] < 0, buffers["depth"], buffers["depth"] * buffers["depth"])
    said = blamed(scene, buffers | {"depth": blended.astype(np.float32)}, files(folder, scene))
    assert said.whose == SETTING and "the draw may be blended" in str(said)


def test_another_number_and_another_mesh_are_inputs(scene, folder):
    other = load_scene("sphere", **SIZES, **KEYS, **{"phong.shininess": 20.0})
    said = blamed(scene, draw(other), files(folder, scene))
    assert said.whose == INPUT and "shininess is 20 instead of 32" in str(said)
    moved = scene.mesh.positions.copy()
    moved[::3] *= np.float32(1.03)
    elsewhere = replace(scene, mesh=replace(scene.mesh, positions=moved))
    assert blamed(scene, draw(elsewhere), files(folder, scene)).whose == INPUT


def test_without_the_source_shader_and_compiler_are_not_told_apart(scene, wrong_folder):
    assert blamed(scene, draw(scene, files(wrong_folder, scene)), {}).whose == UNKNOWN


def test_the_language_is_that_of_the_files(folder, scene, tmp_path):
    assert language_of(files(folder, scene)) == GLSL
    (tmp_path / "camera.frag").write_text("@fragment fn main() {}")
    assert language_of({"camera": tmp_path / "camera.frag"}) == WGSL
    (tmp_path / "camera.frag").write_text("#version 300 es")
    assert language_of({"camera": tmp_path / "camera.frag"}) == ESSL
    (tmp_path / "camera.frag").write_bytes(b"\xff")
    with pytest.raises(ShaderError, match=r"camera\.frag: expected shader source in UTF-8, got a byte"):
        language_of({"camera": tmp_path / "camera.frag"})


def test_on_the_command_line(folder, wrong_folder, capsys):
    words = [word for key, value in (SIZES | KEYS).items() for word in ("--set", f"{key}={value}")]
    assert main(["blame", "sphere", str(wrong_folder), *words]) == 1
    assert capsys.readouterr().out.endswith("whose fault: shader\n")
    assert main(["blame", "sphere", str(folder), *words]) == 0
    assert capsys.readouterr().out.endswith("whose fault: nobody\n")
