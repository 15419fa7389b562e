"""What a bundle says otherwise in each shading language: the names of formats, and what to heed."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sss_ref.interpret.shader import DIALECTS, Dialect
from sss_ref.language.layout import WRITTEN


@dataclass(frozen=True)
class PortedLanguage:
    """A language that a bundle can be in.

    name: as DIALECTS has it. version: what its shaders are. formats: of a texture for each of WRITTEN, in the API's own
    words. notes: the conventions that are this language's; where their lines break counts for nothing.
    """

    name: str
    version: str
    formats: Mapping[Any, str]
    notes: tuple[str, ...]

    @property
    def dialect(self) -> Dialect:
        """How its shaders are written."""
        return DIALECTS[self.name]


def _formats(names: str) -> Mapping[Any, str]:
    return dict(zip(WRITTEN, names.split(), strict=True))


UPSIDE_DOWN = """
  The vertex shaders negate the clip position's y and bring its z from -w ... w to 0 ... w; the rasterizer's own
  conventions are {api}'s (viewport of positive height, depth 0 to 1, cleared to 1). So row 0 in memory is the
  bottom row of the picture in every target and texture, and nothing else is turned, neither taps nor lookups; on
  a screen the picture stands on its head. In a mapping file say `origin = "bottom"`. Nothing is culled or
  blended.
"""
OPENGL = """
  Clip space is OpenGL's, -w <= x, y, z <= w; window depth 0.5*z/w + 0.5, cleared to 1. Nothing is culled or
  blended. Row 0 of targets and textures is at the bottom. For y pointing down write the bundle with `--dialect
  vulkan`, `hlsl` or `wgsl`, whose vertex shaders mirror the clip position; docs/how_to/y_down.md has what is
  behind that.
"""
FETCHED = """
  Every texture is read by {call}; filters are written in the shaders, and a sampler's own filter counts for
  nothing.
"""
COLUMNS = "Matrices are stored column by column: transpose those of `uniforms.json`{or_let}."
PLACES = """
  `passes.json` has for each shader its `resources`: {where}; of the constants, which are one buffer of `bytes`
  bytes, each one's offset. A number or vector lies in one row of 16 bytes, and a vec3 leaves its last four to a
  number after it; lines of matrices{arrays} have a row each. Integers and truth values take four bytes.
"""
ARRAYS = " and elements of arrays"
NUMBERED = """
  `triangle` is the index of the triangle in `triangles.npy`: meshes are drawn without indices, three corners a
  triangle, in the order of that file (`"indexed": false`).
"""
PRIMITIVES = "`triangle` is the index of the triangle in `triangles.npy` ({word} in one indexed draw{needs})."
LOCATIONS = "`attributes` lists what a vertex shader reads of its vertex, by {place}: float32 arrays of `mesh/`."
WIDER = """
  No API must draw into three channels: a vec3 lies in a texture of four, of which the last counts for nothing.
"""
PRECISE = "The sums are `precise`: no compiler may fuse or reorder them."
FOUR = """
  A draw has at most 4 targets, as many as every Vulkan device has (`maxColorAttachments`; Vulkan 1.4 promises 8).
  Each draw of a pass computes all that its own targets need, and begins with a depth buffer cleared to 1.
"""
IMPRECISE = """
  {title} has no `precise`: a compiler may fuse and reorder. Judge with a profile that says `contraction =
  "free"`.
"""

LANGUAGES = {
    each.name: each
    for each in (
        PortedLanguage(
            "glsl",
            "GLSL 4.0",
            _formats("R32F RG32F RGB32F R32I R8UI"),
            (
                OPENGL,
                FETCHED.format(call="texelFetch"),
                COLUMNS.format(or_let=", or let glUniformMatrix do it"),
                PRIMITIVES.format(word="gl_PrimitiveID", needs=""),
                PRECISE,
            ),
        ),
        PortedLanguage(
            "essl",
            "GLSL ES 3.00, for WebGL 2 and OpenGL ES 3",
            _formats("R32F RG32F RGBA32F R32I R8UI"),
            (
                OPENGL,
                "Float targets want the extension EXT_color_buffer_float. " + WIDER,
                FETCHED.format(call="texelFetch"),
                COLUMNS.format(or_let=", for WebGL takes no `transpose`"),
                NUMBERED,
                IMPRECISE.format(title="GLSL ES 3.00"),
            ),
        ),
        PortedLanguage(
            "vulkan",
            "GLSL 4.50 for Vulkan; compile with `glslangValidator -V`",
            _formats(
                "VK_FORMAT_R32_SFLOAT VK_FORMAT_R32G32_SFLOAT VK_FORMAT_R32G32B32A32_SFLOAT VK_FORMAT_R32_SINT "
                "VK_FORMAT_R8_UINT"
            ),
            (
                UPSIDE_DOWN.format(api="Vulkan"),
                WIDER + FOUR,
                FETCHED.format(call="texelFetch, as a combined image sampler"),
                PLACES.format(where="the set (`group`), and in it the binding of each", arrays=ARRAYS),
                COLUMNS.format(or_let=""),
                LOCATIONS.format(place="location"),
                PRIMITIVES.format(word="gl_PrimitiveID", needs=", which wants the feature geometryShader"),
                PRECISE,
            ),
        ),
        PortedLanguage(
            "hlsl",
            "HLSL for Direct3D, entry point `main`, shader model 4 or newer (vs_5_0, ps_5_0)",
            _formats(
                "DXGI_FORMAT_R32_FLOAT DXGI_FORMAT_R32G32_FLOAT DXGI_FORMAT_R32G32B32A32_FLOAT DXGI_FORMAT_R32_SINT "
                "DXGI_FORMAT_R8_UINT"
            ),
            (
                UPSIDE_DOWN.format(api="Direct3D"),
                WIDER,
                FETCHED.format(call="Load"),
                PLACES.format(
                    where="the registers, b0 of the constants, and t0, t1 ... of the textures", arrays=ARRAYS
                ),
                "Matrices are `row_major`: stored row by row, as `uniforms.json` has them.",
                LOCATIONS.format(place="semantic, which is its name in capitals"),
                PRIMITIVES.format(word="SV_PrimitiveID", needs=""),
                PRECISE,
            ),
        ),
        PortedLanguage(
            "wgsl",
            "WGSL for WebGPU, entry point `main`",
            _formats("r32float rg32float rgba32float r32sint r8uint"),
            (
                UPSIDE_DOWN.format(api="WebGPU"),
                WIDER + " A draw has at most 32 bytes of targets a pixel, as every device allows.",
                FETCHED.format(call="textureLoad; bind float textures as `unfilterable-float`"),
                PLACES.format(where="the group, and in it the binding of each", arrays=""),
                COLUMNS.format(or_let=""),
                "Every array of `uniforms.json` is a texture, of however few elements.",
                LOCATIONS.format(place="location"),
                NUMBERED,
                IMPRECISE.format(title="WGSL"),
            ),
        ),
    )
}
