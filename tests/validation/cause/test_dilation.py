"""Too few rounds of a dilation, too many, or none: what that gives is what scenes with such a number give."""

from functools import cache

import numpy as np
import pytest
from scenes import around, sphere, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.cause.dilation import dilations
from sss_ref.validation.cause.hypothesis import INPUT, SETTING

ROUNDS = 2
AS_DRAWN = "the map was used as drawn, without dilation"


@pytest.fixture(scope="module")
def dilated(tmp_path_factory):
    """The rendering with so many rounds, of which several leave a map of 16 x 12 unfilled."""
    positions, triangles, uvs = sphere(4)
    path = written(tmp_path_factory.mktemp("ball") / "ball.obj", positions, triangles, uvs * 0.3 + 0.3)

    @cache
    def rendered(rounds):
        sizes = {"irradiance_map.width": 16, "irradiance_map.height": 12, "irradiance_map.dilate": rounds}
        return render(load_scene(around(path, 12, method="texture_space"), **sizes, **{"blur.unit": "pixel"}), "arrays")

    return rendered


def told(oracle, buffer, got, dumped=None):
    """In words -> the charge, and the pixels that it explains."""
    (this_pass,) = (each for each in oracle.scene.method.passes if buffer in each.outputs)
    case = Case(oracle, Drawing(dumped or {}), PROFILES["vulkan"])
    right = oracle[buffer]
    where = np.ones(right.shape[:2], bool)
    check = Check(this_pass.name, "stage", buffer, where, right, got, np.zeros(right.shape))
    return {charge.text: (charge, holds) for charge, holds in dilations(case, check)}


def test_other_numbers_of_rounds_and_none(dilated):
    oracle = dilated(ROUNDS)
    found = told(oracle, "irradiance_filled", oracle["irradiance_filled"])
    runs = [f"irradiance_fill runs {count} instead of 2" for count in ("1 round", "3 rounds", "4 rounds")]
    assert [*found] == [AS_DRAWN, *runs]
    assert {charge.blames for charge, _ in found.values()} == {SETTING}


@pytest.mark.parametrize("rounds", [0, 1, 3, 4])
def test_what_so_many_rounds_give_is_explained_by_them(dilated, rounds):
    oracle = dilated(ROUNDS)
    got = dilated(rounds)["irradiance_filled"] if rounds else oracle["irradiance"]
    for text, (_, holds) in told(oracle, "irradiance_filled", got).items():
        meant = f" runs {rounds} round" in text if rounds else text == AS_DRAWN
        assert holds.all() == meant, text


def test_it_begins_with_what_was_dumped(dilated):
    oracle = dilated(ROUNDS)
    dumped = {"irradiance": oracle["irradiance"] + np.float32(1)}
    assert told(oracle, "irradiance_filled", dumped["irradiance"], dumped)[AS_DRAWN][1].all()
    assert not told(oracle, "irradiance_filled", dumped["irradiance"])[AS_DRAWN][1].any()


def test_a_pass_that_reads_the_map_may_read_it_undilated(dilated):
    oracle = dilated(ROUNDS)
    names = "irradiance for irradiance_filled"
    found = told(oracle, "scattered_irradiance", oracle["scattered_irradiance"])
    ((text, (charge, holds)),) = found.items()
    assert text == f"{AS_DRAWN}: {names}" and (charge.blames, charge.names) == (INPUT, ("irradiance_filled",))
    assert not holds.all()
    undilated = dilated(0)["scattered_irradiance"]
    assert all(each.all() for _, each in told(oracle, "scattered_irradiance", undilated).values())


def test_no_other_buffer_has_anything_to_do_with_it(dilated):
    oracle = dilated(ROUNDS)
    for buffer in ("phong", "irradiance", "light_distance", "triangle"):
        assert told(oracle, buffer, oracle[buffer]) == {}
