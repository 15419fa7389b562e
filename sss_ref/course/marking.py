"""The exercises of one notebook, marked in a process of its own.

    python -m sss_ref.course.marking NOTEBOOK LESSON SKIPPED RESULTS

A lesson's pictures are not drawn for a mark. Of each cell only imports, functions, classes and plain values are run, so
that a mark takes seconds; then the checks of the cell.
"""

import ast
import json
import linecache
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from sss_ref.course.lessons import Lesson, asked_for, lessons
from sss_ref.course.notebook_file import code_cells

RIGHT, WRONG, UNTRIED, BROKEN, UNCHECKED = "right", "wrong", "not tried", "broken", "not checked"
RUNNING = "running"  # written before an exercise is checked, so that it is known which one did not end
KEPT = (ast.Import, ast.ImportFrom, ast.FunctionDef, ast.ClassDef)


def marks(cells: list[str], lesson: Lesson, skipped: frozenset[str]) -> Iterator[tuple[str, str, str]]:
    """Exercise, mark and hint, of each exercise that some cells ask for; each is `running` first.

    skipped: exercises to leave out.
    """
    shipped = _definitions(ast.parse(lesson.text))
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, cell in enumerate(cells):
        try:
            source = _python_of(cell)
            program = ast.parse(source)
        except (SyntaxError, ValueError) as error:
            yield from ((check, BROKEN, f"{error}") for check in lesson.exercises if f"checks.{check}" in cell)
            continue
        _define(program, source, f"<cell {number}>", names)
        for check, answer in asked_for(program).items():
            if check in lesson.exercises and check not in skipped:
                yield check, RUNNING, ""
                same = _definitions(program).get(ast.unparse(answer), "") == shipped[_answer_of(lesson, check)]
                yield (check, UNTRIED, "") if same else (check, *_mark(check, answer, names))


def _answer_of(lesson: Lesson, check: str) -> str:
    return ast.unparse(asked_for(ast.parse(lesson.text))[check])


def _python_of(cell: str) -> str:
    """A cell as it is, or where that is no Python, without the lines that only a notebook understands."""
    try:
        ast.parse(cell)
    except (SyntaxError, ValueError):
        return "\n".join("" if line.lstrip().startswith(("%", "!")) else line for line in cell.splitlines())
    return cell


def _define(program: ast.Module, source: str, file: str, names: dict[str, Any]) -> None:
    """Run the definitions of a cell one by one; what does not run is missing afterwards."""
    linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
    for statement in program.body:
        if isinstance(statement, KEPT) or _is_plain(statement):
            try:
                exec(compile(ast.Module([statement], []), file, "exec"), names)
            except (Exception, SystemExit) as error:
                print(f"{type(error).__name__}: {error}")


def _is_plain(statement: ast.stmt) -> bool:
    """Whether a statement names a text, a number or a list of such."""
    if not isinstance(statement, (ast.Assign, ast.AnnAssign)) or statement.value is None:
        return False
    try:
        ast.literal_eval(statement.value)
    except (ValueError, TypeError, SyntaxError, RecursionError):
        return False
    return True


def _definitions(program: ast.Module) -> Mapping[str, str]:
    """Name -> its definition as a tree, whatever its spaces and comments."""
    found = {}
    for statement in program.body:
        if isinstance(statement, (ast.FunctionDef, ast.ClassDef)):
            found[statement.name] = ast.dump(statement)
        elif isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            found[statement.targets[0].id] = ast.dump(statement.value)
    return found


def _mark(check: str, answer: ast.expr, names: Mapping[str, Any]) -> tuple[str, str]:
    """The mark of one answer, and the hint that its author sees."""
    from sss_ref.course import checks

    try:
        getattr(checks, check)(eval(ast.unparse(answer), dict(names)))
    except checks.NotYet as hint:
        return WRONG, str(hint)
    except checks.NotChecked as reason:
        return UNCHECKED, str(reason)
    except (Exception, SystemExit) as error:
        return BROKEN, f"{type(error).__name__}: {error}"
    return RIGHT, ""


def main(notebook: str, name: str, skipped: str, results: str) -> None:
    """Write the marks of a notebook's exercises, a line of JSON each, as they come."""
    (lesson,) = (each for each in lessons() if each.name == name)
    cells = code_cells(Path(notebook).read_text(encoding="utf-8"), notebook)
    with open(results, "a", encoding="utf-8") as file:
        for mark in marks(cells, lesson, frozenset(skipped.split(","))):
            print(json.dumps(mark), file=file, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
