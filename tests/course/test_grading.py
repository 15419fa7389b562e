"""A class is graded whatever its students hand in: right, wrong, untried, endless, broken."""

import csv
import io
import json

import pytest
from exercise_answers import SOLUTIONS

from sss_ref.cli import main
from sss_ref.course.grading import ENDLESS, MISSING, grade, students_in
from sss_ref.course.lessons import lessons
from sss_ref.course.mark_table import LEGEND, _harmless, markdown
from sss_ref.course.marking import BROKEN, RIGHT, UNTRIED, WRONG, marks
from sss_ref.course.notebook_file import code_cells, notebook
from sss_ref.errors import CourseError

pytest.importorskip("jupytext", reason="pip install 'sss_ref[course]'")

NAME = "01_light_and_distance"
(LESSON,) = (lesson for lesson in lessons() if lesson.name == NAME)
LINE, STAGE, SHADER = LESSON.exercises
OPEN = "    return depth  # change this line"
HERE = {  # the line that stands where the lesson has OPEN -> its mark
    "    return depth / math.cos(angle)": RIGHT,
    "    return 2 * depth": WRONG,
    OPEN: UNTRIED,
    "    return depth  # another comment": UNTRIED,
    "    return depth /": BROKEN,
    "    return undefined": WRONG,
    "    return (depth / math.cos(angle)\n    % 1e9)": RIGHT,
    "    return depth / math.cos(angle)\n\n\n%matplotlib inline": RIGHT,
}
APART = {  # student -> a line that wants a process of its own, and its mark
    "right": ("    return depth / math.cos(angle)", RIGHT),
    "endless": ("    __import__('time').sleep(600)", ENDLESS),
    "ends the process": ("    __import__('os')._exit(0)", BROKEN),
}


def hand_in(folder, text):
    folder.mkdir(parents=True)
    (folder / f"{NAME}.ipynb").write_text(text, encoding="utf-8")
    return folder


def own(answer):
    """The lesson as a notebook with a student's line."""
    assert LESSON.text.count(OPEN) == 1
    return notebook(LESSON.text.replace(OPEN, answer))


@pytest.fixture(scope="module")
def graded(tmp_path_factory):
    folder = tmp_path_factory.mktemp("class")
    for name, (answer, _) in APART.items():
        hand_in(folder / name, own(answer))
    hand_in(folder / "no notebook", "{")
    hand_in(folder / "no cells", json.dumps({"cells": [{"cell_type": "code"}]}))
    return {student.name: student for student in grade([folder], seconds=20, jobs=2)}


def results(student):
    return {mark.exercise: mark.result for mark in student.marks}


@pytest.mark.parametrize("answer", HERE)
def test_a_line_is_marked(answer):
    found = {name: mark for name, mark, _ in marks(code_cells(own(answer), NAME), LESSON, frozenset())}
    assert found == {LINE: HERE[answer], STAGE: UNTRIED, SHADER: UNTRIED}


@pytest.mark.parametrize("name", APART)
def test_a_student_is_marked(name, graded):
    assert results(graded[name])[LINE] == APART[name][1]


@pytest.mark.parametrize("name", APART)
def test_the_other_exercises_are_marked_all_the_same(name, graded):
    assert results(graded[name])[STAGE] == results(graded[name])[SHADER] == UNTRIED


@pytest.mark.parametrize("name", ["no notebook", "no cells"])
def test_a_broken_notebook_is_a_row(name, graded):
    assert set(results(graded[name]).values()) == {BROKEN, MISSING}
    hint = graded[name].marks[0].hint
    assert hint == f"{NAME}.ipynb: expected a notebook, got something else; save it again from Jupyter"


def test_a_lesson_that_is_not_there_is_missing(graded):
    student = graded["right"]
    assert {mark.result for mark in student.marks if mark.lesson != NAME} == {MISSING}
    assert [mark.lesson for mark in student.marks] == [lesson.name for lesson in lessons() for _ in lesson.exercises]


def test_the_hint_is_what_the_student_was_told(graded):
    *_, hint = next(
        each for each in marks(code_cells(own("    return 2 * depth"), NAME), LESSON, frozenset()) if each[2]
    )
    assert "Draw the right-angled triangle" in hint
    assert graded["endless"].marks[0].hint == "after 20 s"


def test_the_tables_have_a_row_for_each(graded):
    text = markdown([*graded.values()])
    assert len(text.splitlines()) == len(graded) + 4 and LEGEND in text
    assert "| right | `1/" in text and "| `+..` |" in text


def test_solutions_are_found_wherever_they_stand_and_whatever_else_is_in_the_notebook():
    solution = (SOLUTIONS / f"{NAME}.py").read_text(encoding="utf-8")
    calls = [f"checks.verdict(checks.{name}, {name})" for name in LESSON.exercises]
    cells = ["from sss_ref.course import checks", "%matplotlib inline\n!pip list\nopen('gone')", solution, *calls]
    found = {name: mark for name, mark, _ in marks(cells, LESSON, frozenset())}
    assert found[LINE] == found[STAGE] == RIGHT and found[SHADER] in (RIGHT, "not checked")


def test_a_folder_without_lessons_is_told(tmp_path):
    with pytest.raises(CourseError, match="expected lessons, got none; give a folder that sss-ref course wrote"):
        students_in(tmp_path)
    with pytest.raises(CourseError, match="expected lessons, got none"):
        students_in(tmp_path / "nobody")


def test_a_student_is_taken_alone_or_in_a_class(tmp_path):
    inner = hand_in(tmp_path / "class" / "ada", own(OPEN))
    (tmp_path / "class" / "other").mkdir()
    assert students_in(inner) == students_in(tmp_path / "class") == [inner]


def test_the_command_prints_csv_with_hints(tmp_path, capsys):
    hand_in(tmp_path / "ada", own("    return 2 * depth"))
    assert main(["grade", str(tmp_path / "ada"), "--format", "csv"]) == 0
    told = capsys.readouterr()
    lines = [*csv.DictReader(io.StringIO(told.out))]
    assert "running students' programs" in told.err
    assert lines[0] | {"hint": ""} == {
        "student": "ada",
        "lesson": NAME,
        "exercise": LINE,
        "result": WRONG,
        "hint": "",
    }


@pytest.mark.parametrize("option", ["--seconds=0", "--seconds=-1", "--jobs=0"])
def test_a_limit_that_is_none_is_told(option, tmp_path, capsys):
    assert main(["grade", str(tmp_path), option]) == 2
    assert f"{option.partition('=')[0]}: expected more than 0" in capsys.readouterr().err


@pytest.mark.parametrize("hint", ["=HYPERLINK(1)", "+1", "-1", "@SUM(1)"])
def test_a_hint_is_no_formula_of_a_spreadsheet(hint):
    assert _harmless(hint) == f"'{hint}"
    assert _harmless("a=b") == "a=b"


def test_code_cells_take_a_source_in_lines_or_as_one_text():
    cells = [{"cell_type": "code", "source": source} for source in ("a\nb", ["a\n", "b"])]
    assert code_cells(json.dumps({"cells": cells}), "x") == ["a\nb"] * 2
