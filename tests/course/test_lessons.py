"""Every lesson says what a teacher plans by, and where its exercises are."""

import ast

import pytest

from sss_ref.course import checks
from sss_ref.course.lessons import asked_for, lessons


@pytest.mark.parametrize("lesson", lessons(), ids=lambda lesson: lesson.name)
def test_a_lesson_has_a_title_aims_and_a_time(lesson):
    assert lesson.title and all(lesson.plan.values())
    assert 5 <= int(lesson.plan["minutes"]) <= 90


@pytest.mark.parametrize("lesson", lessons()[1:], ids=lambda lesson: lesson.name)
def test_every_exercise_is_one_of_the_checks(lesson):
    assert lesson.exercises and all(callable(getattr(checks, name)) for name in lesson.exercises)
    assert lesson.title.startswith(f"{int(lesson.name[:2])}. ")


def test_an_answer_is_found_by_the_check_that_it_is_given():
    program = ast.parse("checks.verdict(checks.mirrored, answer)\nprint(checks.mirrored)\nother.verdict(one)")
    assert [(name, ast.unparse(answer)) for name, answer in asked_for(program).items()] == [("mirrored", "answer")]
