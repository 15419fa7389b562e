"""The WGSL of a witness, which reads nothing: green on lavapipe, red where the stage is another, and for NaN."""

import re

import numpy as np
import pytest
from lavapipe import LAVAPIPE, needs_lavapipe
from wrong_pixels import WRONG, witness_of

from sss_ref.cli import main
from sss_ref.errors import ShaderError
from sss_ref.validation.witness.recording import recorded
from sss_ref.validation.witness.stand_alone_wgsl import stand_alone_wgsl
from sss_ref.validation.witness.witness_record import write_record
from sss_ref.webgpu.witness_run import run_wgsl_alone

pytestmark = needs_lavapipe
SLIPS = {  # buffer -> what is written otherwise in its stage, and how
    "phong": ("ambient / light_count", "ambient * light_count * 2.0"),
    "scattered": ("tap < tap_count", "tap < tap_count - 6"),
    "lit": ("translucency * translucency_scale", "translucency * 2.0 * translucency_scale"),
}


@pytest.mark.parametrize("name", WRONG)
def test_our_stage_is_right_on_lavapipe(name):
    witness = witness_of(name)
    done = run_wgsl_alone(stand_alone_wgsl(witness), LAVAPIPE)
    assert done.right and "llvmpipe" in done.device
    bits = done.bits[: len(witness.expected)]
    computed = bits.view(np.float32) if witness.expected.dtype == np.float32 else bits.astype(witness.expected.dtype)
    assert (np.abs(computed.astype(float) - witness.expected) <= witness.known.reach[0]).all()


@pytest.mark.parametrize("name", SLIPS)
def test_a_stage_with_a_slip_is_wrong_there(name):
    right, (before, after) = stand_alone_wgsl(witness_of(name)), SLIPS[name]
    assert right.count(before) >= 1
    assert not run_wgsl_alone(right.replace(before, after), LAVAPIPE).right


@pytest.mark.parametrize(
    ("bits", "right"),
    [
        ("0x00000000u", True),
        ("0x80000000u", True),  # -0 where 0 may be
        ("0x3f800000u", True),
        ("0x3f800001u", False),
        ("0xbf800001u", False),
        ("0x7fc00000u", False),  # NaN, for which a compiler may take every comparison to hold
        ("0xffc00000u", False),
        ("0x7f800000u", False),
        ("0xff800000u", False),
    ],
)
def test_bits_are_compared_as_numbers_are(bits, right):
    """In an interval that ends at 1: from 0, and from -1."""
    for low in ("0x00000000u", "0xbf800000u"):
        shader, count = re.subn(
            r"witness_within\(bits.x,\s+0x\w+,\s+0x\w+\)",
            f"witness_within({bits} ^ witness_nothing, {low}, 0x3f800000u)",
            stand_alone_wgsl(witness_of("translucency")),
        )
        assert count == 1
        assert run_wgsl_alone(shader, LAVAPIPE).right == right


def test_the_bits_are_no_constants_of_the_compiler():
    """Of another instance all inputs are others, and so is what comes out."""
    shader = stand_alone_wgsl(witness_of("phong"))
    assert shader.count("corner.nothing") == 1
    assert not run_wgsl_alone(shader.replace("corner.nothing", "corner.nothing + 8388608u"), LAVAPIPE).right


def test_what_does_not_compile_is_told():
    with pytest.raises(ShaderError, match=r"^witness: expected shaders that compile and fit each other, got "):
        run_wgsl_alone("fn", LAVAPIPE)


def test_on_the_command_line(tmp_path, capsys):
    path, shader = tmp_path / "wrong.json", tmp_path / "alone.wgsl"
    write_record(recorded(witness_of("phong")), path)
    assert main(["witness", str(path), "--wgsl", str(shader), "--run-wgsl"]) == 1
    assert shader.read_text() == stand_alone_wgsl(witness_of("phong"))
    assert "the stage is right here" in capsys.readouterr().out
