"""How many pictures a second arrive in Chromium while the camera is dragged, and what processor time each takes.

    python benchmarks/viewer.py head.toml --size 512
    python benchmarks/viewer.py --mesh head.obj --size 512       # the first scene that sss-ref init writes for it

Needs the extra `view`, playwright and Chromium.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from contextlib import contextmanager
from pathlib import Path

from sss_ref.scene.first_scene import write_first_scene
from sss_ref.webgl.browser import BROWSERS

STEP = 0.012  # seconds between two moves of the mouse


def measured(address: str, seconds: float, server: int) -> None:
    """Drag in the page, and print what arrives."""
    from playwright.sync_api import sync_playwright

    executable = next(filter(None, map(shutil.which, BROWSERS)))
    as_root = ["--no-sandbox"] if os.geteuid() == 0 else []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=as_root)
        page = browser.new_page(viewport={"width": 1300, "height": 820})
        page.goto(address)
        page.wait_for_selector("body[data-still=true]", timeout=120_000)
        drag(page, seconds / 2)  # learns the size that this machine has time for
        sizes: Counter[str] = Counter()
        before, used, start = pictures(page), processor_time(server), time.perf_counter()
        drag(page, seconds, lambda: sizes.update([page.inner_text("#size").partition(" ·")[0]]))
        took, count = time.perf_counter() - start, pictures(page) - before
        spent = (processor_time(server) - used) / count
        page.wait_for_selector("body[data-still=true]", timeout=120_000)
        print(f"{count / took:.1f} pictures a second while dragging, {spent * 1e3:.0f} ms of processor time each")
        print("sizes:", ", ".join(f"{size} ({share / sizes.total():.0%})" for size, share in sizes.most_common()))
        print("at rest:", page.inner_text("#size"))
        browser.close()


def drag(page, seconds: float, look=lambda: None) -> None:
    """Drag to and fro; `look` is called at every tenth move."""
    end, step = time.perf_counter() + seconds, 0
    page.mouse.move(300, 400)
    page.mouse.down()
    while time.perf_counter() < end:
        step += 1
        page.mouse.move(300 + step % 300, 400 + step % 40)
        if step % 10 == 0:
            look()
        time.sleep(STEP)
    page.mouse.up()


def pictures(page) -> int:
    """How many have arrived in the page."""
    return int(page.evaluate("document.body.dataset.pictures"))


def processor_time(process: int) -> float:
    """Seconds that a process has run (Linux)."""
    user, system = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")


@contextmanager
def served(*arguments: str):
    """A viewer's address and process."""
    command = [sys.executable, "-m", "sss_ref.cli", "view", *arguments, "--port", "0"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        yield re.match(r"\S+", process.stdout.readline())[0], process.pid
    finally:
        process.terminate()
        process.wait()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", default="default")
    parser.add_argument("--mesh", help="a mesh file, instead of a scene")
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--seconds", type=float, default=6)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        if given.mesh:
            given.scene = f"{folder}/scene.toml"
            write_first_scene(given.mesh, Path(given.scene), replace=True)
        with served(given.scene, "--size", f"{given.size}x{given.size}") as (address, process):
            measured(address, given.seconds, process)
