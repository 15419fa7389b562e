"""Where constants lie in their buffer: by hand, and as the reference compiler has them in Vulkan and in Direct3D."""

import re
import shutil
import struct
import subprocess

import numpy as np
import pytest

from sss_ref.interpret.shader import DIALECTS, array_lengths, shader_files
from sss_ref.interpret.shader.constants import packed, places
from sss_ref.language.types import Array, ivec2, mat3, mat4, vec2, vec3, vec4
from sss_ref.scene.load import load_scene

TOOLS = [shutil.which(name) for name in ("glslangValidator", "spirv-dis")]
KINDS = {"a": float, "b": vec2, "c": vec3, "d": int, "e": mat3, "f": bool, "g": vec4, "h": Array[vec2], "i": float}
OFFSETS = {"a": 0, "b": 8, "c": 16, "d": 28, "e": 32, "f": 80, "g": 96, "h": 112, "i": 160}
FLAGS = {  # --hlsl-offsets: Direct3D's own rules for what does not say where it lies
    "vulkan": ["-V"],
    "hlsl": ["-D", "-e", "main", "-V", "--auto-map-bindings", "--auto-map-locations", "--hlsl-offsets"],
}
FIELD = re.compile(r"OpMemberName %Uniforms (\d+) \"(\w+)\"")
PLACE = re.compile(r"OpMemberDecorate %Uniforms (\d+) Offset (\d+)")


def test_places_by_hand():
    """A number fits behind a vec3, a vec2 begins at multiples of 8, nothing shares the last row of a matrix."""
    found = places(KINDS, {"h": 3})
    assert found.offsets == OFFSETS and found.size == 176


def test_bytes_by_hand():
    kinds = {"m": mat3, "v": vec3, "n": int, "h": Array[vec2], "p": ivec2, "t": bool, "w": mat4}
    values = {
        "m": np.arange(9.0).reshape(3, 3),
        "v": np.float32([0.1, 0.2, 0.3]),
        "n": -7,
        "h": [[1.5, 2.5], [3.5, 4.5]],
        "p": [3, -4],
        "t": True,
        "w": np.eye(4),
    }
    where = places(kinds, {"h": 2})
    expected = struct.pack("<4f4f4f", 0, 3, 6, 0, 1, 4, 7, 0, 2, 5, 8, 0)
    expected += struct.pack("<3fi", *values["v"], -7)
    expected += struct.pack("<2f8x2f8x", 1.5, 2.5, 3.5, 4.5)
    expected += struct.pack("<iii4x", 3, -4, 1)
    expected += struct.pack("<16f", *np.eye(4).ravel())
    assert packed(values, kinds, where) == expected


@pytest.mark.skipif(
    None in TOOLS, reason="glslangValidator and spirv-dis are not installed (Debian: glslang-tools, spirv-tools)"
)
@pytest.mark.parametrize("dialect", FLAGS)
def test_the_reference_compiler_has_them_there(dialect, tmp_path):
    """Every constant of every shader of a scene, by name, lies where `places` says."""
    scene = load_scene("figure3_with")
    lengths = array_lengths(scene.uniforms)
    read = {name: kind for one in scene.method.passes for name, kind in {**one.reads, **one.draw.reads}.items()}
    compared = 0
    for name, source in shader_files(scene.method, lengths, DIALECTS[dialect]).items():
        path, binary = tmp_path / name, tmp_path / f"{name}.spv"
        path.write_text(source)
        done = subprocess.run([TOOLS[0], *FLAGS[dialect], "-o", str(binary), str(path)], capture_output=True, text=True)
        assert done.returncode == 0, done.stdout
        listed = subprocess.run([TOOLS[1], str(binary)], capture_output=True, text=True, check=True).stdout
        names, offsets = dict(FIELD.findall(listed)), dict(PLACE.findall(listed))
        kinds = {own: read[own.rstrip("_")] for own in names.values()}
        there = {names[number]: int(offset) for number, offset in offsets.items()}
        assert there == places(kinds, lengths).offsets
        compared += len(there)
    assert compared > 50
