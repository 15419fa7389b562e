"""The viewer as a process, and its page in a Chromium without a window."""

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from importlib.util import find_spec

import pytest

from sss_ref.webgl.browser import BROWSERS

PATIENCE = 120  # seconds for anything that is waited for
BROWSER = next((found for name in BROWSERS if (found := shutil.which(name))), None)
needs_page = pytest.mark.skipif(
    BROWSER is None or find_spec("playwright") is None, reason="no Chromium or no playwright is installed"
)


class ViewerProcess:
    """`sss-ref view` with some arguments."""

    def __init__(self, *arguments):
        command = [sys.executable, "-m", "sss_ref.cli", "view", *arguments]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = re.match(r"(http://\S+/) shows ", self.process.stdout.readline())[1]

    @property
    def port(self):
        return int(re.search(r":(\d+)/", self.address)[1])

    def interrupt(self):
        """Press Ctrl-C; the exit code, and what was said."""
        self.process.send_signal(signal.SIGINT)
        try:
            out, err = self.process.communicate(timeout=PATIENCE)
        finally:
            self.process.kill()
        return self.process.returncode, out + err


@contextmanager
def viewing(*arguments):
    viewer = ViewerProcess(*arguments)
    try:
        yield viewer
    finally:
        viewer.process.kill()
        viewer.process.communicate()


@contextmanager
def chromium():
    from playwright.sync_api import sync_playwright

    as_root = ["--no-sandbox"] if os.geteuid() == 0 else []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=BROWSER, args=as_root)
        try:
            yield browser
        finally:
            browser.close()


class ViewerPage:
    """The page, opened; what it logs as an error is kept."""

    def __init__(self, browser, address, width=1300, height=820):
        self.page = browser.new_page(viewport={"width": width, "height": height}, accept_downloads=True)
        self.errors = []
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.goto(address)
        self.until(lambda: self.hash)

    @property
    def hash(self):
        """The one that is shown, with the buffer before it; "" while a small picture is."""
        return self.page.inner_text("#hash")

    def until(self, holds):
        """What `holds` gives as soon as that is something."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            found = holds()
            if found:
                return found
            self.page.wait_for_timeout(20)
        raise AssertionError(f"waited in vain; the page shows: {self.page.inner_text('body')}")

    def value(self, key):
        """What the field of a key shows."""
        return self.page.input_value(f'[data-key="{key}"] :is(input[type=text], select)')

    def another_hash(self, than):
        """The hash of the next picture that stands still and is another one."""
        return self.until(lambda: self.hash if self.hash not in ("", than) else None)

    def settled(self):
        """The hash when nothing changes any more."""
        last, since = self.hash, time.monotonic()
        while not last or time.monotonic() - since < 1.5:
            self.page.wait_for_timeout(50)
            if self.hash != last:
                last, since = self.hash, time.monotonic()
        return last

    def scene(self, path):
        """The scene file, saved."""
        with self.page.expect_download(timeout=1000 * PATIENCE) as download:
            self.page.click('[data-save="scene"]')
        download.value.save_as(path)
        return path

    def open_section(self, title):
        details = self.page.locator(f'details[data-title="{title}"]')
        if details.get_attribute("open") is None:
            details.locator("summary").click()

    def canvas(self):
        """The pixels of the picture, sRGB with alpha, row by row from the top."""
        script = """() => { const c = document.getElementById('picture');
            return Array.from(c.getContext('2d').getImageData(0, 0, c.width, c.height).data); }"""
        return self.page.evaluate(script)
