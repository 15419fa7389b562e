"""All generated pages, written into a folder of their own."""

import hashlib
import shutil
from pathlib import Path

import command_reference
import course_cards
import judge_page
import language_reference
import mapping_reference
import rooms
import scene_reference
import stage_reference

from sss_ref.cache.compiled import fingerprint
from sss_ref.cache.kernel_sources import PACKAGE

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"


def texts() -> dict[str, str]:
    """Page -> its Markdown."""
    return {
        "scene_file": scene_reference.page(),
        "mapping_file": mapping_reference.page(),
        "command_line": command_reference.page(),
        "lessons": course_cards.page(),
        "plan": course_cards.plan(),
        "language": language_reference.page(),
        **stage_reference.pages(),
    }


def what_notebooks_run() -> str:
    """A hash of the package: with another one the notebooks' results are out of date."""
    texts = b"".join(path.read_bytes() for path in sorted(PACKAGE.rglob("*.py")))
    return hashlib.sha256(fingerprint().encode() + texts).hexdigest()[:16]


def write(folder: Path) -> None:
    """Write the pages, the picture of the rooms and the page that judges, and copy the notebooks.

    What was there before is removed.
    """
    shutil.rmtree(folder, ignore_errors=True)
    for name, text in texts().items():
        page = folder / f"{name}.md"
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(text, encoding="utf-8")
    site = folder / "site"
    site.mkdir()
    (site / "judge.html").write_text(judge_page.html(), encoding="utf-8")
    (folder / "rooms.svg").write_text(rooms.picture(), encoding="utf-8")
    shutil.copytree(NOTEBOOKS, folder / "course", ignore=shutil.ignore_patterns("__pycache__"))
