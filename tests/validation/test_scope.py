"""What is left out of a run is left out, said so, and changes nothing else."""

from dataclasses import replace

import numpy as np
import pytest

import sss_ref
from sss_ref.cli import main
from sss_ref.cli.options import Haste
from sss_ref.errors import SceneError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.report.report_data import as_json
from sss_ref.validation.scope import FULL, QUICK, Scope
from sss_ref.validation.stage_by_stage import RASTERIZER, validate

SMALL = {f"{t}.{s}": 48 for t in ("camera", "shadow_map") for s in ("width", "height")}


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SMALL), interpreter="arrays")


@pytest.fixture(scope="module")
def wrong(oracle):
    """A dump whose shininess and blur are wrong."""
    shiny = render(load_scene("sphere", **SMALL, **{"phong.shininess": 20.0}), interpreter="arrays")
    return {**oracle.buffers, "phong": shiny["phong"], "scattered": oracle["scattered"] * np.float32(1.1)}


@pytest.fixture(scope="module")
def whole(oracle, wrong):
    return validate(oracle, wrong)


def test_a_single_stage_is_judged_as_it_is_in_a_whole_run(oracle, wrong, whole):
    for stage in dict.fromkeys(each.stage for each in whole.verdicts):
        found = validate(oracle, wrong, explain=Scope(stage=stage, causes=False, power=False))
        assert found.verdicts == tuple(each for each in whole.verdicts if each.stage == stage)


def test_a_later_stage_is_explained_where_it_alone_is_judged(oracle, wrong):
    found = validate(oracle, wrong, explain=Scope(stage="scatter_inside", power=False))
    assert "stage scatter_inside of pass blur is the only one judged, and wrong" in found.summary
    assert found.finding.check.stage == "scatter_inside" and as_json(found)["only"] == "scatter_inside"


def test_a_right_stage_says_that_no_other_was_judged(oracle, wrong):
    found = validate(oracle, wrong, explain=Scope(stage=RASTERIZER, power=False))
    assert found.passed
    assert found.summary == f"pass: stage {RASTERIZER} gives what it should; no other stage was judged"


def test_a_stage_of_which_nothing_was_given_is_empty(oracle):
    found = validate(oracle, {"image": oracle["image"]}, explain=Scope(stage="scatter_inside"))
    assert not found.passed and not found.judged
    assert found.summary == "empty: no buffer of stage scatter_inside to judge"


def test_an_unknown_stage_is_refused_with_the_nearest(oracle):
    with pytest.raises(SceneError, match=r"only: expected .* got scater_inside; did you mean scatter_inside\?"):
        validate(oracle, oracle.buffers, explain=Scope(stage="scater_inside"))


def test_a_pass_is_refused_with_its_stages(oracle):
    with pytest.raises(SceneError, match=r"^only: expected a stage of the method, got blur; write .*: scatter_inside$"):
        validate(oracle, oracle.buffers, explain=Scope(stage="blur"))


def test_in_haste_the_verdicts_are_the_same_and_there_is_no_power(oracle, wrong, whole):
    found = validate(oracle, wrong, explain=QUICK)
    assert found.verdicts == whole.verdicts and whole.power and not found.power
    assert found.finding.hypotheses[0] == whole.finding.hypotheses[0]


def test_without_time_it_is_said_what_was_not_tried(oracle, wrong, whole):
    found = validate(oracle, wrong, explain=replace(QUICK, seconds=0.0))
    assert found.verdicts == whole.verdicts
    assert found.finding.not_tried.startswith("not tried within 0 s: ")
    for kind in ("numbers", "6 kinds of other inputs and stages", "mistakes in the source"):
        assert kind in found.finding.not_tried
    assert found.explanations[-1] == found.finding.not_tried == as_json(found)["not_tried"]
    assert not whole.finding.not_tried


def test_the_options_of_the_command_line_add_up():
    assert Haste().scope(reported=True) == FULL and Haste(quick=True).scope(reported=True) == QUICK
    assert Haste().scope(reported=False) == Haste(power=False).scope(reported=True) == replace(FULL, power=False)
    assert Haste(power=True).scope(reported=False) == FULL
    assert Haste(only="blur", quick=True).scope(reported=True) == replace(QUICK, stage="blur")


def test_the_command_line_takes_them(oracle, wrong, tmp_path, capsys):
    for name in ("position_world", "phong", "directly_lit", "lit"):
        np.save(tmp_path / f"{name}.npy", wrong[name])
    given = [str(tmp_path), "--size", "48x48", "--interpreter", "arrays"]
    size = ["--set", "shadow_map.width=48", "--set", "shadow_map.height=48"]
    assert main(["validate", "sphere", *given, *size, "--quick", "--only", "directly_lit_slope"]) == 0
    printed = capsys.readouterr().out
    assert "no other stage was judged" in printed and "would see" not in printed
    assert main(["validate", "sphere", *given, *size, "--only", "phong"]) == 2
    assert main(["validate", "sphere", *given, *size, "--no-power"]) == 1
    assert "would see" not in capsys.readouterr().out


def test_the_package_offers_it():
    assert sss_ref.Scope is Scope
