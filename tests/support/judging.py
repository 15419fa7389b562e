"""The page that judges, opened in a Chromium without a window that draws on the processor."""

import os
from contextlib import contextmanager

import numpy as np
from viewing import BROWSER, PATIENCE

from sss_ref.scene.load import load_scene
from sss_ref.webgl import judge_page, reduced
from sss_ref.webgl.browser import SWIFTSHADER

WRONG = 3  # what becomes of a pixel, as the page has it
DTYPES = {"float": np.float32, "int": np.int32, "bool": np.uint8}


def small(name, side=32, **overrides):
    """A scene with pictures of so many pixels."""
    return load_scene(name, **overrides, **reduced(load_scene(name, **overrides), side))


@contextmanager
def software_chromium():
    from playwright.sync_api import sync_playwright

    as_root = ["--no-sandbox"] if os.geteuid() == 0 else []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=BROWSER, args=[*SWIFTSHADER, *as_root])
        try:
            yield browser
        finally:
            browser.close()


class JudgePage:
    """The page of a scene, when it has judged every stage; what it logs as an error is kept."""

    def __init__(self, browser, folder, scene, width=1300):
        path = folder / "judge.html"
        path.write_text(judge_page(scene), encoding="utf-8")
        self.page = browser.new_page(viewport={"width": width, "height": 900}, accept_downloads=True)
        self.errors = []
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("request", lambda request: self.requested(request.url, path.as_uri()))
        self.page.goto(path.as_uri())
        self.page.wait_for_selector("#copy:enabled, .verdict.failed", timeout=1000 * PATIENCE)

    def requested(self, address, own):
        """The page asks for nothing but itself, and for what it has made itself."""
        if address != own and not address.startswith(("blob:", "data:")):
            self.errors.append(f"asked for {address}")

    def run(self, script, *arguments):
        """What a script gives that drives the page as `judge`."""
        return self.page.evaluate(script, list(arguments))

    @property
    def report(self):
        return self.run("() => judge.report()")

    @property
    def verdict(self):
        return self.page.inner_text("#verdict")

    def names(self):
        return self.run("() => judge.exams.map(({ name }) => name)")

    def edit(self, name, before, after):
        """Change the shader of a stage as a reader does, and draw it."""
        number = self.names().index(name)
        self.page.click(f"#exam-{number}")
        text = self.page.input_value("#source")
        assert before in text, text
        self.page.fill("#source", text.replace(before, after))
        self.page.click("#draw")
        return number

    def restore(self):
        self.page.click("#restore-all")

    def drawn(self, number):
        """Buffer -> what was drawn in an exam, row 0 at the bottom, and bool (H, W), which of it is wrong."""
        script = """([number]) => judge.exams[number].buffersJudged.map((one) => [
            one.name, one.kind, one.channels, one.width, one.height, Array.from(new Uint8Array(one.drawn.buffer)),
            Array.from(one.outcome)])"""
        found = {}
        for name, kind, channels, width, height, bytes_, outcome in self.run(script, number):
            values = np.frombuffer(bytes(bytes_), DTYPES[kind]).reshape(height, width, channels)
            found[name] = values[..., 0] if channels == 1 else values, np.reshape(outcome, (height, width)) == WRONG
        return found
