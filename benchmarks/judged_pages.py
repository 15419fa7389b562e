"""Opens the page that judges of every shipped scene in Chromium: python benchmarks/judged_pages.py --planted.

SwiftShader draws them, a right processor. One row per scene, and per technique on one of them: the page's size, the
processor's seconds to write it, the seconds until the browser has judged it, its stages, and how many were called
wrong. With --planted also how many of the mistakes that the page has to plant are named at their stage, by the first
wrong stage and no other.
"""

import argparse
import os
import shutil
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, sync_playwright

from sss_ref.scene import scene_names
from sss_ref.scene.load import load_scene
from sss_ref.webgl import judge_page, reduced
from sss_ref.webgl.browser import BROWSERS, SWIFTSHADER

TECHNIQUES = ("texture_space", "separable", "burley", "preintegrated", "gaussian_texture")
PRESETS = ("published", "paper", "robust")
PATIENCE = 600_000  # milliseconds for a page
PLANT = """() => judge.mistakes.map((_, index) => {
    judge.plant(index);
    const planted = judge.exams[judge.chosen].name;
    judge.drawChosen();
    const { first_wrong, stages } = judge.report();
    judge.restore([judge.chosen]);
    return [planted, first_wrong, stages.filter(({ state }) => state === "failed" || state === "refused").length];
})"""


def main() -> None:
    """Print the rows."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--side", type=int, default=48, help="pixels of the longer side of each picture")
    parser.add_argument("--planted", action="store_true", help="plant every mistake too")
    given = parser.parse_args()
    as_root = ["--no-sandbox"] if os.geteuid() == 0 else []
    chromium = next(found for name in BROWSERS if (found := shutil.which(name)))
    print(f"{'scene':<34} {'MB':>5} {'made':>5} {'judged':>7} {'stages':>7} {'wrong':>6} {'named':>9}")
    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=chromium, args=[*SWIFTSHADER, *as_root])
        for name, overrides in cases():
            print(row(browser, Path(folder) / "page.html", name, overrides, given), flush=True)
        browser.close()


def cases() -> Iterator[tuple[str, dict[str, Any]]]:
    """Scenes, with what is put on top of each."""
    yield from ((name, {}) for name in scene_names())
    yield from (("figure3_with", {"method": method}) for method in TECHNIQUES)
    yield from (("figure3_with", {"preset": preset}) for preset in PRESETS)
    yield "figure5", {"preset": "published"}


def row(browser: Browser, path: Path, name: str, overrides: dict[str, Any], given: argparse.Namespace) -> str:
    """What is printed of a scene."""
    start = time.process_time()
    scene = load_scene(name, **overrides, **reduced(load_scene(name, **overrides), given.side))
    path.write_text(judge_page(scene), encoding="utf-8")
    made, began = time.process_time() - start, time.perf_counter()
    page = browser.new_page()
    page.goto(path.as_uri())
    page.wait_for_selector("#copy:enabled", timeout=PATIENCE)
    judged = time.perf_counter() - began
    states = [stage["state"] for stage in page.evaluate("() => judge.report()")["stages"]]
    wrong = sum(state in ("failed", "refused") for state in states)
    planted = page.evaluate(PLANT) if given.planted else []
    named = sum(first == own and count == 1 for own, first, count in planted)
    page.close()
    told = f"{named} of {len(planted)}" if given.planted else ""
    label = " ".join([name, *overrides.values()])
    size = path.stat().st_size / 1e6
    return f"{label:<34} {size:5.2f} {made:5.1f} {judged:7.1f} {len(states):7d} {wrong:6d} {told:>9}"


if __name__ == "__main__":
    main()
