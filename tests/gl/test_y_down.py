"""The page on renderers whose y points down, done on OpenGL: its snippets are put into our shaders, its mappings read.

Such a renderer is OpenGL with every clip position mirrored once more: row 0 in memory is then the top row.
"""

import re
from pathlib import Path

import numpy as np
import pytest
from opengl import needs_mesa

import sss_ref
from sss_ref.dump.read import read_dump
from sss_ref.gl import draw
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.clock import Clock
from sss_ref.validation.scope import VERDICTS_ALONE
from sss_ref.validation.stage_by_stage import judge

pytestmark = needs_mesa

PAGE = (Path(__file__).parents[2] / "docs" / "how_to" / "y_down.md").read_text()
SMALL = {f"{t}.{s}": 48 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}


def blocks(language, way):
    return re.findall(rf"```{language} {way}\n(.*?)```", PAGE, re.DOTALL)


def replacements(way):
    """The lines of the page's diffs: what goes -> what comes in its place; pairs of fragments, or whole runs."""
    for block in blocks("diff", way):
        for gone, come in re.findall(r"((?:^-.*\n)+)((?:^\+.*\n)+)", block, re.MULTILINE):
            old, new = ([line[1:] for line in lines.splitlines()] for lines in (gone, come))
            yield "\n".join(old), "\n".join(new)


def changed(text, way, used):
    """A shader with the page's snippets; `used` collects those that were."""
    for old, new in replacements(way):
        if old in text:
            used.add(old)
            text = text.replace(old, new)
    (functions,) = blocks("glsl", way) or [""]
    return re.sub(r"(?=^// Whether uv lies on the map)", functions, text, count=1, flags=re.MULTILINE)


def on_such_a_renderer(text):
    return re.sub(r"(\bgl_Position = .*;)", r"\1 gl_Position.y = -gl_Position.y;", text)


def drawn(scene, way, folder, mirrored_too=()):
    """Buffers as they lie in memory, and the snippets that were used; mirrored_too: files that mirror besides."""
    used, files = set(), {}
    for name, text in shader_files(scene.method, array_lengths(scene.uniforms)).items():
        this_pass = re.sub(r"(_\d+)?\.\w+$", "", name)
        if this_pass == "taps":
            continue
        text = text if this_pass == "irradiance_blur" else changed(text, way, used)
        text = changed(text, "mirrored", set()) if name in mirrored_too else text
        (folder / name).write_text(on_such_a_renderer(text) if name.endswith(".vert") else text)
        files.setdefault(this_pass, []).append(folder / name)
    return draw(scene, files), used


def report_of(scene, memory, folder, mapping):
    for name, array in memory.items():
        np.save(folder / f"{name}.npy", array)
    named = set(re.findall(r"\[buffers\.(\w+)\]", mapping))
    tables = [f'[buffers.{name}]\nfile = "{name}.npy"\n' for name in memory if name not in named]
    (folder / "mapping.toml").write_text(mapping + "\n" + "\n".join(tables))
    found = Drawing.read(read_dump(folder / "mapping.toml", scene))
    return judge(sss_ref.render(scene, "arrays"), found, None, "vulkan", VERDICTS_ALONE, Clock())


def test_mirrored(tmp_path):
    scene = sss_ref.load_scene("figure3_with", **SMALL)
    memory, used = drawn(scene, "mirrored", tmp_path)
    (mapping,) = blocks("toml", "mirrored")
    report = report_of(scene, memory, tmp_path, mapping)
    assert used and report.passed, report.summary
    assert {name: array.tobytes() for name, array in memory.items()} == {
        name: array.tobytes() for name, array in draw(scene).items()
    }


@pytest.mark.parametrize("keeps", ["v up", "v down"])
def test_upright(tmp_path, keeps):
    scene = sss_ref.load_scene("figure3_with", **SMALL)
    memory, used = drawn(scene, "upright", tmp_path)
    assert used == {old for old, _ in replacements("upright") if "light_uv" not in old}
    (mapping,) = blocks("toml", "upright")
    if keeps == "v down":
        memory["shadow_uv"] = np.float32([0, 1]) + memory["shadow_uv"] * np.float32([1, -1])
    else:
        mapping = mapping.partition("\n\n")[0]
    report = report_of(scene, memory, tmp_path, mapping)
    assert report.passed, report.summary
    assert not np.array_equal(memory["triangle"], draw(scene)["triangle"])


@pytest.mark.parametrize("forgotten", range(3))
def test_what_is_forgotten_is_found(tmp_path, monkeypatch, forgotten):
    """The taps, one of the two fetches; rows in the wrong order."""
    scene = sss_ref.load_scene("figure3_with", **SMALL)
    kept = list(replacements("upright"))
    if forgotten < 2:
        del kept[forgotten]
    monkeypatch.setitem(globals(), "replacements", lambda way: kept)
    memory, _ = drawn(scene, "upright", tmp_path)
    report = report_of(scene, memory, tmp_path, 'origin = "top"' if forgotten < 2 else 'origin = "bottom"')
    assert not report.passed
    assert report.culprit.stage == ("scatter_inside_surface", "shadow_lookup_nearest", "rasterizer")[forgotten]


def test_the_layout_pass_is_mirrored_alone(tmp_path):
    scene = sss_ref.load_scene("figure5", **SMALL)
    layout = {f"{each.name}.vert" for each in scene.method.passes if each.draw.layout}
    memory, used = drawn(scene, "upright", tmp_path, mirrored_too=layout)
    in_layout = [name for name in memory if scene.forms[name].target == "irradiance_map"]
    tables = [f'[buffers.{name}]\nfile = "{name}.npy"\norigin = "bottom"\n' for name in in_layout]
    report = report_of(scene, memory, tmp_path, "\n".join(['origin = "top"', *tables]))
    assert used == {old for old, _ in replacements("upright") if old.startswith("texelFetch")}
    assert in_layout and layout and report.passed, report.summary
