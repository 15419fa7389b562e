"""What `sss-ref course` and `grade` print; the folders and the marks have tests of their own."""

import os
from pathlib import Path

import pytest

from sss_ref.cli import main
from sss_ref.course.grading import Mark, Student
from sss_ref.course.mark_table import LEGEND, csv_text, markdown
from sss_ref.course.marking import RIGHT, WRONG
from sss_ref.course.own_folder import START, LaidOut


def test_a_course_says_of_each_file_what_became_of_it(monkeypatch, capsys):
    seen = []

    def write_course(folder, solutions):
        seen.append((folder, solutions))
        return [LaidOut("a[b].ipynb", "new"), LaidOut("c.ipynb", "kept", "c.new.ipynb")]

    monkeypatch.setattr("sss_ref.course.own_folder.write_course", write_course)
    assert main(["course"]) == main(["course", "my[bold]", "--solutions"]) == 0
    assert seen == [(Path("course"), False), (Path("my[bold]"), True)]
    files = "a[b].ipynb: new\nc.ipynb: kept; the new version is c.new.ipynb\n"
    starts = (f"course: jupyter lab course/{START} begins\n", f"my[bold]: jupyter lab my[bold]/{START} begins\n")
    assert capsys.readouterr().out == "".join(files + start for start in starts)


@pytest.fixture
def graded(monkeypatch):
    """Runs the command on two students; what was asked of the grading."""
    marks = [Mark("01_first", f"exercise {k}", result, "why [not]") for k, result in enumerate((RIGHT, WRONG, RIGHT))]
    students = [Student(Path("/of/al[b]"), tuple(marks)), Student(Path("/of/x"), tuple(marks[:1]))]
    seen = []

    def grade(folders, seconds, jobs):
        seen.append((folders, seconds, jobs))
        yield from students

    monkeypatch.setattr("sss_ref.course.grading.grade", grade)

    def run(*words):
        return main(["grade", "class", *words])

    run.students, run.seen = students, seen
    return run


def test_marks_are_a_table(graded, capsys):
    assert graded() == 0
    told = capsys.readouterr()
    lines = [line.rstrip() for line in told.out.splitlines()]
    assert lines == ["student  right  01", "al[b]    2/3    +-+", "x        1/1    +", LEGEND]
    assert told.err == "running students' programs, each with a time limit but with all that you may do yourself\n"


@pytest.mark.parametrize(("form", "text"), [("markdown", markdown), ("csv", csv_text)])
def test_marks_have_other_forms(form, text, graded, capsys):
    assert graded("--format", form) == 0
    assert capsys.readouterr().out == text(graded.students)


@pytest.mark.parametrize(("processors", "jobs"), [(3, 3), (None, 1)])
def test_a_notebook_is_run_on_each_processor_unless_told_otherwise(processors, jobs, graded, monkeypatch):
    monkeypatch.setattr(os, "cpu_count", lambda: processors)
    assert graded() == graded("--jobs", "1", "--seconds", "0.5") == 0
    assert graded.seen == [([Path("class")], 30.0, jobs), ([Path("class")], 0.5, 1)]


@pytest.mark.parametrize("words", [("--seconds", "0"), ("--seconds", "-1"), ("--seconds", "nan"), ("--jobs", "0")])
def test_no_time_and_no_job_are_refused(words, graded, capsys):
    assert graded(*words) == 2
    assert f"{words[0]}: expected more than 0, got" in capsys.readouterr().err and not graded.seen
