"""A page drawn by a browser without a window."""

import base64
import io
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from html import unescape
from pathlib import Path

import numpy as np

from sss_ref.errors import ShaderError
from sss_ref.scene.scene import Scene
from sss_ref.webgl.content import page

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
SWIFTSHADER = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")  # OpenGL that needs no GPU
AS_ROOT = ("--no-sandbox",)  # without, Chromium refuses to run; the page is our own
QUIET = (
    "--headless",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-gpu-watchdog",
    "--disable-quic",
    "--disable-sync",
)
MOST_TOLD = 500  # letters of what a browser that fails has to say, which can be much
LINK = re.compile(r'<a download="(\w+)\.npy" href="data:[^;]*;base64,([^"]*)"')
ERROR = re.compile(r'<p id="error">([^<]+)</p>')


def draw(
    scene: Scene,
    keep: str | Iterable[str] = "all",
    options: Sequence[str] = SWIFTSHADER,
    seconds: float = 600,
) -> dict[str, np.ndarray]:
    """Draw a scene in Chromium: the buffers of its method by name, (H, W) or (H, W, C), row 0 at the bottom.

    keep: which buffers, as in `sss_ref.render`. seconds: how long it may take.
    options: for its command line; those given here draw on the processor.
    Raises ShaderError where there is no Chromium, or where its WebGL does not draw the page.
    """
    return printed_buffers(page(scene, keep), options, seconds)


def printed_buffers(text: str, options: Sequence[str] = SWIFTSHADER, seconds: float = 600) -> dict[str, np.ndarray]:
    """The buffers that a page draws. Raises ShaderError as `draw` does."""
    as_root = AS_ROOT if hasattr(os, "geteuid") and os.geteuid() == 0 else ()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "page.html"
        path.write_text(text, encoding="utf-8")
        shown = _printed(
            f"{path.as_uri()}#inline", [*QUIET, *options, *as_root, f"--user-data-dir={folder}/profile"], seconds
        )
    problem, links = ERROR.search(shown), LINK.findall(shown)
    if problem or not links:
        reason = unescape(problem[1]) if problem else "a page without buffers"
        raise ShaderError(f"webgl: expected every pass to be drawn, got {reason}")
    return {name: np.load(io.BytesIO(base64.b64decode(data))) for name, data in links}


def found_browser() -> str:
    """The path of Chromium. Raises ShaderError where there is none."""
    browser = next((found for name in BROWSERS if (found := shutil.which(name))), None)
    if browser is None:
        raise ShaderError(f"webgl: expected one of {', '.join(BROWSERS)}, got none; install Chromium")
    return browser


def _printed(address: str, options: Sequence[str], seconds: float) -> str:
    """The page as it is after its script has run."""
    browser = found_browser()
    command = [browser, *options, "--dump-dom", address]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        raise ShaderError(f"webgl: expected a page drawn in {seconds} s, got none; draw a smaller picture") from None
    if done.returncode:
        came = f"exit code {done.returncode}: {done.stderr[-MOST_TOLD:]}"
        raise ShaderError(
            f"webgl: expected {browser} to run, got {came}; try it by hand, with other options if need be"
        )
    return done.stdout
