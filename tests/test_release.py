"""What is released is what the changelog says, and it tells users' type checkers that it has types."""

import re
import tomllib
from pathlib import Path

import sss_ref

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def test_the_version_is_that_of_the_latest_release_in_the_changelog():
    headings = re.findall(r"^## (.*)$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    released = [heading for heading in headings if heading != "Unreleased"]
    version, day = released[0].split(", ")
    assert version == PROJECT["project"]["version"]
    assert re.fullmatch(r"\d{4}-\d\d-\d\d", day)


def test_the_package_says_that_it_is_typed():
    assert (Path(sss_ref.__file__).parent / "py.typed").is_file()


def test_types_are_checked_strictly():
    assert PROJECT["tool"]["mypy"]["strict"] is True
