"""`sss-ref course` and `grade`."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter
from rich.markup import escape
from rich.table import Table

from sss_ref.cli.console import err, out, progress
from sss_ref.errors import CourseError
from sss_ref.errors.wording import told

if TYPE_CHECKING:
    from sss_ref.course.grading import Student


def course(
    folder: Annotated[Path, Parameter(help="A folder of your own, new or of an earlier call.")] = Path("course"),
    /,
    *,
    solutions: Annotated[bool, Parameter(negative="", help="The solutions of the exercises too.")] = False,
) -> int:
    """Put the course's notebooks into a folder; on one that has them, bring what is new and keep what was changed."""
    from sss_ref.course.own_folder import START, write_course

    for each in write_course(folder, solutions):
        told = f"{each.outcome}; the new version is {each.beside}" if each.beside else each.outcome
        out.print(f"{escape(each.name)}: {escape(told)}")
    out.print(f"{escape(str(folder))}: jupyter lab {escape(str(folder / START))} begins")
    return 0


def grade(
    folders: Annotated[list[Path], Parameter(help="Students' folders, or folders with such folders in them.")],
    /,
    *,
    form: Annotated[
        Literal["table", "markdown", "csv"], Parameter(name="--format", help="csv has each hint, too.")
    ] = "table",
    seconds: Annotated[float, Parameter(help="End an exercise that takes longer.")] = 30.0,
    jobs: Annotated[int | None, Parameter(show_default=False, help="Notebooks at once; one per processor.")] = None,
) -> int:
    """Say which exercises of the course are right in students' folders. Runs the students' programs, as you."""
    from sss_ref.course.grading import grade as marked

    for option, value in (("--seconds", seconds), ("--jobs", jobs)):
        if value is not None and not value > 0:
            raise CourseError(told(option, "more than 0", str(value), "give a larger number"))
    err.print("running students' programs, each with a time limit but with all that you may do yourself")
    students = []
    with progress("grading") as show:
        for student in marked(folders, seconds, jobs or os.cpu_count() or 1):
            students.append(student)
            show(f"grading: {student.name} done")
    _print(students, form)
    return 0


def _print(students: "list[Student]", form: str) -> None:
    from sss_ref.course.mark_table import LEGEND, csv_text, markdown, rows

    if form != "table":
        out.print(markdown(students) if form == "markdown" else csv_text(students), markup=False, end="")
        return
    heading, *others = rows(students)
    table = Table(*heading, box=None, pad_edge=False)
    for row in others:
        table.add_row(*map(escape, row))
    out.print(table)
    out.print(LEGEND, style="dim")
