"""Every check takes the solution, and has a hint for whatever else it is given: at least 40 answers a lesson."""

import inspect
import re
import textwrap

import pytest
from exercise_answers import kind_of, solutions, wrong_answers

from sss_ref.course import checks
from sss_ref.course.lessons import lessons
from sss_ref.errors import ShaderError
from sss_ref.gl.context import open_context

SOLUTIONS = solutions()
KINDS = {  # of the exercises of lessons that ask for other things: a random walk is no stage
    **dict.fromkeys(("10_diffusion", "11_taps_and_thickness", "12_how_far"), ["line"] * 3),
    "13_your_own_method": ["port"] * 8,
}
SENTENCES = re.compile(r"[.?!](?= |$)")


def draws_glsl():
    try:
        open_context().release()
    except ShaderError:
        return False
    return True


GLSL = draws_glsl()
OWN = {lesson.name: [getattr(checks, name) for name in lesson.exercises] for lesson in lessons()[1:]}


def tried(check, answer, capsys):
    checks.verdict(check, answer)
    return capsys.readouterr().out


@pytest.mark.parametrize("check", SOLUTIONS, ids=lambda check: check.__name__)
def test_the_solution_is_right(check, capsys):
    if kind_of(check) == "shader" and not GLSL:
        pytest.skip("no OpenGL: pip install 'sss_ref[gl]', and Debian's packages of CONTRIBUTING.md")
    assert tried(check, SOLUTIONS[check], capsys) == "Right.\n"


@pytest.mark.parametrize("lesson", OWN)
def test_whatever_else_it_is_given_gets_a_hint(lesson, capsys):
    for check in OWN[lesson]:
        for answer in wrong_answers(check, SOLUTIONS[check]):
            told = tried(check, answer, capsys)
            assert told.startswith("Not yet: " if GLSL or kind_of(check) != "shader" else "Not "), (check, answer)
            assert told.count("\n") == 1 and len(SENTENCES.findall(told)) <= 3, told  # the first is "Not yet"'s own
            assert not secret(SOLUTIONS[check]) & set(told.split("`")), told


@pytest.mark.parametrize("lesson", OWN)
def test_a_lesson_is_tried_with_40_answers(lesson):
    assert sum(len(wrong_answers(check, SOLUTIONS[check])) + 1 for check in OWN[lesson]) >= 40


@pytest.mark.parametrize("lesson", OWN)
def test_a_lesson_asks_for_three_things_most_for_a_line_a_stage_and_a_shader(lesson):
    assert [kind_of(check) for check in OWN[lesson]] == KINDS.get(lesson, ["line", "stage", "shader"])


def secret(solution):
    """What a hint must not hold: the lines of a solution, and the stages that are the answer of lesson 9."""
    source = solution if isinstance(solution, str) else textwrap.dedent(inspect.getsource(solution))
    lines = {line.strip() for line in source.splitlines() if "return" in line or " = " in line}
    return lines | {line.partition("return ")[2].rstrip(";") for line in lines} - {""}


@pytest.mark.parametrize(
    ("answer", "hint"),
    [
        (lambda: None, "gives nothing|gives a NoneType"),
        (lambda: {"A": "shadow_lokup_nearest"}, "no stage is called 'shadow_lokup_nearest': did you mean"),
        (lambda: {"A": "zzz"}, "no stage is called 'zzz': the report"),
        (lambda: {"A": 3}, "for A you say the number 3"),
    ],
)
def test_a_stage_that_there_is_not_is_told(answer, hint):
    with pytest.raises(checks.NotYet, match=hint):
        checks.wrong_stages(answer)


@pytest.mark.parametrize(
    ("answer", "hint"),
    [
        (lambda depth, angle: None, "gives nothing back. Does every way"),
        (lambda depth, angle: "2", r"gives a text \('2'\), where a number is expected"),
        (lambda depth, angle: (2.0, 1.0), "gives a tuple of 2, where a number"),
        (lambda depth, angle: [2.0], "gives a list of 1, where a number"),
        (lambda depth, angle: __import__("numpy").zeros(3), r"an array of shape \(3,\) and type float64, where"),
        (lambda depth, angle: depth / 0, "stops with ZeroDivisionError in `.*depth / 0"),
        (lambda depth: depth, "called with 2 arguments, which it does not take"),
        (2.0, "what is checked is the number 2, not a function"),
        (lambda depth, angle: float("nan"), "gives nan or infinity"),
    ],
)
def test_a_wrong_kind_of_line_is_told(answer, hint):
    with pytest.raises(checks.NotYet, match=hint):
        checks.distance_of_a_wall(answer)


def test_without_opengl_it_is_said_what_is_missing(monkeypatch, capsys):
    def refused():
        raise ShaderError("gl: expected OpenGL 4.0, got none; check the driver")

    monkeypatch.setattr("sss_ref.gl.context.open_context", refused)
    told = tried(checks.lambert_in_glsl, SOLUTIONS[checks.lambert_in_glsl], capsys)
    assert told == "Not checked: gl: expected OpenGL 4.0, got none; check the driver\n"
