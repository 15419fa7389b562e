"""Stages as shader source: their typed trees translated statement by statement, with the names they have in Python.

Whatever a shading language defines otherwise, or leaves open, is written out as the package defines it: min and max,
the order of every sum, a normalize that leaves the zero vector zero. Only pow, exp, exp2 and log2 are the GPU's own.
"""

from sss_ref.interpret.shader.dialect import ARRAY_WIDTH, OUT, Dialect
from sss_ref.interpret.shader.glsl import ESSL, GLSL
from sss_ref.interpret.shader.hlsl import HLSL
from sss_ref.interpret.shader.library import Library, stage_source
from sss_ref.interpret.shader.passes import (
    array_lengths,
    draws,
    fragment_parts,
    fragment_shader,
    shader_files,
    vertex_parts,
    vertex_shader,
)
from sss_ref.interpret.shader.vulkan import VULKAN
from sss_ref.interpret.shader.wgsl import WGSL

DIALECTS = {"glsl": GLSL, "vulkan": VULKAN, "essl": ESSL, "hlsl": HLSL, "wgsl": WGSL}

__all__ = [
    "ARRAY_WIDTH",
    "DIALECTS",
    "ESSL",
    "GLSL",
    "HLSL",
    "OUT",
    "VULKAN",
    "WGSL",
    "Dialect",
    "Library",
    "array_lengths",
    "draws",
    "fragment_parts",
    "fragment_shader",
    "shader_files",
    "stage_source",
    "vertex_parts",
    "vertex_shader",
]
