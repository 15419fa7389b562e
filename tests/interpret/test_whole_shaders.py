"""Complete shaders of two passes in every language, as they are written."""

from pathlib import Path

import numpy as np
import pytest
from example_stages import by_turns, painted

from sss_ref.interpret.shader import DIALECTS, array_lengths, draws, fragment_shader, vertex_shader
from sss_ref.interpret.shader.text import LINE_LENGTH
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
