"""`sss-ref course`."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import out


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
