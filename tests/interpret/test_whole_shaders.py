"""Complete shaders of two passes in every language, as they are written."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from example_stages import by_turns, painted

from sss_ref.interpret.shader import DIALECTS, array_lengths, draws, fragment_shader, vertex_shader
from sss_ref.interpret.shader.text import LINE_LENGTH
from sss_ref.language import stage, vec3
from sss_ref.language.pipeline import MeshDraw, Pass, ScreenDraw
from sss_ref.passes.vertex import mesh_vertex

SHADERS = Path(__file__).parent / "shaders"
DRAW = MeshDraw(mesh_vertex.bound(clip_from_model="camera_clip_from_model"), "triangle", "depth", "coverage")
PASSES = (Pass("camera", "camera", DRAW, (painted,)), Pass("blur", "camera", ScreenDraw("coverage"), (by_turns,)))
BUFFERS = {"value", "flag", "picture", "coverage"}  # of passes before, for the second
ARRAYS = {"number": np.zeros(4, int), "weights": np.zeros(13), "material": np.zeros((65, 3))}  # the last is too long


def shaders(name):
    """All of them, each under the name of its file."""
    dialect, parts = DIALECTS[name], []
    lengths = array_lengths(ARRAYS, dialect)
    for each, buffers in zip(PASSES, (set(), BUFFERS), strict=True):
        parts.append((f"{each.name}.vert", vertex_shader(each, lengths, dialect)))
        for draw, outputs in draws(each, each.values, dialect).items():
            parts.append((f"{draw}.frag", fragment_shader(each, buffers, outputs, lengths, dialect)))
    return "\n".join(f"==== {file}\n{text}" for file, text in parts)


@pytest.mark.parametrize("name", DIALECTS)
def test_the_shaders_of_two_passes(name):
    text = shaders(name)
    assert text == (SHADERS / f"{name}.txt").read_text()
    assert max(map(len, text.splitlines())) <= LINE_LENGTH == 120


class Many(NamedTuple):
    """More than any language has targets for."""

    a: float
    b: float
    c: float
    d: float
    e: float
    f: float
    g: float
    h: float
    i: float


class Colors(NamedTuple):
    """Of 16 bytes each."""

    a: vec3
    b: vec3
    c: vec3


@stage(source="a test")
def nine(x: float) -> Many:
    """Numbers."""
    return Many(x, x, x, x, x, x, x, x, x)


@stage(source="a test")
def three(v: vec3) -> Colors:
    """Colours."""
    return Colors(v, v, v)


@pytest.mark.parametrize(
    ("name", "numbers", "colors"),
    [
        ("glsl", [8, 1], [3]),
        ("essl", [4, 4, 1], [3]),
        ("hlsl", [8, 1], [3]),
        ("vulkan", [4, 4, 1], [3]),
        ("wgsl", [8, 1], [2, 1]),
    ],
)
def test_as_many_targets_as_a_language_is_given(name, numbers, colors):
    """WebGPU has 32 bytes of a pixel in all besides."""
    for each, expected in ((nine, numbers), (three, colors)):
        this_pass = Pass("camera", "camera", ScreenDraw(), (each,))
        found = draws(this_pass, this_pass.values, DIALECTS[name])
        assert [len(outputs) for outputs in found.values()] == expected
        assert list(found) == ([f"camera_{k + 1}" for k in range(len(expected))] if len(expected) > 1 else ["camera"])


@pytest.mark.parametrize("name", DIALECTS)
def test_arrays_of_64_elements_are_no_textures(name):
    """In WGSL all are."""
    longest = 0 if name == "wgsl" else 64
    uniforms = {f"of_{count}": np.zeros(count) for count in (1, 63, 64, 65)} | {"number": 1.0}
    expected = {f"of_{count}": count for count in (1, 63, 64) if count <= longest}
    assert array_lengths(uniforms, DIALECTS[name]) == expected
