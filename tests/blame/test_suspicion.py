"""Whose fault a picture is, decided from evidence that is made up; every branch of it."""

from types import SimpleNamespace

import pytest

from sss_ref.blame import blaming
from sss_ref.blame.blaming import COMPILER, INPUT, NOBODY, SETTING, SHADER, UNKNOWN, Suspicion
from sss_ref.blame.evidence import OtherDrawing

SCENE = SimpleNamespace(method={"camera": SimpleNamespace(name="camera")})
SHADERS = {"camera": "a file"}


def suspected(monkeypatch, others=(), told=(), wrong=True, shaders=SHADERS, untried="", **ours):
    """What is said of a picture whose stage `shade` is wrong.

    told: settings and inputs that explain it. ours: whether our own shaders drew it, if that is said.
    """
    asked = SimpleNamespace(scopes=[], right=None, passes=[])

    def judge(oracle, drawing, dump, profile, scope, clock):
        asked.scopes.append(scope)
        culprit = SimpleNamespace(pass_name="camera", stage="shade") if wrong else None
        finding = SimpleNamespace(not_tried=untried) if len(asked.scopes) > 1 else None
        return SimpleNamespace(culprit=culprit, summary="fail: shade" if wrong else "pass", finding=finding)

    def explained(oracle, drawing, report, profile, *, compiled_right):
        asked.right = compiled_right
        return iter(told)

    class Bench:
        def __init__(self, oracle, drawing, this_pass, profile):
            self.this_pass = this_pass

        def others(self, stacks, shaders):
            asked.passes.append((self.this_pass.name, stacks, shaders))
            return list(others)

    monkeypatch.setattr(blaming, "render", lambda scene: "oracle")
    for name, value in (("judge", judge), ("explained", explained), ("Bench", Bench)):
        monkeypatch.setattr(blaming, name, value)
    return Suspicion(SCENE, "drawing", shaders, ["a stack"], seconds=7.0, **ours).blame(), asked


def test_a_right_picture_is_nobodys_fault(monkeypatch):
    said, asked = suspected(monkeypatch, wrong=False)
    assert (said.whose, said.because) == (NOBODY, ("pass",)) and len(asked.scopes) == 1 and not asked.passes


@pytest.mark.parametrize(
    ("others", "whose"),
    [
        ([OtherDrawing("a", "shade")], SHADER),
        ([OtherDrawing("a", "shade"), OtherDrawing("b", "")], COMPILER),
        ([OtherDrawing("a", ""), OtherDrawing("b", "shade", ours=True, drew=True)], COMPILER),
    ],
)
def test_where_the_source_alone_decides_nothing_is_explained(monkeypatch, others, whose):
    said, asked = suspected(monkeypatch, others, told=[(SETTING, "a format")])
    assert said.whose == whose and len(asked.scopes) == 1 and asked.right is None
    assert said.because[:-1] == ("fail: shade", *map(str, others))
    assert asked.passes == [("camera", ["a stack"], SHADERS)]
    assert whose != COMPILER or said.because[-1].startswith(
        "our own shaders come out wrong on b" if others[1].ours else "the same source comes out otherwise on one stack"
    )


@pytest.mark.parametrize(
    ("others", "told", "whose", "because"),
    [
        ([], [], UNKNOWN, "the source of pass camera was not drawn again"),
        ([], [(INPUT, "x is 3"), (SETTING, "a format")], INPUT, "x is 3"),
        ([OtherDrawing("a", "")], [(SETTING, "a format")], SETTING, "a format"),
        (
            [OtherDrawing("a", "")],
            [],
            COMPILER,
            "the source is right, and no setting or input explains what stage shade gives",
        ),
        (
            [OtherDrawing("a", ""), OtherDrawing("b", "", drew=True)],
            [],
            INPUT,
            "b draws the source right from what is right, so something else was given",
        ),
    ],
)
def test_where_it_does_not_what_explains_the_picture_does(monkeypatch, others, told, whose, because):
    said, asked = suspected(monkeypatch, others, told)
    assert said.whose == whose and said.because == ("fail: shade", *map(str, others), because)
    assert asked.right is any(each.drew for each in others)
    assert (asked.scopes[1].seconds, asked.scopes[1].power) == (7.0, False)


def test_what_was_not_tried_is_told_at_the_end(monkeypatch):
    said, _ = suspected(monkeypatch, untried="3 of 9 numbers")
    assert said.because[-1] == "3 of 9 numbers"


@pytest.mark.parametrize(
    ("shaders", "ours", "asked_for"),
    [(SHADERS, {}, 1), ({}, {"ours": True}, 1), ({}, {}, 0), ({}, {"ours": False}, 0), ({"blur": "a file"}, {}, 0)],
)
def test_a_pass_without_files_is_drawn_again_if_our_own_shaders_drew_it(monkeypatch, shaders, ours, asked_for):
    said, asked = suspected(monkeypatch, [OtherDrawing("a", "shade")], shaders=shaders, **ours)
    assert len(asked.passes) == asked_for and said.whose == (SHADER if asked_for else UNKNOWN)
