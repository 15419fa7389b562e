"""The sums of Gaussians, held to the diffusion approximation written out once more, and that to what was printed."""

import math
import re
from pathlib import Path

import pytest
from filled_scenes import are_filled_as_ever

from sss_ref.scene_file.profiles import MEDIA, PROFILES, SKIN
from sss_ref.scene_file.substances import SUBSTANCES

RULES = (Path(__file__).parents[2] / "docs" / "rules.md").read_text(encoding="utf-8")
PRINTED = {  # Jensen et al. 2001, table 1: scattering, absorption, diffuse reflectance
    "marble": ((2.19, 2.62, 3.00), (0.0021, 0.0041, 0.0071), (0.83, 0.79, 0.75)),
    "milk": ((2.55, 3.21, 3.77), (0.0011, 0.0024, 0.014), (0.91, 0.88, 0.76)),
}


def lengths(scattering, absorption, ior):
    """Albedo, mean free path, extrapolated distance, diffusion length."""
    F = -1.44 / ior**2 + 0.71 / ior + 0.668 + 0.0636 * ior
    t = scattering + absorption
    return scattering / t, 1 / t, 2 * (1 + F) / (1 - F) / (3 * t), 1 / math.sqrt(3 * absorption * t)


def through_a_slab(d, *medium):
    b, first, z, f = lengths(*medium)
    return b * math.sinh((first + z) / f) * math.cosh(z / f) / math.sinh((d + 2 * z) / f)


def channels(medium):
    return [(scattering, absorption, medium.ior) for scattering, absorption in zip(*medium[:2], strict=True)]


@pytest.mark.parametrize("name", MEDIA)
def test_rows_are_what_comes_through_a_slab(name):
    for channel, medium in enumerate(channels(MEDIA[name]), start=1):
        for d in (0.5 * 1.1**k for k in range(60)):
            fitted = sum(row[channel] * math.exp(-(d**2) / row[0]) for row in PROFILES[name])
            T = through_a_slab(d, *medium)
            assert abs(fitted - T) <= 0.02 * (T + 0.01)


@pytest.mark.parametrize("name", MEDIA)
def test_colors_are_what_thick_bodies_reflect(name):
    for medium, color in zip(channels(MEDIA[name]), SUBSTANCES[name].color, strict=True):
        b, first, z, f = lengths(*medium)
        assert b / 2 * (1 + math.exp(-2 * z / f)) * math.exp(-first / f) == pytest.approx(color, abs=0.006)


@pytest.mark.parametrize("name", PRINTED)
def test_measured_media_are_as_printed(name):
    assert (*MEDIA[name][:2], SUBSTANCES[name].color) == PRINTED[name]


def test_profiles_are_as_ever(tmp_path):
    are_filled_as_ever(["profiles"], tmp_path)


def test_skin_lets_all_light_leave_again():
    assert [round(sum(column), 12) for column in list(zip(*SKIN, strict=True))[1:]] == [1, 1, 1]


@pytest.mark.parametrize("name", MEDIA)
def test_rules_have_the_same_figures(name):
    row = re.search(rf"^\| `{name}` \|(.*)\|$", RULES, re.MULTILINE).group(1).split(" | ")
    figures = [tuple(float(each) for each in cell.split(",")) for cell in row[:4]]
    assert figures == [*MEDIA[name][:2], (MEDIA[name].ior,), SUBSTANCES[name].color]
