"""Drawing a scene by WebGPU: a draw of a pass, into fresh textures."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from sss_ref.gl.folding import Painter, drawn, pass_drawn
from sss_ref.gl.shaders import Files, ShaderPair
from sss_ref.gl.uploads import texture_data
from sss_ref.interpret.shader import WGSL
from sss_ref.language.pipeline import Pass
from sss_ref.scene.scene import Scene
from sss_ref.webgpu.adapter import open_device
from sss_ref.webgpu.one_draw import DrawnMesh, OneDraw
from sss_ref.webgpu.textures import downloaded, uploaded

if TYPE_CHECKING:
    from wgpu import GPUCommandEncoder, GPUDevice, GPUTexture


def draw(
    scene: Scene,
    shaders: Mapping[str, Files] | None = None,
    keep: str | Iterable[str] = "all",
    adapter: str = "",
) -> dict[str, np.ndarray]:
    """Draw a scene by this machine's WebGPU: buffers of its method by name.

    The buffers are (H, W) or (H, W, C), row 0 at the bottom, as `sss_ref.gl.draw` gives them, and keep is what it is
    there. shaders: pass -> the user's file or files as there, in WGSL: a fragment shader says what it writes as ours
    do, @location(0) out_lit: vec4<f32>, and reads the textures and uniforms that it declares, each by the name that
    ours have.
    adapter: words of the name of the one that draws (see `adapter_name`), for a machine that has several.
    Raises ShaderError where there is no such adapter, a shader does not compile, or a pass reads what a shader left
    out, and SceneError for an unknown buffer.
    """
    return drawn(scene, shaders or {}, keep, partial(_painting, words=adapter))


def draw_pass(
    scene: Scene,
    this_pass: Pass,
    buffers: Mapping[str, np.ndarray],
    shaders: Mapping[str, Files] | None = None,
    adapter: str = "",
) -> dict[str, np.ndarray]:
    """Draw a single pass of a scene that reads these buffers; what it writes.

    shaders, adapter: as in `draw`. Raises ShaderError as that does.
    """
    return pass_drawn(scene, this_pass, buffers, shaders or {}, partial(_painting, words=adapter))


@contextmanager
def _painting(scene: Scene, words: str) -> "Iterator[Painter[GPUTexture]]":
    device = open_device(words)
    try:
        yield _WebGpuPainter(scene, device)
    finally:
        device.destroy()


@dataclass
class _WebGpuPainter:
    """Draws the passes of a scene by WebGPU, all at once as soon as something is read.

    So all uploads come before all draws. With a submission for each draw RenderDoc replays a capture otherwise than it
    was drawn: a pass read zeros where the one before it had drawn.
    meshes: pass -> what it draws. encoder: of what is to be drawn.
    """

    scene: Scene
    device: "GPUDevice"
    meshes: dict[str, DrawnMesh | None] = field(default_factory=dict)
    encoder: "GPUCommandEncoder | None" = None
    dialect = WGSL

    def prepared(
        self, this_pass: Pass, pair: ShaderPair
    ) -> "Callable[[Mapping[str, GPUTexture]], dict[str, GPUTexture]]":
        """A draw, compiled."""
        mesh = self.meshes.setdefault(this_pass.name, self.mesh_drawn(this_pass))
        targets = {name: (this_pass.values[name], self.scene.clear(name)) for name in pair.outputs}
        one = OneDraw(self.device, pair, targets, mesh)

        def run(read: "Mapping[str, GPUTexture]") -> "dict[str, GPUTexture]":
            self.encoder = self.encoder or self.device.create_command_encoder()
            given = {**self.textures, **read}
            return one.record(self.encoder, given, self.scene.uniforms, self.scene.size(this_pass))

        return run

    def mesh_drawn(self, this_pass: Pass) -> DrawnMesh | None:
        """The corners of a pass's triangles; None for a rectangle."""
        if not this_pass.draw.vertex_stages:
            return None
        mesh = self.scene.mesh_of(this_pass)
        later_wins = this_pass.draw.layout and self.scene.settings.irradiance_map.overlap == "last"
        return DrawnMesh(mesh.attributes, mesh.triangles, later_wins)

    def uploaded(self, buffer: np.ndarray) -> "GPUTexture":
        """A texture that holds a buffer."""
        return uploaded(self.device, buffer)

    def downloaded(self, texture: "GPUTexture", kind: Any) -> np.ndarray:
        """The buffer of a type that a texture holds."""
        if self.encoder:
            self.device.queue.submit([self.encoder.finish()])
            self.encoder = None
        return downloaded(self.device, texture, kind)

    @cached_property
    def textures(self) -> "dict[str, GPUTexture]":
        """The uniforms that are textures."""
        data = texture_data(self.scene.uniforms, WGSL)
        return {name: uploaded(self.device, texels) for name, texels in data.items()}
