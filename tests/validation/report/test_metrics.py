"""SSIM and FLIP beside the verdicts: what they say of pictures, and what they are not given."""

import numpy as np
import pytest

from sss_ref.cli import main
from sss_ref.errors import DumpError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.report import metrics
from sss_ref.validation.report.metrics import Likeness, likeness

pytest.importorskip("flip_evaluator", reason="install .[metrics]")

SIZES = {f"{table}.{side}": 48 for table in ("camera", "shadow_map") for side in ("width", "height")}


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SIZES), interpreter="arrays")


def test_equal_pictures_other_pictures_and_no_pictures(oracle):
    """Only colours are looked at; a slightly wrong one is hardly told from a right one, an inverted one is."""
    other = {name: oracle[name] for name in ("albedo", "depth", "normal_world")}
    other["phong"] = oracle["phong"] * np.float32(1.01)
    other["image"] = 1 - oracle["image"]
    found = {each.buffer: each for each in likeness(oracle, other)}
    assert list(found) == ["albedo", "phong", "image"]
    assert found["albedo"] == Likeness("albedo", 1.0, 0.0)
    assert 0.999 < found["phong"].ssim < 1 and 0 < found["phong"].flip < 0.02
    assert found["image"].ssim < 0.5 and found["image"].flip > 0.1


def test_blank_pictures_do_not_end_the_process(oracle):
    black = {"image": np.zeros_like(oracle["image"])}
    assert next(likeness(oracle, black)).flip > 0


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_what_is_not_finite_is_not_handed_over(oracle, value):
    broken = {"image": oracle["image"].copy()}
    broken["image"][3, 4, 1] = value
    assert list(likeness(oracle, broken)) == [Likeness("image", note="no metric takes NaN or infinity")]


def test_pictures_smaller_than_the_window():
    small = render(load_scene("sphere", **dict.fromkeys(SIZES, 6)), interpreter="arrays")
    assert list(likeness(small, {"image": small.image})) == [Likeness("image", note="SSIM needs at least 7 x 7 pixels")]


def test_without_the_packages(oracle, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(
        "sss_ref.validation.report.metrics.find_spec", lambda name: None if name == "flip_evaluator" else 1
    )
    np.save(tmp_path / "image.npy", oracle.image)
    changes = [part for key, value in SIZES.items() for part in ("--set", f"{key}={value}")]
    assert main(["validate", "sphere", str(tmp_path), *changes, "--metrics"]) == 2
    told = "error: --metrics: expected the packages scikit-image, flip-evaluator, got not all; run pip install"
    assert capsys.readouterr().err.startswith(told)


def test_likeness_in_words():
    assert str(Likeness("image", 0.5, 0.25)) == "image: SSIM 0.500000, FLIP 0.250000"
    assert str(Likeness("image", note="none")) == "image: none"
    assert str(Likeness("image", 0.5, None, "no FLIP")) == "image: no FLIP"
    assert str(Likeness("image", None, 0.5, "no SSIM")) == "image: no SSIM"


def test_ssim_of_even_pictures_by_hand():
    """(2*a*b + C) / (a^2 + b^2 + C), C = (0.01 * 255)^2 (Wang 2004), of one channel; the others are the same."""
    ours = np.full((8, 10, 3), 100, np.uint8)
    theirs = ours.copy()
    theirs[..., 1] = 150
    one = (2 * 100 * 150 + 2.55**2) / (100**2 + 150**2 + 2.55**2)
    assert metrics._ssim(ours, theirs) == pytest.approx((1 + one + 1) / 3, rel=1e-9)  # summed in another order


def test_a_flip_that_ends_its_process_is_told(oracle, tmp_path, monkeypatch):
    process = tmp_path / "flip.py"
    process.write_text("raise SystemExit(3)")
    monkeypatch.setattr(metrics, "PROCESS", process)
    with pytest.raises(DumpError, match=r"^--metrics: expected a number from FLIP, got .* exit status 3\.; leave"):
        [*likeness(oracle, {"image": oracle["image"]})]
