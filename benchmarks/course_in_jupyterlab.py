"""Every lesson in a real JupyterLab, as a student opens it: a double click, Run All, no error, sliders that move.

    python -m pip install ".[course,gl]" playwright
    python benchmarks/course_in_jupyterlab.py --pictures shots 01 05

Needs a Chromium (`--chromium`). Says of each lesson how many cells ran, what the exercises said, and how many sliders
redrew their picture; pictures of the page go into a folder. Exits with 1 where a cell failed or a slider is dead.
"""

import argparse
import json
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from playwright.sync_api import Locator, Page, sync_playwright

from sss_ref.course.lessons import lessons
from sss_ref.course.own_folder import START, write_course

PATIENCE = 600  # seconds that a lesson may take
TRIES = 2  # drags of a slider: the first may come while the page still moves
VIEW = {"width": 1300, "height": 1000}


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """The address of a JupyterLab on a folder."""
    command = [sys.executable, "-m", "jupyter", "lab", "--no-browser", "--port=0", "--allow-root"]
    options = [
        "--IdentityProvider.token=",
        "--LabApp.news_url=None",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    ]
    with subprocess.Popen([*command, *options], cwd=folder, stderr=subprocess.PIPE, text=True) as server:
        assert server.stderr
        found = (re.search(r"(http://(?:localhost|127\.0\.0\.1):\d+)/lab", line) for line in server.stderr)
        try:
            yield next(address[1] for address in found if address)
        finally:
            server.terminate()


def opened(page: Page, name: str) -> None:
    """Open a notebook by a double click in the list of files."""
    page.locator(".jp-DirListing-item", has_text=f"{name}.ipynb").dblclick()
    page.locator(".jp-Notebook").first.wait_for(timeout=60_000)
    page.get_by_text("| Idle").first.wait_for(timeout=120_000)


def run_all(page: Page, folder: Path, name: str) -> list[dict[str, Any]]:
    """Choose Run All Cells; the code cells as they are saved once all of them ran, or one failed."""
    page.locator(".lm-MenuBar-itemLabel", has_text=re.compile("^Run$")).click()
    page.locator(".lm-Menu-itemLabel", has_text=re.compile("^Run All Cells$")).click()
    end = time.monotonic() + PATIENCE
    while True:
        cells = saved(page, folder, name)
        failed = any(output["output_type"] == "error" for cell in cells for output in cell["outputs"])
        if failed or all(cell["execution_count"] for cell in cells) or time.monotonic() > end:
            return cells


def saved(page: Page, folder: Path, name: str) -> list[dict[str, Any]]:
    """The code cells of the notebook, saved."""
    page.keyboard.press("Control+s")
    time.sleep(4)
    book = json.loads((folder / f"{name}.ipynb").read_text(encoding="utf-8"))
    return [cell for cell in book["cells"] if cell["cell_type"] == "code"]


def sliders_that_redraw(page: Page) -> tuple[int, int]:
    """How many sliders change their picture when they are dragged, and how many there are."""
    handles = page.locator(".noUi-handle")
    return sum(
        any(redraws(page, handles.nth(n)) for _ in range(TRIES)) for n in range(handles.count())
    ), handles.count()


def redraws(page: Page, handle: Locator) -> bool:
    """Whether the picture below a slider is another one after a drag."""
    handle.scroll_into_view_if_needed()
    time.sleep(2)  # what is above may still grow
    image = handle.locator("xpath=ancestor::*[contains(@class,'widget-vbox')][1]//img").first
    before, box = image.get_attribute("src"), handle.bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 45, box["y"] + box["height"] / 2, steps=3)
    page.mouse.up()
    end = time.monotonic() + 30
    while image.get_attribute("src") == before and time.monotonic() < end:
        time.sleep(0.3)
    return image.get_attribute("src") != before


def tried(page: Page, folder: Path, name: str, pictures: Path | None) -> bool:
    """One lesson; whether all is well."""
    opened(page, name)
    cells = run_all(page, folder, name)
    moved, sliders = sliders_that_redraw(page)
    if pictures:
        page.screenshot(path=str(pictures / f"{name}.png"))
    outputs = [output for cell in cells for output in cell["outputs"]]
    failed = [output["evalue"] for output in outputs if output["output_type"] == "error"]
    run = sum(cell["execution_count"] is not None for cell in cells)
    texts = "".join("".join(output.get("text", "")) for output in outputs)
    marks = {mark: texts.count(f"{mark}") for mark in ("Right.", "Not yet:", "Not checked:")}
    print(f"{name}: {run} of {len(cells)} cells, errors {failed}, exercises {marks}, sliders {moved} of {sliders}")
    page.locator(".lm-TabBar-tabCloseIcon:visible").last.click()
    return run == len(cells) and not failed and moved == sliders


def main() -> int:
    """Try the lessons that are asked for, or all."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("numbers", nargs="*", help="of the lessons, such as 03")
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--chromium", default="/usr/bin/chromium")
    given = parser.parse_args()
    names = [each.name for each in lessons() if not given.numbers or each.name[:2] in given.numbers]
    if given.pictures:
        given.pictures.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory() as base, sync_playwright() as playwright:
        folder = Path(base, "course")
        write_course(folder)
        browser = playwright.chromium.launch(executable_path=given.chromium, args=["--no-sandbox"])
        with served(folder) as address:
            page = browser.new_page(viewport=VIEW)
            page.goto(f"{address}/lab?reset")
            page.locator(".jp-DirListing-item", has_text=START).wait_for(timeout=120_000)
            well = [tried(page, folder, name, given.pictures) for name in names]
        browser.close()
    return 0 if all(well) else 1


if __name__ == "__main__":
    sys.exit(main())
