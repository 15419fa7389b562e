"""A ladder of a small scene: a technique that is planted wrong comes out worse, and a dump of the oracle is exact."""

import json
from dataclasses import replace

import numpy as np
import pytest
from boxes import shaded_plate

from sss_ref.errors import SceneError
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
