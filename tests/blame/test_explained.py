"""Settings and inputs that explain a wrong picture, from reports that are made up."""

from types import SimpleNamespace

import pytest

from sss_ref.blame import explained as explaining
from sss_ref.blame.blaming import COMPILER, SHADER, _by_source
from sss_ref.blame.evidence import OtherDrawing
from sss_ref.blame.explained import LAXER, explained, reads_asset, right_elsewhere
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.cause.hypothesis import INPUT, SETTING, SOURCE, Hypothesis

SCENE = load_scene("sphere", preset="robust")
READERS = ("phong_shading", "lit_transmit_wrapped")  # of camera


def says(blames, text="a number", names=()):
    return Hypothesis(text, 1.0, 1.0, 0, blames, names)


def verdict(stage, passed, buffer="lit", pass_name="camera", empty=False):
    made = {"background": "", "failing": not passed, "empty": empty}
    return SimpleNamespace(stage=stage, pass_name=pass_name, buffer=buffer, passed=passed, **made)


def report(wrong, *others, hypotheses=()):
    finding = SimpleNamespace(hypotheses=tuple(hypotheses))
    return SimpleNamespace(culprit=wrong, verdicts=[*others, wrong], finding=finding)


def told(given, compiled_right=False):
    return [*explained(SimpleNamespace(scene=SCENE), None, given, "vulkan", compiled_right=compiled_right)]


@pytest.mark.parametrize(
    ("hypotheses", "compiled_right", "expected"),
    [
        ([SETTING], False, [SETTING]),
        ([INPUT], False, [INPUT]),
        ([SOURCE, SETTING], False, []),  # the first is of the source
        ([SOURCE, SETTING, INPUT], True, [SETTING, INPUT]),
        ([SETTING, INPUT], False, [SETTING]),
        ([SOURCE], True, []),
        ([SOURCE], False, []),
    ],
)
def test_explanations_by_another_source_mean_nothing_if_it_was_compiled_right(hypotheses, compiled_right, expected):
    wrong = verdict("phong_shading", False)
    given = report(wrong, hypotheses=[says(each, f"number {k}") for k, each in enumerate(hypotheses)])
    assert [blames for blames, _ in told(given, compiled_right)] == expected
    assert all(text.startswith("number ") for _, text in told(given, compiled_right))


@pytest.mark.parametrize(
    ("others", "compiled_right", "is_input"),
    [
        ([], False, True),
        ([("distance_to_camera", True)], False, True),
        ([("reader", True)], False, False),
        ([("reader", True)], True, True),
        ([("reader", False)], False, True),
        ([("reader", True), ("reader", False)], False, True),
    ],
)
def test_a_number_that_is_read_rightly_elsewhere_is_no_input(others, compiled_right, is_input):
    """It is then what a compiler's mistake looks like."""
    stages = SCENE.method["camera"].stages
    shared = next(name for name in stages[-1].reads.values() if sum(name in each.reads.values() for each in stages) > 1)
    wrong_stage, reader = [each.name for each in stages if shared in each.reads.values()][-1::-1][:2]
    judged = [verdict(reader if name == "reader" else name, passed) for name, passed in others]
    given = report(verdict(wrong_stage, False), *judged, hypotheses=[says(INPUT, names=(shared,))])
    found = told(given, compiled_right)
    assert [blames for blames, _ in found] == [INPUT] * is_input
    elsewhere = [verdict(reader, True, pass_name="another"), verdict(reader, True, empty=True)]
    assert not right_elsewhere(SCENE, says(INPUT, names=(shared,)), report(verdict(wrong_stage, False), *elsewhere))
    assert not right_elsewhere(SCENE, says(INPUT), report(verdict(wrong_stage, False), verdict(reader, True)))


@pytest.mark.parametrize(
    ("failing", "expected"), [(False, [(SETTING, "in lit, the background is another")]), (True, [])]
)
def test_a_background_alone_is_a_setting(failing, expected):
    wrong = verdict("phong_shading", False)
    wrong.background, wrong.failing = "the background is another", failing
    assert told(report(wrong, hypotheses=[says(SOURCE)])) == expected


@pytest.mark.parametrize("passing", [None, *LAXER])
def test_a_rasterizer_of_another_kind_is_a_setting(monkeypatch, passing):
    def judge(oracle, drawing, dump, profile, scope, clock):
        return SimpleNamespace(passed=passing is not None and profile == LAXER[passing])

    monkeypatch.setattr(explaining, "judge", judge)
    given = report(verdict(RASTERIZER, False, "triangle"), hypotheses=[says(SOURCE)])
    assert told(given) == ([(SETTING, f"right for a processor with {passing}")] if passing else [])
    given = report(verdict("phong_shading", False), hypotheses=[says(SOURCE)])
    assert told(given) == []


def test_the_laxer_rasterizers_are_five():
    assert [(each.subpixel_bits, each.snap, each.depth_format, each.reversed_depth) for each in LAXER.values()] == [
        (4, "nearest", "D32F", False),
        (8, "any", "D32F", False),
        (8, "nearest", "D16", False),
        (8, "nearest", "D24", False),
        (8, "nearest", "D32F", True),
    ]


@pytest.mark.parametrize(
    ("buffer", "seen", "blended"), [("depth", True, True), ("depth", False, False), ("triangle", True, False)]
)
def test_a_wrong_depth_of_the_right_triangles_may_be_blended(monkeypatch, buffer, seen, blended):
    monkeypatch.setattr(explaining, "judge", lambda *_: SimpleNamespace(passed=False))
    triangles = verdict(RASTERIZER, seen, "triangle")
    given = report(verdict(RASTERIZER, False, buffer), triangles, hypotheses=[says(SOURCE)])
    because = "triangle is right and depth is no matrix's: the draw may be blended"
    assert told(given) == ([(SETTING, because)] if blended else [])
    alone = report(verdict(RASTERIZER, False, "depth"), hypotheses=[says(SOURCE)])
    assert told(alone) == []


def test_what_reads_the_mesh_and_is_explained_by_nothing_was_given_another(monkeypatch):
    monkeypatch.setattr(explaining, "judge", lambda *_: SimpleNamespace(passed=False))
    because = "stage surface reads the mesh or a picture, and no mistake in it explains what it gives"
    assert told(report(verdict("surface", False))) == [(INPUT, because)]
    assert told(report(verdict("surface", False), hypotheses=[says(SOURCE)])) == []
    assert told(report(verdict("phong_shading", False))) == []
    camera = SCENE.method["camera"]
    assert reads_asset(camera, RASTERIZER, SCENE) and reads_asset(camera, "surface", SCENE)
    assert not reads_asset(camera, "phong_shading", SCENE)
    assert not reads_asset(SCENE.method["blur"], SCENE.method["blur"].stages[0].name, SCENE), "what passes draw is none"


@pytest.mark.parametrize(
    ("others", "whose"),
    [
        ([], None),
        ([("a", "", False)], None),
        ([("a", "lit", False)], SHADER),
        ([("a", "lit", False), ("b", "lit", False)], SHADER),
        ([("a", "lit", False), ("b", "", False)], COMPILER),
        ([("a", "lit", True)], COMPILER),
        ([("a", "", True)], None),
        ([("a", "", False), ("b", "lit", True)], COMPILER),
        ([("a", "lit", False), ("b", "", True)], SHADER),
    ],
)
def test_the_source_as_stacks_draw_it(others, whose):
    """Stack, the stage that is wrong there, whether our own shaders are too."""
    found = _by_source(SimpleNamespace(pass_name="camera"), [OtherDrawing(*each) for each in others])
    assert (found and found[0]) == whose


def test_how_a_source_came_out_in_words():
    assert str(OtherDrawing("llvmpipe", "")) == "right on llvmpipe"
    assert str(OtherDrawing("llvmpipe", "lit")) == "lit is wrong on llvmpipe"
