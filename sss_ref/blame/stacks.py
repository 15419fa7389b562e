"""Ways from a shader's source to a picture: each a language, a compiler and a processor."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sss_ref.errors import ShaderError
from sss_ref.errors.text_file import text_of
from sss_ref.gl import context as opengl
from sss_ref.gl.drawing import draw_pass as draw_by_opengl
from sss_ref.gl.shaders import Files, listed
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Buffers
from sss_ref.scene.scene import Scene
from sss_ref.webgl.exams import WEBGL
from sss_ref.webgl.one_pass import browser_name
from sss_ref.webgl.one_pass import draw_pass as draw_by_browser
from sss_ref.webgpu import adapter as webgpu
from sss_ref.webgpu.painting import draw_pass as draw_by_webgpu

Draw = Callable[[Scene, Pass, Buffers, Mapping[str, Files]], Buffers]
GLSL, WGSL, ESSL = "glsl", "wgsl", "essl"
ALONE = {WGSL: ("@fragment", "@vertex"), ESSL: ("#version 300 es",)}  # words that no other language has


@dataclass(frozen=True)
class Stack:
    """What draws one pass.

    name: in its own words. language: of the shaders that it takes, a name of DIALECTS. draw: from a scene, a pass, the
    buffers that it reads, and shaders as `sss_ref.gl.draw` takes them, to what the pass writes. profile: what it is
    known to be; None for what is accepted of the drawing that is judged.
    """

    name: str
    language: str
    draw: Draw
    profile: Profile | None = None


HERE: Mapping[str, tuple[Callable[[], str], Draw, Profile | None]] = {
    GLSL: (opengl.device_name, draw_by_opengl, None),
    WGSL: (webgpu.adapter_name, draw_by_webgpu, None),
    ESSL: (browser_name, draw_by_browser, WEBGL),
}


def stacks_here(language: str) -> list[Stack]:
    """Those that this machine has for a language: its OpenGL or WebGPU, such as Mesa's, or WebGL in Chromium."""
    name, draw, profile = HERE[language]
    try:
        return [Stack(name(), language, draw, profile)]
    except ShaderError:  # there is none
        return []


def language_of(shaders: Mapping[str, Files]) -> str:
    """The language that a user's files are in. Raises ShaderError where one cannot be read."""
    texts = [text_of(path, "shader source", ShaderError) for files in shaders.values() for path in listed(files)]
    found = (language for language, words in ALONE.items() if any(word in text for text in texts for word in words))
    return next(found, GLSL)
