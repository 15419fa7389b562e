"""What `sss-ref fit` walks through and prints, of a fit that is made up; walks and fits have tests of their own."""

from types import SimpleNamespace

import pytest

from sss_ref.cli import main
from sss_ref.truth.photon import Volume

COLORS = ("red", "green", "blue")
KEYS = {
    "mm_per_unit": 2.0,
    "mesh": {"color": [0.123456, 0.5, 1]},
    "blur": {"unit": "mm", "kernel": [(0.0, 0.123456789, 1.0), (-1.0, 0.25, 0.5)]},
    "translucency": {"form": "ratio", "x": 10},
    "diffusion": {"profile": [(1.0, 2.0)], "reach_mm": 12.34567},
}
TOML = """mm_per_unit = 2
[mesh]
color = [0.1235, 0.5, 1]
[blur]
unit = "mm"
kernel = [
  [0, 0.123457, 1],
  [-1, 0.25, 0.5],
]
[translucency]
form = "ratio"
x = 10
# or form = "beer"; x = [1.235, 2]
[diffusion]
profile = [
  [1, 2],
]
reach_mm = 12.35
"""
SAID = """kernel: of a disc of 7.50 mm, lit on the surface, so much comes to lie at a wrong radius
  red   1.0% (hbh09's own weights: 4.0%, at their best 0.10 mm an offset)
  green 2.0% (hbh09's own weights: 5.0%, at their best 0.20 mm an offset)
  blue  3.0% (hbh09's own weights: 6.0%, at their best 0.30 mm an offset)
six Gaussians: of a beam's light so much comes to lie at a wrong radius
  red   7.0%
  green 8.0%
  blue  9.0%
translucency: the largest deviation from the light that comes through slabs
  red   10% by the power law, 40% by e^(-1*d); it falls as d^-0.6 at 0.50 mm
  green 20% by the power law, 50% by e^(-2*d); it falls as d^-0.6 at 1.50 mm
  blue  30% by the power law, 60% by e^(-3*d); it falls as d^-0.6 at 2.50 mm
reflectances are known to 4.0% (a standard error)
"""
FITTED = SimpleNamespace(
    kernel=SimpleNamespace(
        disc=7.5, published_misplaced=(0.04, 0.05, 0.06), published_mm=(0.1, 0.2, 0.3), misplaced=(0.01, 0.02, 0.03)
    ),
    gaussians=SimpleNamespace(misplaced=(0.07, 0.08, 0.09)),
    laws=[
        SimpleNamespace(worst=k / 10, fading_worst=(3 + k) / 10, fading=float(k), paper_at=k - 0.5) for k in (1, 2, 3)
    ],
    profiles=[SimpleNamespace(reflectance=reflectance, reflectance_error=0.01) for reflectance in (0.5, 0.25, 0.8)],
    keys=lambda mm_per_unit: {**KEYS, "mm_per_unit": mm_per_unit},
    fading_law=lambda mm_per_unit: {"form": "beer", "x": [1.23456, mm_per_unit]},
)


@pytest.fixture
def fitted(monkeypatch):
    """Runs the command; what was to be fitted."""
    seen = []

    def fitted_material(volumes, photons, threads, diffuse, _):
        seen.append((volumes, photons, threads, diffuse))
        return FITTED

    monkeypatch.setattr("sss_ref.truth.material_fit.fitted_material", fitted_material)

    def run(*words):
        return main(["fit", *words])

    run.seen = seen
    return run


def test_the_keys_are_printed_and_how_far_off_they_are_is_said(fitted, capsys):
    assert fitted("skin1", "--mm-per-unit", "2", "--photons", "1000", "--threads", "1") == 0
    told = capsys.readouterr()
    assert (told.out, told.err) == (TOML, SAID)


def test_a_reflectance_of_nothing_is_not_divided_by(fitted, capsys, monkeypatch):
    dark = [SimpleNamespace(reflectance=0.0, reflectance_error=1e-10)] * 3
    monkeypatch.setattr(FITTED, "profiles", dark)
    assert fitted("skin1") == 0
    assert capsys.readouterr().err.endswith("reflectances are known to 10.0% (a standard error)\n")


SCATTERING, ABSORPTION = ("--scattering", "1", "2", "3"), ("--absorption", "0.1", "0.2", "0.3")


def numbers(anisotropy, ior):
    return tuple(Volume(s, a, anisotropy, ior) for s, a in ((1.0, 0.1), (2.0, 0.2), (3.0, 0.3)))


@pytest.mark.parametrize(
    ("words", "seen"),
    [
        ((*SCATTERING, *ABSORPTION), (numbers(0.0, 1.0), 200_000, None, False)),
        ((*SCATTERING, *ABSORPTION, "--ior", "1.5", "--lit", "all_sides"), (numbers(0.0, 1.5), 200_000, None, True)),
        (
            (*SCATTERING, *ABSORPTION, "--anisotropy", "0.5", "--photons", "1000", "--threads", "1"),
            (numbers(0.5, 1.0), 1000, 1, False),
        ),
        ((*SCATTERING, *ABSORPTION, "--mm-per-unit", "0.5"), (numbers(0.0, 1.0), 200_000, None, False)),
    ],
)
def test_numbers_are_walked_through_as_they_are_given(words, seen, fitted):
    assert fitted(*words) == 0
    assert fitted.seen == [seen]


@pytest.mark.parametrize(("words", "ior"), [((), 1.3), (("--ior", "1.4"), 1.4)])
def test_a_name_stands_for_its_numbers(words, ior, fitted):
    """Jensen et al. 2001, table 1: skin1."""
    assert fitted("skin1", *words) == 0
    scattering, absorption = (0.74, 0.88, 1.01), (0.032, 0.17, 0.48)
    expected = tuple(Volume(s, a, 0.0, ior) for s, a in zip(scattering, absorption, strict=True))
    assert fitted.seen == [(expected, 200_000, None, False)]


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ((), "fit: expected a material, or --scattering and --absorption, got something else; try skin1"),
        (SCATTERING, "fit: expected a material, or"),
        (ABSORPTION, "fit: expected a material, or"),
        (("skin1", *SCATTERING), "fit: expected a material, or"),
        (("skin1", *ABSORPTION), "fit: expected a material, or"),
        (("skin1", *SCATTERING, *ABSORPTION), "fit: expected a material, or"),
        (("skin1", "--photons", "999"), "--photons: expected at least 1000, got 999; 200000 are known to 1 %"),
        (("skin1", "--threads", "0"), "--threads: expected at least 1, got 0; leave it out"),
        (("skin1", "--mm-per-unit", "0"), "--mm-per-unit: expected more than 0, got 0; say"),
        (("skin1", "--mm-per-unit", "nan"), "--mm-per-unit: expected more than 0, got nan; say"),
    ],
)
def test_what_is_wrong_is_said(words, line, fitted, capsys):
    assert fitted(*words) == 2
    assert line in " ".join(capsys.readouterr().err.split()) and not fitted.seen
