"""All generated pages, written into a folder of their own."""

import shutil
from pathlib import Path

import command_reference
import language_reference
import mapping_reference
import scene_reference
import stage_reference

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"


def texts() -> dict[str, str]:
    """Page -> its Markdown."""
    return {
        "scene_file": scene_reference.page(),
        "mapping_file": mapping_reference.page(),
        "command_line": command_reference.page(),
        "language": language_reference.page(),
        **stage_reference.pages(),
    }


def write(folder: Path) -> None:
    """Write the pages, and copy the notebooks with the modules they import; what was there before is removed."""
    shutil.rmtree(folder, ignore_errors=True)
    for name, text in texts().items():
        page = folder / f"{name}.md"
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(text, encoding="utf-8")
    shutil.copytree(NOTEBOOKS, folder / "course", ignore=shutil.ignore_patterns("__pycache__"))
