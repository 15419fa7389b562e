"""The lessons of the course: percent scripts, one a lesson, which begin with what a teacher plans by."""

import ast
import re
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from sss_ref.scene_file.shipped import data_folder

HEAD = re.compile(
    r"\*\*Aims\.\*\* (?P<aims>.*?) \*\*Before\.\*\* (?P<before>.*?) \*\*Time\.\*\* (?P<minutes>\d+) minutes\."
)


@dataclass(frozen=True)
class Lesson:
    """A lesson by its file, such as 03_phong.py."""

    path: Path

    @property
    def name(self) -> str:
        """What its files are called, without suffix."""
        return self.path.stem

    @cached_property
    def text(self) -> str:
        """Its source."""
        return self.path.read_text(encoding="utf-8")

    @cached_property
    def title(self) -> str:
        """Its first heading, with the lesson's number."""
        return re.search(r"^# # (.*)$", self.text, re.MULTILINE)[1]  # type: ignore[index]

    @cached_property
    def plan(self) -> dict[str, str]:
        """What it says of itself: aims, before (what it builds on), minutes."""
        prose = " ".join(line.removeprefix("# ").removeprefix("> ") for line in self.text.splitlines())
        found = HEAD.search(prose)
        assert found, f"{self.path}: no Aims, Before and Time"
        return found.groupdict()

    @cached_property
    def exercises(self) -> tuple[str, ...]:
        """The names of its checks, in the order in which it asks for them."""
        return tuple(asked_for(ast.parse(self.text)))


def asked_for(program: ast.AST) -> dict[str, ast.expr]:
    """Check -> the answer it is given, by the calls `checks.verdict(checks.CHECK, ANSWER)` of a program."""
    calls = [node for node in ast.walk(program) if isinstance(node, ast.Call) and len(node.args) == 2]
    checks = [(call.args[0], call.args[1]) for call in calls if _named(call.func, "verdict")]
    return {check.attr: answer for check, answer in checks if isinstance(check, ast.Attribute)}


def _named(function: ast.expr, name: str) -> bool:
    return isinstance(function, ast.Attribute) and function.attr == name


def lessons() -> tuple[Lesson, ...]:
    """All lessons in their order."""
    return tuple(map(Lesson, sorted(shipped_folder("notebooks").glob("[0-9][0-9]_*.py"))))


def shipped_folder(name: str) -> Path:
    """A folder of the course: inside the installed package, or in a checkout beside it."""
    installed = data_folder() / name
    return installed if installed.is_dir() else data_folder().parent / name
