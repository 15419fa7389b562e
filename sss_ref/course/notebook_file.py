"""Notebooks as files: made of percent scripts, and read again with a student's answers in them."""

import json
from itertools import count
from typing import Any

from sss_ref.errors import CourseError
from sss_ref.errors.wording import told


def notebook(script: str) -> str:
    """A percent script as the text of an .ipynb file; the same text for the same script, so that edits are seen.

    Raises CourseError without the extra `course`.
    """
    try:
        import jupytext
    except ImportError:
        remedy = "run python -m pip install 'sss_ref[course]'"
        raise CourseError(told("course", "the extra `course`", "an installation without", remedy)) from None
    book = jupytext.reads(script, fmt="py:percent")
    book.metadata = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    for cell, number in zip(book.cells, count()):
        cell["id"] = f"cell-{number}"
    return str(jupytext.writes(book, fmt="ipynb")) + "\n"


def code_cells(text: str, name: str) -> list[str]:
    """The sources of the code cells of an .ipynb file. name: for messages.

    Raises CourseError for what is no notebook.
    """
    try:
        cells = json.loads(text)["cells"]
        return [_joined(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    except (ValueError, KeyError, TypeError, RecursionError):
        remedy = "save it again from Jupyter"
        raise CourseError(told(name, "a notebook", "something else", remedy)) from None


def _joined(source: Any) -> str:
    """A cell's source, which is one text or a list of lines."""
    return source if isinstance(source, str) else "".join(source)
