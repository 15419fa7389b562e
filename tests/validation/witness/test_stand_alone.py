"""The shader of a witness, which reads nothing: green on a right device, red where the stage is another."""

import glob
import os
import re
import shutil
import subprocess

import numpy as np
import pytest
from opengl import needs_mesa
from wrong_pixels import WRONG, witness_of

from sss_ref.cli import main
from sss_ref.gl.stand_alone_run import run_alone
from sss_ref.interpret.shader import ESSL
from sss_ref.validation.witness.recording import recorded
from sss_ref.validation.witness.stand_alone import stand_alone, write_stand_alone
from sss_ref.validation.witness.witness_record import write_record

RUNNERS = glob.glob("/usr/lib/*/piglit/bin/shader_runner")
VALIDATOR = shutil.which("glslangValidator")
SLIPS = {  # buffer -> what is written otherwise in its stage, and how
    "phong": ("ambient / light_count", "ambient * light_count * 2.0"),
    "scattered": ("tap < tap_count", "tap < tap_count - 6"),
    "lit": ("translucency * translucency_scale", "translucency * 2.0 * translucency_scale"),
}


@needs_mesa
@pytest.mark.parametrize("name", WRONG)
def test_our_stage_is_right_on_llvmpipe(name):
    witness = witness_of(name)
    done = run_alone(stand_alone(witness))
    assert done.right
    bits = done.bits[: len(witness.expected)]
    computed = bits.view(np.float32) if witness.expected.dtype == np.float32 else bits.astype(witness.expected.dtype)
    assert (np.abs(computed.astype(float) - witness.expected) <= witness.known.reach[0]).all()


@needs_mesa
@pytest.mark.parametrize("name", SLIPS)
def test_a_stage_with_a_slip_is_wrong_there(name):
    right, (before, after) = stand_alone(witness_of(name)), SLIPS[name]
    assert right.count(before) >= 1
    assert not run_alone(right.replace(before, after)).right


@needs_mesa
def test_the_bits_are_no_constants_of_the_compiler():
    """With another value of the uniform all inputs are others, and so is what comes out."""
    shader = stand_alone(witness_of("phong"))
    assert len(re.findall("witness_nothing", shader)) == 2
    assert not run_alone(
        shader.replace("uniform uint witness_nothing;", "const uint witness_nothing = 8388608u;")
    ).right


@pytest.mark.skipif(VALIDATOR is None, reason="no glslangValidator is installed (Debian: glslang-tools)")
@pytest.mark.parametrize("name", ["scattered", "directly_lit"])
def test_it_compiles_as_glsl_of_opengl_es_too(name, tmp_path):
    path = tmp_path / "alone.frag"
    path.write_text(stand_alone(witness_of(name), ESSL))
    done = subprocess.run([VALIDATOR, path], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


@needs_mesa
@pytest.mark.skipif(not RUNNERS, reason="no shader_runner is installed (Debian: piglit)")
@pytest.mark.parametrize(("slip", "result"), [(False, "pass"), (True, "fail")])
def test_piglit_runs_the_test(slip, result, tmp_path):
    path = write_stand_alone(witness_of("phong"), tmp_path / "alone.shader_test")
    if slip:
        path.write_text(path.read_text().replace(*SLIPS["phong"]))
    environment = os.environ | {"PIGLIT_PLATFORM": "surfaceless_egl"}
    command = [RUNNERS[0], path, "-auto", "-fbo"]
    printed = subprocess.run(command, env=environment, capture_output=True, text=True).stdout
    assert f'PIGLIT: {{"result": "{result}" }}' in printed


@needs_mesa
def test_on_the_command_line(tmp_path, capsys):
    path, shader, test = (tmp_path / name for name in ("wrong.json", "alone.frag", "alone.shader_test"))
    write_record(recorded(witness_of("phong")), path)
    assert main(["witness", str(path), "--glsl", str(shader), "--run-glsl"]) == 1
    assert shader.read_text() == stand_alone(witness_of("phong"))
    assert "the stage is right here" in capsys.readouterr().out
    assert main(["witness", str(path), "--glsl", str(test)]) == 1
    assert "[fragment shader]\n" + shader.read_text() in test.read_text()
    assert main(["witness", str(path), "--glsl", str(tmp_path / "no" / "where.frag")]) == 2
