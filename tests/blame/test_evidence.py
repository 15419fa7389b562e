"""How shaders come out on stacks that are made up: which are asked, with what, and what counts."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.blame import evidence
from sss_ref.blame.evidence import OURS, Bench, OtherDrawing
from sss_ref.blame.stacks import ESSL, GLSL, Stack
from sss_ref.validation.accept.dumped import Drawing

BUFFERS = {name: np.full((1, 2), number) for number, name in enumerate(("lit", "mask", "image", "blurred"))}
SHADERS = {"camera": "a wrong file", "other": "not of this pass"}
VULKAN, OWN = "vulkan", SimpleNamespace(name="its own")


class Method(SimpleNamespace):
    """A method whose buffers are these; its uniforms are not among them."""

    outputs = tuple(BUFFERS)


def bench(monkeypatch, failing=(), dumped=None, device=None, passes="camera"):
    """A pass that reads `lit`, `mask` and a uniform and writes `image`; what is judged of it is kept."""
    judged = []

    def validate(oracle, buffers, profile, explain):
        judged.append((buffers, profile))
        told = [
            ("before", "lit", True),
            ("shade", "image", "image" in failing),
            ("blur", "blurred", "blurred" in failing),
        ]
        verdicts = [SimpleNamespace(stage=stage, buffer=buffer, failed=failed) for stage, buffer, failed in told]
        return SimpleNamespace(verdicts=verdicts)

    class Oracle(dict):
        scene = SimpleNamespace(method=Method())

    monkeypatch.setattr(evidence, "validate", validate)
    this_pass = SimpleNamespace(name=passes, needs={"lit", "mask", "exponent"})
    return Bench(Oracle(BUFFERS), Drawing(dumped or {}, device=device), this_pass, VULKAN), judged


def stack(name="a stack", language=GLSL, drawn=None, profile=None, wrong_ours=False):
    """One that writes `image`, and keeps what it was asked to draw."""

    def draw(scene, this_pass, read, shaders):
        if drawn is not None:
            drawn.append((this_pass.name, read, shaders))
        return {"image": "ours" if shaders is OURS else "theirs"}

    return Stack(name, language, draw, profile)


def test_a_pass_is_drawn_from_what_was_dumped_or_else_the_references(monkeypatch):
    dumped, drawn = np.full((1, 2), 9), []
    one, judged = bench(monkeypatch, dumped={"mask": dumped})
    assert one.wrong_on(stack(drawn=drawn), SHADERS) == ""
    ((name, read, shaders),) = drawn
    assert name == "camera" and shaders == {"camera": "a wrong file"}
    assert set(read) == {"lit", "mask"} and read["lit"] is BUFFERS["lit"] and read["mask"] is dumped
    ((buffers, profile),) = judged
    assert buffers == {**read, "image": "theirs"} and profile == VULKAN


def test_without_files_for_the_pass_our_own_shaders_draw_it(monkeypatch):
    drawn = []
    one, _ = bench(monkeypatch, passes="blur")
    one.wrong_on(stack(drawn=drawn), SHADERS)
    assert drawn[0][2] is OURS


def test_a_stack_may_have_a_profile_of_its_own(monkeypatch):
    one, judged = bench(monkeypatch)
    one.wrong_on(stack(profile=OWN), SHADERS)
    assert judged[0][1] is OWN


@pytest.mark.parametrize(
    ("failing", "wrong"), [((), ""), (("image",), "shade"), (("blurred",), ""), (("image", "blurred"), "shade")]
)
def test_the_first_wrong_stage_is_one_that_wrote_something_there(monkeypatch, failing, wrong):
    """`lit` is wrong, but was given; `blurred` was not drawn."""
    one, _ = bench(monkeypatch, failing)
    assert one.wrong_on(stack(), SHADERS) == wrong


def others_of(monkeypatch, wrong, device=None, languages=(GLSL,)):
    """What is told of stacks "first", "second" and so on. wrong: of the stack and whether our own shaders draw."""
    one, _ = bench(monkeypatch, device=device)
    monkeypatch.setattr(Bench, "wrong_on", lambda _, on, shaders: wrong.get((on.name, shaders is OURS), ""))
    monkeypatch.setattr(evidence, "language_of", lambda shaders: GLSL)
    names = ("first", "second", "third")
    return one.others([stack(name, language) for name, language in zip(names, languages, strict=False)], SHADERS)


def test_stacks_of_another_language_are_not_asked(monkeypatch):
    found = others_of(monkeypatch, {("first", False): "shade"}, languages=(GLSL, ESSL, GLSL))
    assert found == [OtherDrawing("first", "shade"), OtherDrawing("third", "")]


def test_a_stack_that_draws_our_own_wrong_counts_only_if_it_drew(monkeypatch):
    wrong = {("second", True): "shade", ("second", False): "shade"}
    assert others_of(monkeypatch, wrong, languages=(GLSL, GLSL)) == [OtherDrawing("first", "")]
    found = others_of(monkeypatch, wrong, device="SECOND", languages=(GLSL, GLSL))
    assert found == [OtherDrawing("first", ""), OtherDrawing("second", "shade", ours=True, drew=True)]
    assert others_of(monkeypatch, wrong, device="second hand", languages=(GLSL, GLSL)) == [OtherDrawing("first", "")]


@pytest.mark.parametrize(("device", "drew"), [(None, False), ("", False), ("fir", True), ("another", False)])
def test_the_stack_that_drew_it_has_its_device_in_its_name(monkeypatch, device, drew):
    assert others_of(monkeypatch, {}, device) == [OtherDrawing("first", "", drew=drew)]
