"""Mistakes in stages that come before the one whose result was dumped, on a chain of the test's own."""

from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.language import stage, vec3
from sss_ref.validation.cause.chain import Chain
from sss_ref.validation.cause.hypothesis import INPUT, MUTANT, NUMBER, SOURCE, STAGE
from sss_ref.validation.cause.of_suspects import mutated_suspects, of_suspects
from sss_ref.validation.cause.sample import Sample
from sss_ref.validation.clock import Limit

COUNT = 60
PLACES = np.linspace(0.5, 2.0, COUNT, dtype=np.float32)


class Thick(NamedTuple):
    """A thickness."""

    thickness: float


class Lit(NamedTuple):
    """A colour."""

    lit: vec3


class Shade(NamedTuple):
    """A number."""

    shade: float


@stage(source="a test")
def thick(place: float, x: float) -> Thick:
    """The first of the chain."""
    return Thick(place * x)


@stage(source="a test")
def thicker(place: float) -> Thick:
    """In its place."""
    return Thick(place + 3.0)


@stage(source="a test")
def coloured(phong: vec3, wrap: float, translucency_scale: float, thickness: float) -> Lit:
    """The second, which is often misread."""
    return Lit(phong * (translucency_scale * thickness / (1.0 + wrap)))


@stage(source="a test")
def shaded(lit: vec3) -> Shade:
    """The last, whose result was dumped."""
    return Shade(lit.x + lit.y)


KINDS = {"place": float, "x": float, "phong": vec3, "wrap": float, "translucency_scale": float}
CHAIN = Chain((thick, coloured, shaded), "shade", KINDS)
GIVEN = [PLACES, np.float32(2), vec3(*np.float32([1, 2, 4])), np.float32(0.5), np.float32(3)]
NO_LIGHTS = SimpleNamespace(scene=SimpleNamespace(uniforms={"x": np.float32(2)}), buffers={})


def row_of(got):
    """The chain, of which this was got at all pixels, wrong at each."""
    at = np.zeros(COUNT, int), np.arange(COUNT)
    reach = np.full((COUNT, 1), 1e-4)
    return Sample(CHAIN, GIVEN, "shade", at, np.float64(got)[:, None], reach, np.ones(COUNT, bool))


def told(got, others=()):
    """In words -> the explanation, of those that fit."""
    case = SimpleNamespace(oracle=NO_LIGHTS, drawing=SimpleNamespace(buffers={}))
    puzzle = SimpleNamespace(limit=Limit(60), case=case, others={each.name: each for each in others})
    return {each.text: each for each in of_suspects(row_of(got), puzzle) if each.share == 1}


RIGHT = 2 * PLACES * 3 / 1.5 * 3  # what the chain gives


def test_the_chain_gives_what_its_stages_give():
    row = row_of(RIGHT)
    assert row.fit(row.with_inputs({})) == (1, 1)


def test_a_number_that_an_earlier_stage_reads():
    found = told(RIGHT * 2)
    assert (found["x is 4 instead of 2"].rank, found["x is 4 instead of 2"].blames) == (NUMBER, INPUT)


def test_an_earlier_stage_misread():
    (found,) = (each for text, each in told(RIGHT * 1.5).items() if "misread" in text or "wraps round" in text)
    assert found.text == "coloured: what wraps round is not divided by 1 + wrap"
    assert (found.rank, found.blames, found.kept) == (STAGE, SOURCE, 1)


def test_another_stage_in_the_place_of_an_earlier_one():
    found = told((PLACES + 3) * 3 / 1.5 * 3, (thicker, shaded))
    assert found["it computes thicker, not thick"].rank == STAGE
    assert not any("shaded" in text for text in found)


def mutated(got):
    return {each.text: each for each in mutated_suspects(row_of(got), Limit(60))}


def test_a_mistake_in_the_source_of_an_earlier_stage():
    found = mutated(PLACES / 2 * 3 / 1.5 * 3)
    (text,) = (text for text in found if "place / x" in text)
    assert text == "thick: `thickness = place / x` for `thickness = place * x`"
    assert (found[text].share, found[text].kept, found[text].rank, found[text].blames) == (1, 1, MUTANT, SOURCE)


def test_mistakes_that_compute_the_same_are_one_explanation():
    (text,) = mutated(2 * PLACES * 3 * 3)  # nothing wraps round
    assert text.count(", or ") >= 1 and "coloured: " in text


def test_what_does_not_fit_is_not_told():
    assert mutated(RIGHT + np.sin(100 * PLACES)) == {}


@pytest.mark.parametrize("pixels", [1, 59])
def test_one_that_fits_a_few_pixels_is_told_with_all_of_them(pixels):
    """Every fifteenth is tried first, the whole row afterwards."""
    got = PLACES / 2 * 3 / 1.5 * 3
    got = np.where(np.arange(COUNT) == pixels, 99, got)
    (found,) = (each for text, each in mutated(got).items() if "place / x" in text)
    assert found.share == 59 / 60
