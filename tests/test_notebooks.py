"""Every notebook runs from top to bottom, as plain Python: percent scripts need no notebook server."""

import ast
import re
import runpy
from pathlib import Path

import matplotlib
import pytest

from sss_ref.course import checks

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.py"))
EXERCISES = {
    "01_light_and_distance": checks.distance_of_a_wall,
    "02_shadow_map": checks.cover_once,
    "03_phong": checks.mirrored,
    "04_blur": checks.colour_kept,
    "05_translucency": checks.way_inside,
    "06_texture_space": checks.texel_that_holds,
    "07_screen_or_texture": checks.blur_on_the_body,
    "08_float32": checks.ulps_between,
    "09_validate_your_shader": checks.wrong_stages,
}
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


def test_every_lesson_has_an_exercise():
    assert {path.stem for path in NOTEBOOKS} == {"00_one_picture", *EXERCISES}


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs_and_its_exercise_is_still_open(path, capsys):
    names = runpy.run_path(str(path))
    if path.stem in EXERCISES:
        assert "Not yet: " in capsys.readouterr().out
        with pytest.raises(checks.NotYet):
            EXERCISES[path.stem](names["answer"])


@pytest.mark.full
@pytest.mark.parametrize("path", NOTEBOOKS[1:], ids=lambda path: path.stem)
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
