"""A single pass drawn by a browser, with our shaders or a user's in GLSL ES."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.gl.folding import pass_drawn
from sss_ref.gl.shaders import Files, ShaderPair
from sss_ref.interpret.shader import ESSL
from sss_ref.language.pipeline import Pass
from sss_ref.scene.scene import Scene
from sss_ref.webgl.browser import found_browser, printed_buffers
from sss_ref.webgl.content import inputs, output, page_of, pass_settings, texture
from sss_ref.webgl.packing import plain


def browser_name() -> str:
    """What draws, in words. Raises ShaderError where there is no Chromium."""
    return f"WebGL 2, ANGLE on SwiftShader, {found_browser()}"


def draw_pass(
    scene: Scene, this_pass: Pass, buffers: Mapping[str, np.ndarray], shaders: Mapping[str, Files] | None = None
) -> dict[str, np.ndarray]:
    """Draw a single pass of a scene that reads these buffers, in Chromium; what it writes.

    shaders: as `sss_ref.gl.draw` takes them, in GLSL ES 3.0. Raises ShaderError as `sss_ref.webgl.draw` does, and where
    a shader does not compile.
    """
    return pass_drawn(scene, this_pass, buffers, shaders or {}, _painting)


@contextmanager
def _painting(scene: Scene) -> "Iterator[_PagePainter]":
    yield _PagePainter(scene)


@dataclass
class _PagePainter:
    """Draws each draw of a pass by a page of its own; its textures are arrays."""

    scene: Scene
    dialect = ESSL

    def prepared(
        self, this_pass: Pass, pair: ShaderPair
    ) -> Callable[[Mapping[str, np.ndarray]], dict[str, np.ndarray]]:
        """A page, without what the draw reads."""
        scene, kinds = self.scene, this_pass.values
        outputs = [output(name, kinds[name], scene.clear(name)) for name in pair.outputs]
        one = {"name": pair.name, "vertex": pair.vertex, "fragment": pair.fragment, "outputs": outputs}
        once: dict[str, Any] = pass_settings(this_pass, scene) | {"rounds": 1, "feedback": {}, "draws": [one]}
        content = {"passes": [once], "kept": [*pair.outputs], **inputs(scene, plain)}

        def run(read: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
            given = {name: texture(data, plain) for name, data in read.items()}
            return printed_buffers(page_of(pair.name, content | {"textures": {**content["textures"], **given}}))

        return run

    def uploaded(self, buffer: np.ndarray) -> np.ndarray:
        """The buffer itself."""
        return buffer

    def downloaded(self, texture: np.ndarray, kind: Any) -> np.ndarray:
        """The buffer itself."""
        return texture
