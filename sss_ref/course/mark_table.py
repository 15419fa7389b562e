"""The marks of a class as a table: for the screen, as Markdown, and as CSV with the hints."""

import csv
import io
from collections.abc import Iterable, Sequence
from itertools import groupby

from sss_ref.course.grading import ENDLESS, MISSING, Student
from sss_ref.course.marking import BROKEN, RIGHT, UNCHECKED, UNTRIED, WRONG

SIGNS = {RIGHT: "+", WRONG: "-", UNTRIED: ".", BROKEN: "!", ENDLESS: "!", UNCHECKED: "?", MISSING: " "}
LEGEND = "+ right, - wrong, . not tried, ! broken or out of time, ? not checked here, blank: missing"


def rows(students: Iterable[Student]) -> list[list[str]]:
    """A heading, and a row for each student: name, how many are right, and for each lesson a sign for an exercise."""
    found = [[student.name, right_of(student), *signs_of(student)] for student in students]
    first = next(iter(students), None)
    numbers = [lesson for lesson, _ in groupby(mark.lesson[:2] for mark in first.marks)] if first else []
    return [["student", "right", *numbers], *found]


def right_of(student: Student) -> str:
    """How many exercises are right, of how many."""
    return f"{sum(mark.result == RIGHT for mark in student.marks)}/{len(student.marks)}"


def signs_of(student: Student) -> list[str]:
    """Of each lesson a sign for each of its exercises."""
    by_lesson = groupby(student.marks, key=lambda mark: mark.lesson)
    return ["".join(SIGNS[mark.result] for mark in marks) for _, marks in by_lesson]


def markdown(students: Sequence[Student]) -> str:
    """The table in Markdown, with its legend."""
    heading, *others = rows(students)
    cells = [heading, ["---"] * len(heading), *([name, *(f"`{each}`" for each in rest)] for name, *rest in others)]
    lines = (f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in row)} |" for row in cells)
    return "\n".join([*lines, "", LEGEND, ""])


def csv_text(students: Iterable[Student]) -> str:
    """A line for each student and exercise, with the hint."""
    target = io.StringIO()
    writer = csv.writer(target, lineterminator="\n")
    writer.writerow(["student", "lesson", "exercise", "result", "hint"])
    for student in students:
        for mark in student.marks:
            writer.writerow([student.name, mark.lesson, mark.exercise, mark.result, _harmless(mark.hint)])
    return target.getvalue()


def _harmless(text: str) -> str:
    """A text that a spreadsheet does not take for a formula: what a student's error says is the student's."""
    return f"'{text}" if text.startswith(("=", "+", "-", "@", "\t", "\r")) else text
