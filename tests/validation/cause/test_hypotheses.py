"""The cause by name: ports with one mistake each, and what must not be said of them."""

from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
from planted import PLANTED, oracle_of, scene_of
from planted_newer import NEWER
from scenes import around, two_slabs, written

from sss_ref import with_stage
from sss_ref.passes import shadow_map
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.cause import hypotheses as hypotheses_module
from sss_ref.validation.cause.hypothesis import SOURCE, STATE, Hypothesis
from sss_ref.validation.cause.mutants import mutants
from sss_ref.validation.scope import Scope
from sss_ref.validation.stage_by_stage import validate

SIDE = 32
SOME = [
    "camera matrix transposed",
    "light 1's map for light 2",
    "light 1's matrix for light 2",
    "model matrix left out of the map",
    "normals turned by the model matrix",
    "camera's field of view 1 % off",
    "light position x 1.0005",
    "map one pixel off",
    "map's depth of the other convention",
    "front faces culled in the map",
    "12 of 13 taps",
    "blur in gamma space",
    "highlight not tinted",
    "Blinn for Phong",
    "d = D - t",
    "N.L wrapped",
    "e^(-d^2/(2*v))",
    "Gaussians in scene units",
    "R11G11B10F",
    "map cleared to 0",
    "blur outside the stencil",
    "RGB9E5",
    "jitter left in the map",
    "light's field of view 1.3 % off",
    "irradiance map not dilated",
    "w is not divided by",
    "the position turned like a direction",
    "near and far of the map",
    "aspect of the camera",
    "exponent .7, the lit colour alone",
    "Blinn for Phong, the lit colour alone",
    "bilinear for nearest, the thickness alone",
    "the light in front for the one behind, the lit colour alone",
    "kernel_scale 2 for 1",
    "wrap 0",
    "wrap term not divided",
    "inside point moved outwards",
    "thickness of the surface itself",
    "extinction of red for all",
    "nothing fades on the way out",
    "unit forgotten",
    "follow_surface off",
    "variances as deviations",
]


@cache
def oracle(scene):
    return oracle_of(scene_of(scene, SIDE))


@pytest.mark.parametrize("name", SOME)
def test_the_cause_comes_first(name):
    (planted,) = (each for each in (*PLANTED, *NEWER) if each.name == name)
    right = oracle(planted.scene)
    found = validate(right, planted.drawn(right.scene), explain=Scope(power=False, seconds=300))
    assert not found.passed and planted.is_named_by(found.explanations[0]), found.explanations


@pytest.fixture(scope="module")
def slabs(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("slabs") / "slabs.obj", *two_slabs())
    return render(load_scene(around(path, 48)), "arrays")


def test_what_would_leave_the_wrong_pixels_wrong_explains_nothing(slabs):
    """A few wrong pixels in a buffer that a cut at 0 and 1 leaves as it is."""
    image = slabs["image"] * np.float32(0)
    right = slabs.buffers | {"image": slabs["image"].copy()}
    right["image"][20:24, 20:24] = 0.123 + image[20:24, 20:24]
    found = validate(slabs, right)
    assert not found.passed and found.explanations == []


def test_what_makes_right_pixels_wrong_explains_nothing(slabs):
    """Twelve pixels hold halves: "it was stored as float16" would make the others wrong."""
    lit = slabs["lit"].copy()
    rows, columns = (axis[:12] for axis in np.nonzero(slabs["triangle"] >= 0))
    lit[rows, columns] = lit[rows, columns].astype(np.float16)
    assert not any("float16" in each for each in validate(slabs, {"lit": lit}).explanations)


def test_no_value_of_another_unit_is_tried_in_the_place_of_one():
    """The light's colour for the normal gives as steep a cosine as a bias that has lost its slope."""
    sizes = {f"{table}.{axis}": 64 for table in ("camera", "shadow_map") for axis in ("width", "height")}
    scene = load_scene("figure3_with", preset="robust", **sizes)
    stage = shadow_map.directly_lit_slope
    body = next(each.body for each in mutants(stage) if each.wrong == "bias = bias_abs + bias_slope * texel_width")
    wrong = render(with_stage(scene, stage.name, stage.with_body(body))).buffers
    found = validate(oracle_of(scene), wrong, explain=Scope(power=False, seconds=300))
    assert found.culprit.stage == stage.name and "`bias = bias_abs" in found.explanations[0]
    assert not any(each.endswith("for normal_world") for each in found.explanations)


def test_simple_explanations_come_before_mutants_and_whole_ones_before_others():
    fits = {"a": (1.0, 1.0, 3), "b": (0.99, 1.0, 0), "c": (1.0, 1.0, 1)}
    given = [Hypothesis(text, *fit, SOURCE) for text, fit in fits.items()]
    assert [each.text for each in sorted(given, key=lambda each: each.order)] == ["c", "a", "b"]


def fit(text, share=1.0, rank=STATE):
    return Hypothesis(text, share, 1.0, rank, SOURCE)


@pytest.mark.parametrize(("wrong", "told"), [(7, ["cleared"]), (8, ["a"])])
def test_of_fewer_than_eight_wrong_pixels_only_the_background_is_explained(monkeypatch, wrong, told):
    monkeypatch.setattr(hypotheses_module, "backgrounds", lambda check, drawn: [("cleared", 1.0), ("beside", 0.5)])
    monkeypatch.setattr(hypotheses_module, "_in_turn", lambda puzzle: iter([[fit("a")]]))
    puzzle = SimpleNamespace(wrong=np.arange(20) < wrong, check=None, drawn=None)
    found = hypotheses_module.hypotheses(puzzle)
    assert [each.text for each in found] == told and found[0].kept == 1


def test_once_a_kind_fits_no_other_is_tried_and_eight_are_told(monkeypatch):
    def kinds(puzzle):
        yield [fit("none", 0.5)]
        yield [fit(str(number), 1 - number / 1000) for number in (9, 8, 7, 6, 5, 4, 3, 2, 1)]
        raise AssertionError("tried on")

    monkeypatch.setattr(hypotheses_module, "_in_turn", kinds)
    found = hypotheses_module.hypotheses(SimpleNamespace(wrong=np.ones(8, bool)))
    assert [each.text for each in found] == ["1", "2", "3", "4", "5", "6", "7", "8"]
    monkeypatch.setattr(hypotheses_module, "_in_turn", lambda puzzle: [[fit("none", 0.5)]])
    assert hypotheses_module.hypotheses(SimpleNamespace(wrong=np.ones(8, bool))) == []
