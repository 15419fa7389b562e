"""Every notebook runs from top to bottom, as plain Python: percent scripts need no notebook server."""

import ast
import re
import runpy
from pathlib import Path

import matplotlib
import pytest

from sss_ref.course.lessons import lessons

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.py"))
HEAD = '\nHEAD = "bust"\n'  # a line of those whose object can be another
OPEN = ("Not yet: ", "Not checked: ")  # the latter without OpenGL
LONGEST_CELL = 18  # lines of code, a stage's signature among them; most have fewer than 10


def cells(path):
    """The code cells of a notebook, without their blank lines."""
    parts = re.split(r"^# %%", path.read_text(), flags=re.MULTILINE)[1:]
    codes = [part.split("\n", 1)[1] for part in parts if not part.startswith(" [markdown]")]
    return [[line for line in code.splitlines() if line.strip()] for code in codes]


@pytest.fixture(autouse=True)
def no_window():
    from matplotlib import pyplot

    before = matplotlib.get_backend()
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")
    pyplot.switch_backend(before)


@pytest.mark.parametrize("lesson", lessons(), ids=lambda lesson: lesson.name)
def test_notebook_runs_and_its_exercises_are_still_open(lesson, capsys):
    runpy.run_path(str(lesson.path))
    told = [line for line in capsys.readouterr().out.splitlines() if line.startswith((*OPEN, "Right."))]
    assert len(told) == len(lesson.exercises) and all(line.startswith(OPEN) for line in told)


@pytest.mark.full
@pytest.mark.parametrize("path", [path for path in NOTEBOOKS if HEAD in path.read_text()], ids=lambda path: path.stem)
def test_notebook_takes_another_head(path, tmp_path):
    other = tmp_path / path.name
    other.write_text(path.read_text().replace(HEAD, '\nHEAD = "molar_enamel"\n'))
    runpy.run_path(str(other))


def test_the_lessons_of_the_paper_take_another_head():
    taking = [path.name[:2] for path in NOTEBOOKS if path.read_text().count(HEAD) == 1]
    assert taking == [f"{number:02}" for number in range(1, 10)]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells_are_small_and_define_no_stage(path):
    assert max(map(len, cells(path))) <= LONGEST_CELL
    decorated = [node for node in ast.walk(ast.parse(path.read_text())) if getattr(node, "decorator_list", [])]
    assert not decorated
