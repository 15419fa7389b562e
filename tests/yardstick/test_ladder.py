"""A ladder of a small scene: a technique that is planted wrong comes out worse, and a dump of the oracle is exact."""

import json
from dataclasses import replace

import numpy as np
import pytest
from boxes import shaded_plate
from known_ladder import ladder

from sss_ref.errors import DumpError, SceneError
from sss_ref.rendering.fold import render
from sss_ref.truth.material_fit import fitted_material
from sss_ref.truth.radiance import nothing_gathered
from sss_ref.yardstick.ladder import Ladder, climbed, drawn_image
from sss_ref.yardstick.ladder_page import as_html
from sss_ref.yardstick.ladder_pictures import SIGNED, signed
from sss_ref.yardstick.ladder_record import as_record
from sss_ref.yardstick.ladder_table import as_markdown
from sss_ref.yardstick.rungs import Rung
from sss_ref.yardstick.yardstick import Yardstick

SMALL = {
    "preset": "robust",
    "mm_per_unit": 1.0,
    "camera.width": 32,
    "camera.height": 32,
    "shadow_map.width": 512,
    "shadow_map.height": 512,
    "shadow_map.test": "slope",
}


@pytest.fixture(scope="module")
def plates(tmp_path_factory):
    """Where only the edge of a shadow tells how wide a blur is, with the keys that are fitted to skin2."""
    scene = shaded_plate(tmp_path_factory.mktemp("plates") / "plates.obj")
    of = Yardstick(scene, SMALL, "skin2")
    fit = fitted_material(of.volumes, 5_000, diffuse=True)
    return of, nothing_gathered(of.tracing).more(64), fit


def rung(of, name, keys):
    return Rung("screen_space", name, keys, render(of.scene_of("screen_space", keys), keep="final").image, 0.0)


def test_a_blur_of_twice_or_half_the_width_is_farther_from_the_truth(plates):
    of, radiance, fit = plates
    keys = fit.keys(1.0, fit.nearer_law)
    wide, narrow = (
        {**keys, "blur": {**keys["blur"], "mm_per_offset": keys["blur"]["mm_per_offset"] * factor}}
        for factor in (2.0, 0.25)
    )
    found = Ladder(of, radiance, fit, (rung(of, "fitted", keys), rung(of, "wide", wide), rung(of, "narrow", narrow)))
    off = {name: by["shadow edge"].rms for name, by in found.deviations.items()}
    assert off["screen_space, fitted"] < 0.6 * min(off["screen_space, wide"], off["screen_space, narrow"])
    assert abs(found.deviations["screen_space, fitted"]["lit"].bias) < 0.05


def test_it_is_told_as_record_table_and_page(plates):
    of, radiance, fit = plates
    told = []
    found = climbed(of, radiance, ["burley"], fit, on_rung=told.append)
    assert told == ["rendering burley, shipped", "rendering burley, fitted"]
    record = json.loads(json.dumps(as_record(found)))
    assert record["format"] == "sss_ref measure 1" and record["gpu"] is None
    shipped, fitted = record["techniques"]
    assert shipped["keys"] == {} and fitted["keys"]["diffusion"]["albedo"] == fit.color
    assert shipped["errors"]["everywhere"]["mean"] == found.deviations["burley, shipped"]["everywhere"].mean
    assert record["regions"]["everywhere"]["pixels"] == 32 * 32
    table = as_markdown(found).splitlines()
    assert len(table) == 5 and len({line.count("|") for line in table}) == 1
    page = as_html(found)
    for line in table[2:]:
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        assert all(f">{cell}</td>" in page for cell in cells)
    assert page.count("<img") == 2 + 2 * 3 and "phong.ambient = 0.1" in page


def test_what_a_gpu_drew_is_held_against_the_oracle(plates, tmp_path):
    of, radiance, _ = plates
    image = render(of.given, keep="final").image
    np.save(tmp_path / "image.npy", image)
    exact = climbed(of, radiance, [], None, drawn_image(of, tmp_path)).gpu["everywhere"]
    assert (exact.bias, exact.rms, exact.mean, exact.color_tail) == (0, 0, 0, 0)
    np.save(tmp_path / "image.npy", image * np.float32(1.25))
    brighter = climbed(of, radiance, [], None, drawn_image(of, tmp_path))
    assert brighter.gpu["everywhere"].bias == pytest.approx(0.25, rel=1e-6)  # float32
    assert "GPU against the oracle" in as_markdown(brighter) and "GPU against the oracle" in as_html(brighter)


def test_the_noise_is_that_of_the_samples(plates):
    of, radiance, fit = plates
    more = Ladder(of, radiance, fit, ())
    fewer = replace(more, radiance=nothing_gathered(of.tracing).more(16))
    assert fewer.noise["lit"].mean / more.noise["lit"].mean == pytest.approx(2, rel=0.15)  # sqrt(64/16)


def test_pixels_without_two_samples_are_in_no_number(plates):
    of, radiance, fit = plates
    sums = radiance.sums._replace(counted=radiance.sums.counted.copy())
    sums.counted[:16] = 1
    half = Ladder(of, replace(radiance, sums=sums), fit, ())
    assert half.noise["everywhere"].pixels == 16 * 32 and np.isfinite(half.noise["everywhere"].mean)
    with pytest.raises(SceneError, match="expected a body that is seen, with two samples a pixel, got no such pixel"):
        _ = Ladder(of, nothing_gathered(of.tracing).more(1), fit, ()).noise


def test_red_is_too_bright_and_blue_too_dark(plates):
    of, radiance, fit = plates
    ladder = Ladder(of, radiance, fit, ())
    covered = ladder.masks["everywhere"]
    for factor, colour in ((0.0, SIGNED[0]), (2.0, SIGNED[-1])):
        shown = signed(ladder.truth.mean * factor, ladder.truth, covered)
        bright = ladder.truth.mean.mean(axis=-1) > 0.3 * ladder.truth.white
        assert bright.any() and (shown[bright] == colour).all()


GRAY = np.linspace(1.0, 6, 6).reshape(2, 3, 1) * np.ones(3)


def test_pixels_that_are_not_known_in_every_channel_are_in_no_region():
    error = np.zeros((2, 3, 3))
    error[0, 0, 2] = error[1, 0] = np.inf
    found = ladder(GRAY, error).masks
    assert list(found) == ["everywhere", "lit"]  # of the dark one no pixel is left
    assert found["everywhere"].tolist() == [[False, True, True], [False, True, False]]
    assert found["lit"].tolist() == [[False, True, False], [False, False, False]]
    with pytest.raises(
        SceneError, match=r"^head <1>: expected a body that is seen, with two samples a pixel, got no such"
    ):
        _ = ladder(GRAY, np.inf).masks


def test_white_is_a_ninth_above_what_99_of_100_pixels_do_not_exceed():
    """By the brightest channel of each, on the body."""
    mean = np.zeros((1, 102, 3))
    mean[0, :101, 1], mean[0, 101] = np.arange(101.0), 999.0
    mean[0, :101, 2] = 0.5
    truth = ladder(mean, 0.25, {"everywhere": np.arange(102)[np.newaxis] < 101}).truth
    assert truth.white == pytest.approx(99 / 0.9, rel=1e-12)
    assert truth.mean is mean and (truth.error == 0.25).all()
    with pytest.raises(
        SceneError, match=r"^head <1>: expected light that leaves the body, got none; move a light or take"
    ):
        _ = ladder(GRAY * 0).truth


def test_each_rung_is_held_against_the_truth_and_the_noise_against_none():
    image = (GRAY * 1.5).astype(np.float32)
    found = ladder(GRAY, rungs=[Rung("burley", "shipped", {}, image, 1.0)])
    by = found.deviations["burley, shipped"]
    assert list(by) == ["everywhere", "lit", "dark"]
    assert [(each.pixels, each.bias) for each in by.values()] == [(5, 0.5), (2, 0.5), (1, 0.5)]
    assert found.noise["lit"].mean == 0


def test_a_picture_that_no_gpu_drew_is_refused(tmp_path):
    of = Yardstick("sphere", SMALL, "skin2")
    np.save(tmp_path / "coverage.npy", np.zeros((32, 32), np.uint8))
    with pytest.raises(DumpError, match=r": expected the buffer image, got others; dump the final picture too$"):
        drawn_image(of, tmp_path)
    image = np.full((32, 32, 3), 0.5, np.float32)
    np.save(tmp_path / "image.npy", image)
    assert drawn_image(of, tmp_path).dtype == np.float64 and (drawn_image(of, tmp_path) == 0.5).all()
    image[1, 2, 0], image[3, 4, 1] = np.nan, np.inf
    np.save(tmp_path / "image.npy", image)
    with pytest.raises(DumpError, match=r"image\.npy: expected finite numbers, got 2 that are not; mend the shader$"):
        drawn_image(of, tmp_path)
