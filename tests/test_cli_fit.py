"""`sss-ref fit`: what it prints is a scene file's part, and one line says what is wrong."""

import tomllib

import pytest

from sss_ref.cli import main
from sss_ref.scene.load import load_scene

NUMBERS = ["--scattering", "0.74", "0.88", "1.01", "--absorption", "0.032", "0.17", "0.48", "--ior", "1.3"]


def test_what_is_printed_is_a_scene_files_part(capsys):
    assert main(["fit", "skin1", "--photons", "4000", "--mm-per-unit", "150"]) == 0
    told = capsys.readouterr()
    printed = tomllib.loads(told.out)
    scene = load_scene("sphere", **printed)
    assert scene.settings.mm_per_unit == 150 and len(scene.settings.blur.taps) == 13
    assert scene.settings.translucency.exponent == tuple(printed["translucency"]["exponent"])
    assert (scene.settings.translucency.combine, scene.settings.translucency.wrap) == ("transmit_wrapped", 0)
    assert len(scene.settings.diffusion.gaussians) == 6 and scene.settings.diffusion.albedo == scene.settings.mesh.color
    assert "of a disc of" in told.err and told.err.count("e^(-") == 3


def test_numbers_are_as_their_name(capsys):
    assert main(["fit", *NUMBERS, "--photons", "2000"]) == 0
    of_numbers = capsys.readouterr().out
    assert main(["fit", "skin1", "--photons", "2000", "--threads", "1"]) == 0
    assert capsys.readouterr().out == of_numbers


def test_the_other_form_of_t_is_a_scene_files_part_too(capsys):
    assert main(["fit", "skin1", "--photons", "2000", "--lit", "all_sides"]) == 0
    (comment,) = [line for line in capsys.readouterr().out.splitlines() if line.startswith("# or ")]
    keys = tomllib.loads("\n".join(comment.removeprefix("# or ").split("; ")))
    scene = load_scene("sphere", translucency=keys)
    assert scene.settings.translucency.form == "beer" and scene.settings.translucency.x == tuple(keys["x"])


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ([], "fit: expected a material, or --scattering and --absorption"),
        (["skin1", *NUMBERS], "fit: expected a material, or --scattering and --absorption"),
        (["skin1", "--photons", "10"], "--photons: expected at least 1000, got 10"),
        (["skin1", "--mm-per-unit", "0"], "--mm-per-unit: expected more than 0, got 0"),
        (["skin1", "--threads", "0"], "--threads: expected at least 1, got 0"),
        (["cheese"], "material: expected the name of a medium, got 'cheese'"),
    ],
)
def test_what_is_wrong_is_said(capsys, words, line):
    assert main(["fit", *words]) == 2
    assert line in capsys.readouterr().err
