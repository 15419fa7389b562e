"""A folder of the student's own: the lessons as notebooks, and what was already worked on left as it is."""

import hashlib
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from sss_ref.course.lessons import Lesson, lessons, shipped_folder
from sss_ref.course.notebook_file import notebook
from sss_ref.errors import CourseError
from sss_ref.errors.wording import told

RECORD = ".sss_ref_course.json"  # file -> the hash of what was written there
SOLUTIONS = "solutions"
START = "START.ipynb"
NEW, RENEWED, SAME, KEPT = "new", "renewed", "as it was", "yours, kept"

WELCOME = """# %% [markdown]
# # Real-time subsurface scattering: the course
#
# Open the lessons in their order, by a double click on the left or by a click here, and run each from top to bottom:
# *Run, Run All Cells*. Answers are written where it says `change this`; *Run All* tells what is right. Everything
# you save stays in this folder; `sss-ref course` on it brings what is new and leaves what you changed as it is.
#
# | lesson | minutes | aims |
# |---|---|---|
{table}
#
# ## Does everything run here?

# %%
import sss_ref
from sss_ref.course import figures, small_scenes

_, (panel,) = figures.row(1, height=3.2)
figures.picture(panel, sss_ref.render(small_scenes.load("figure3_with")).image, "If you see this, you can begin")
"""


@dataclass(frozen=True)
class LaidOut:
    """What became of one file of the folder; beside: where the new version went if the old one was kept."""

    name: str
    outcome: str
    beside: str = ""


def write_course(folder: Path, solutions: bool = False) -> list[LaidOut]:
    """Write the course into a folder, or what is new of it into one that has it; edited files stay as they are.

    solutions: those of the exercises too, into a folder `solutions`.
    Raises CourseError for a folder with something else in it, and without the extra `course`.
    """
    before = written_before(folder)
    files = dict(_files(solutions))
    folder.mkdir(parents=True, exist_ok=True)
    placed = [_placed(folder, name, text, before.get(name)) for name, text in files.items()]
    record = {**before} | {name: _hash(text.encode()) for name, text in files.items()}
    (folder / RECORD).write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    return placed


def _files(solutions: bool) -> Iterator[tuple[str, str]]:
    """Name in the folder, and text, of every file."""
    yield START, notebook(WELCOME.format(table="\n".join(map(_row, lessons()))))
    for lesson in lessons():
        yield f"{lesson.name}.ipynb", notebook(lesson.text)
    for path in sorted(shipped_folder(SOLUTIONS).glob("*.py")) if solutions else []:
        yield f"{SOLUTIONS}/{path.name}", path.read_text(encoding="utf-8")


def _row(lesson: Lesson) -> str:
    plan = lesson.plan
    return f"# | [{lesson.title}]({lesson.name}.ipynb) | {plan['minutes']} | {plan['aims']} |"


def written_before(folder: Path) -> Mapping[str, str]:
    """File -> hash of what was written into the folder before; nothing into a new one.

    Raises CourseError for a folder with something else in it.
    """
    path = folder / RECORD
    if path.is_file():
        try:
            return {str(name): str(each) for name, each in json.loads(path.read_text(encoding="utf-8")).items()}
        except (ValueError, AttributeError, RecursionError):
            raise CourseError(told(str(path), "the course's record", "another text", "delete the file")) from None
    if folder.exists() and not (folder.is_dir() and not any(folder.iterdir())):
        came = "one with other files" if folder.is_dir() else "a file"
        raise CourseError(told(str(folder), "a new or empty folder, or the course's own", came, "choose another"))
    return {}


def _placed(folder: Path, name: str, text: str, before: str | None) -> LaidOut:
    """Write one file unless the student has changed it. before: the hash of what was written there, if anything was."""
    path, new = folder / name, text.encode()
    if not path.exists():
        _write(path, new)
        return LaidOut(name, NEW)
    found = _hash(path.read_bytes())
    if found == _hash(new):
        return LaidOut(name, SAME)
    if found == before:
        _write(path, new)
        return LaidOut(name, RENEWED)
    if before == _hash(new):
        return LaidOut(name, KEPT)
    beside = path.with_suffix(f".new{path.suffix}")
    _write(beside, new)
    return LaidOut(name, KEPT, beside.name)


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(content)


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()
