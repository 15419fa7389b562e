"""The README does what it says: every command and every program in it is run, and prints what is shown below it."""

import inspect
import re
import shlex
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sss_ref.cli import main
from sss_ref.errors import ShaderError
from sss_ref.gl.context import open_context
from sss_ref.passes.shadow_map import back_point

ROOT = Path(__file__).parents[1]
README, DOCS = (ROOT / "README.md").read_text(), ROOT / "docs"
NOT_HERE = ("python -m pip", "python -m pytest", "jupyter lab", "sss-ref view")  # .ci/run installs; servers stay
LARGEST_PICTURE = 250_000  # bytes

sys.path.insert(0, str(ROOT / "docs" / "generate"))

import images  # noqa: E402


def blocks():
    """Language, source and what is shown to come of it, "" for nothing, in the order of the page."""
    found = re.findall(r"^```(\w+)\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
    following = [*found[1:], ("", "")]
    for (language, source), (next_language, shown) in zip(found, following, strict=True):
        if language != "text":
            yield language, source, shown if next_language == "text" else ""


def draws_glsl():
    try:
        open_context().release()
    except ShaderError:
        return False
    return True


def run(line, failing):
    """One line of a shell block; `failing`: whether it is shown to find a fault."""
    for command in line.partition("#")[0].strip().split(" && "):
        run_one(command, failing)


def run_one(command, failing):
    if command.startswith(NOT_HERE):
        return
    if command.startswith("sss-ref ") and ("--run-glsl" not in command or draws_glsl()):
        assert main(shlex.split(command)[1:]) == (1 if failing and " validate " in command else 0), command
    elif not command.startswith("sss-ref "):
        subprocess.run(command, shell=True, check=True)


def test_the_first_block_is_all_it_takes_on_a_fresh_machine_and_ci_runs_just_that():
    language, source, _ = next(blocks())
    render, test = source.splitlines()
    assert language == "sh"
    assert re.fullmatch(r"python -m pip install \. && sss-ref render -o \w+", render)
    assert re.fullmatch(r'python -m pip install "\.\[[a-z,]+\]" && python -m pytest( .*)?', test)
    listed = subprocess.run([ROOT / ".ci" / "run", "--list"], capture_output=True, text=True, check=True).stdout
    assert listed == source


def told(text):
    return " ".join(text.split())


def test_everything_runs_and_prints_what_is_shown(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("EGL_PLATFORM", "surfaceless")
    monkeypatch.setenv("LIBGL_ALWAYS_SOFTWARE", "1")
    for language, source, shown in blocks():
        if language == "sh":
            for line in source.splitlines():
                run(line, shown.startswith("fail: "))
        elif "import sss_ref" in source:
            exec(source, {})
        printed = told(capsys.readouterr().out)
        for line in shown.splitlines():
            assert told(line.removesuffix(" ...")) in printed


def test_there_is_something_of_each_kind():
    found = list(blocks())
    assert [language for language, source, _ in found if "import sss_ref" in source] == ["python"]
    assert sum(source.count("sss-ref ") for language, source, _ in found if language == "sh") >= 10
    assert sum(bool(shown) for _, _, shown in found) == 3


@pytest.mark.parametrize("page", ["README.md", "docs/index.md"])
def test_the_stage_that_is_shown_is_the_one_that_runs(page):
    (shown,) = re.findall(r"```python\n(@stage.*?)```", (ROOT / page).read_text(), re.DOTALL)
    assert shown == inspect.getsource(back_point.python)


def test_every_picture_is_small_and_made_by_the_code():
    pages = [README, *(path.read_text() for path in [*DOCS.glob("*.md"), *DOCS.glob("how_to/*.md")])]
    linked = {
        Path(link).name for page in pages for link in re.findall(r"[( ](?:docs/|\.\./)?images/(\w+\.\w+)\b", page)
    }
    assert linked == set(images.PICTURES) == {path.name for path in images.IMAGES.iterdir() if path.is_file()}
    assert not {path.name for path in images.IMAGES.iterdir() if path.stat().st_size > LARGEST_PICTURE}


def test_the_poster_is_drawn_again_to_the_bit(tmp_path):
    images.poster(tmp_path / "poster.png")
    again, kept = (np.asarray(Image.open(folder / "poster.png")) for folder in (tmp_path, images.IMAGES))
    assert np.array_equal(again, kept)


def test_every_link_leads_somewhere():
    links = [link for link in re.findall(r"\]\(([^)\s]+)\)", README) if ":" not in link]
    assert links and all((ROOT / link.partition("#")[0]).exists() for link in links)


def ratios(record):
    """(preset, method, what is kept) -> times OpenGL's processor time, of two threads, as a record has it."""
    lines = (ROOT / "benchmarks" / "results" / f"{record}.txt").read_text().splitlines()
    words = [line.split() for line in lines if " 2 threads " in line]
    return {tuple(each[:3]): f"{float(each[-1]):.1f}" for each in words}


def test_the_table_of_ratios_is_that_of_the_records():
    found = [ratios("opengl_1024"), ratios("opengl_2048")]
    for preset in ("paper", "robust"):
        for method in ("screen_space", "texture_space"):
            cells = [record.get((preset, method, keep), "") for record in found for keep in ("final", "all")]
            row = " | ".join([f"{preset}, {method.replace('_', ' ')}", *cells])
            assert f"| {row} |".replace("|  |", "| |") in README


def test_what_is_told_of_the_techniques_is_the_record():
    record = (ROOT / "benchmarks" / "results" / "measure.txt").read_text()
    found = [line for line in record.partition("| technique | bust |")[2].splitlines() if "fitted" in line]
    assert len(found) == 6 and all(line in (DOCS / "measure.md").read_text() for line in found)
