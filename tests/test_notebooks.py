"""Every notebook runs from top to bottom, as plain Python: percent scripts need no notebook server."""

import ast
import re
import runpy
from pathlib import Path

import matplotlib
import pytest

from sss_ref.course import checks

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.py"))
LONGEST_CELL = 11  # lines of code; most have fewer


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


def exercises(path):
    """Check and answer of each exercise of a lesson, by name."""
    return re.findall(r"^checks\.verdict\(checks\.(\w+), (\w+)\)$", path.read_text(), flags=re.MULTILINE)


def test_every_lesson_has_an_exercise():
    assert {path.stem for path in NOTEBOOKS if not exercises(path)} == {"00_one_picture"}


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs_and_its_exercises_are_still_open(path, capsys):
    names = runpy.run_path(str(path))
    assert capsys.readouterr().out.count("Not yet: ") == len(exercises(path))
    for check, answer in exercises(path):
        with pytest.raises(checks.NotYet):
            getattr(checks, check)(names[answer])


@pytest.mark.full
@pytest.mark.parametrize("path", [path for path in NOTEBOOKS if "HEAD" in path.read_text()], ids=lambda path: path.stem)
def test_notebook_takes_another_head(path, tmp_path):
    source = path.read_text()
    assert source.count('\nHEAD = "bust"\n') == 1
    other = tmp_path / path.name
    other.write_text(source.replace('\nHEAD = "bust"\n', '\nHEAD = "molar_enamel"\n'))
    runpy.run_path(str(other))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells_are_small_and_define_no_stage(path):
    assert max(map(len, cells(path))) <= LONGEST_CELL
    decorated = [node for node in ast.walk(ast.parse(path.read_text())) if getattr(node, "decorator_list", [])]
    assert not decorated
