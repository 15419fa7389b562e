"""The exercises of a class: each student's notebooks marked, each in a process that ends after some seconds.

Students' programs are run as the one who grades: a time limit keeps them from hanging, nothing keeps them from reading
and writing files.
"""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from sss_ref.course.lessons import Lesson, lessons
from sss_ref.course.marking import BROKEN, RUNNING
from sss_ref.course.notebook_file import code_cells
from sss_ref.errors import CourseError
from sss_ref.errors.wording import told

MISSING, ENDLESS = "missing", "out of time"
SECONDS = 30.0


@dataclass(frozen=True)
class Mark:
    """What became of one exercise. hint: what its author was told."""

    lesson: str
    exercise: str
    result: str
    hint: str = ""


@dataclass(frozen=True)
class Student:
    """A student's folder and the marks of all exercises, in their order."""

    folder: Path
    marks: tuple[Mark, ...]

    @property
    def name(self) -> str:
        """What the folder is called."""
        return self.folder.resolve().name


def grade(folders: Sequence[Path], seconds: float = SECONDS, jobs: int = 1) -> Iterator[Student]:
    """Mark each student's folder, in this order.

    folders: of a student each, or of several students' folders. seconds: for one exercise. jobs: notebooks at once.
    Raises CourseError where there is no lesson in a folder.
    """
    with ThreadPoolExecutor(jobs) as pool:
        for folder in [student for each in folders for student in students_in(each)]:
            found = pool.map(lambda lesson, folder=folder: tuple(marks_of(folder, lesson, seconds)), lessons())
            yield Student(folder, tuple(mark for marks in found for mark in marks))


def students_in(folder: Path) -> list[Path]:
    """The folder itself if it has lessons in it, else those of its folders that have."""
    inner = sorted(path for path in folder.iterdir() if path.is_dir()) if folder.is_dir() else []
    found = [path for path in [folder, *inner] if any((path / f"{each.name}.ipynb").exists() for each in lessons())]
    if not found:
        remedy = "give a folder that sss-ref course wrote, or one with such folders in it"
        raise CourseError(told(str(folder), "lessons", "none", remedy))
    return found[:1] if found[0] == folder else found


def marks_of(folder: Path, lesson: Lesson, seconds: float) -> Iterator[Mark]:
    """The marks of one lesson's exercises."""
    path = folder / f"{lesson.name}.ipynb"
    if not path.is_file():
        yield from _all(lesson, MISSING)
        return
    try:
        code_cells(path.read_text(encoding="utf-8"), path.name)
    except (CourseError, UnicodeError, OSError) as error:
        yield from _all(lesson, BROKEN, f"{error}")
        return
    found = _marked(path, lesson, seconds)
    for exercise in lesson.exercises:
        yield Mark(lesson.name, exercise, *found.get(exercise, (MISSING, "")))


def _all(lesson: Lesson, result: str, hint: str = "") -> Iterable[Mark]:
    return (Mark(lesson.name, exercise, result, hint) for exercise in lesson.exercises)


def _marked(path: Path, lesson: Lesson, seconds: float) -> dict[str, tuple[str, str]]:
    """Exercise -> result and hint; the notebook is run again without an exercise that did not end."""
    found: dict[str, tuple[str, str]] = {}
    with TemporaryDirectory() as folder:
        results = Path(folder, "marks.jsonl")
        results.touch()
        while True:
            done = ",".join(found) or "-"
            ended = _run([str(path.resolve()), lesson.name, done, str(results)], folder, seconds)
            found |= {name: (result, hint) for name, result, hint in map(json.loads, results.read_text().splitlines())}
            stuck = [name for name, (result, _) in found.items() if result == RUNNING]
            if not stuck:
                return found
            found |= dict.fromkeys(stuck, (BROKEN, "its process ended") if ended else (ENDLESS, f"after {seconds:g} s"))
            results.write_text("")


def _run(arguments: list[str], folder: str, seconds: float) -> bool:
    """Run a notebook's exercises; whether they ended in time. What the student prints is not shown."""
    command = [sys.executable, "-m", "sss_ref.course.marking", *arguments]
    none = subprocess.DEVNULL
    process = subprocess.Popen(
        command, cwd=folder, start_new_session=True, env=_environment(), stdin=none, stdout=none, stderr=none
    )
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        _kill(process)
        return False
    return True


def _kill(process: subprocess.Popen[bytes]) -> None:
    """End a process, and what it started where the system knows groups."""
    if hasattr(os, "killpg"):
        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()


def _environment() -> dict[str, str]:
    """Ours, with figures that need no window and with the same package in reach."""
    here = str(Path(__file__).parents[2])
    return {**os.environ, "MPLBACKEND": "agg", "PYTHONPATH": os.pathsep.join([here, os.environ.get("PYTHONPATH", "")])}
