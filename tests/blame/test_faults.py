"""A SPIR-V binary with one instruction changed is valid, draws otherwise, and is blamed on the compiler."""

import numpy as np
import pytest
import spirv
from opengl import needs_mesa
from stack_faults import device_with, drawn, texts_of

from sss_ref.blame.blaming import COMPILER, Suspicion
from sss_ref.blame.stacks import GLSL, stacks_here
from sss_ref.gl.shaders import shader_folder
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.dumped import Drawing

SIZES = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}

pytestmark = [
    needs_mesa,
    pytest.mark.skipif(
        not spirv.are_there(),
        reason="no SPIR-V tools are installed (Debian: glslang-tools spirv-tools spirv-cross)",
    ),
]


def test_an_edit_of_spirv_is_a_compilers_mistake(tmp_path):
    scene = load_scene("sphere", **SIZES, method="screen_space")
    texts = texts_of(scene)
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    binary = spirv.compiled(tmp_path / "blur.frag", tmp_path)
    same = device_with(texts | {"blur.frag": spirv.glsl(binary)})
    right, again = drawn(scene), drawn(scene, same.draw)
    assert all(np.array_equal(buffer, again[name]) for name, buffer in right.items())

    edit = next(each for each in spirv.edits(binary) if "FDiv becomes FMul" in each.told)
    edited = edit.applied(binary)
    assert sum(a != b for a, b in zip(edited, binary, strict=True)) == 1  # the opcode's byte
    device = device_with(texts | {"blur.frag": spirv.glsl(edited)})
    drawing = Drawing(drawn(scene, device.draw), device=device.name)
    (tmp_path / "blur.frag.spv").unlink()
    shaders = shader_folder(tmp_path, scene.settings)
    said = Suspicion(scene, drawing, shaders, [*stacks_here(GLSL), device]).blame()
    assert said.whose == COMPILER


def test_no_edit_leaves_a_binary_as_it_was(tmp_path):
    scene = load_scene("sphere", **SIZES, method="screen_space")
    (tmp_path / "camera_1.frag").write_text(texts_of(scene)["camera_1.frag"])
    binary = spirv.compiled(tmp_path / "camera_1.frag", tmp_path)
    found = spirv.edits(binary)
    assert len(found) > 20 and all(each.applied(binary) != binary for each in found)
