"""A single pass drawn by a browser, with our shaders and with a user's."""

import pytest
from chromium import needs_chromium

from sss_ref.errors import ShaderError
from sss_ref.interpret.shader import ESSL, array_lengths, shader_files
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate
from sss_ref.webgl.one_pass import browser_name, draw_pass

SIZES = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}

pytestmark = needs_chromium


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SIZES, method="screen_space"), "arrays", threads=1)


def drawn(oracle, shaders):
    one = oracle.scene.method["composite"]
    return draw_pass(oracle.scene, one, {name: oracle[name] for name in one.needs if name in oracle.buffers}, shaders)


def test_a_pass_is_right_with_our_shaders_and_wrong_with_a_mistaken_one(oracle, tmp_path):
    found = drawn(oracle, {})
    assert list(found) == ["image"] and validate(oracle, {**oracle.buffers, **found}, explain=False).passed
    file = tmp_path / "composite.frag"
    text = shader_files(oracle.scene.method, array_lengths(oracle.scene.uniforms), ESSL)[file.name]
    file.write_text(text.replace("? background", "? scattered").replace(": background", ": scattered"))
    assert file.read_text() != text
    wrong = drawn(oracle, {"composite": file})
    assert validate(oracle, {**oracle.buffers, **wrong}, explain=False).culprit.stage == "over_background"


def test_what_does_not_compile_is_refused(oracle, tmp_path):
    (tmp_path / "composite.frag").write_text("#version 300 es\nlayout(location = 0) out vec3 out_image;\nvoid main() {")
    with pytest.raises(ShaderError, match="expected shaders that compile"):
        drawn(oracle, {"composite": tmp_path / "composite.frag"})


def test_it_says_what_draws():
    assert browser_name().startswith("WebGL 2, ANGLE on SwiftShader, ")
