"""One draw of WebGPU: a mesh or a rectangle, by given shaders, into fresh textures."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from sss_ref.gl.shaders import ShaderPair
from sss_ref.interpret.shader import WGSL
from sss_ref.webgpu.textures import DEPTH, format_of, target
from sss_ref.webgpu.wgsl_program import MeshInput, WgslProgram

if TYPE_CHECKING:
    from wgpu import GPUBuffer, GPUCommandEncoder, GPUDevice, GPUTexture

CORNERS = 4  # of a rectangle, as a triangle strip


@dataclass(frozen=True)
class DrawnMesh:
    """Triangles to draw in order: attribute -> float32 (V, C), corners int32 (T, 3), nearest first.

    later_wins: whether of two at one depth the later counts, not the earlier. buffers: what is uploaded of it so far.
    """

    attributes: Mapping[str, np.ndarray]
    triangles: np.ndarray
    later_wins: bool = False
    buffers: "dict[str, GPUBuffer]" = field(default_factory=dict)


class OneDraw:
    """Shaders, the textures that they fill, and what they draw."""

    def __init__(
        self,
        device: "GPUDevice",
        pair: ShaderPair,
        targets: Mapping[str, tuple[Any, Any]],
        mesh: DrawnMesh | None = None,
    ) -> None:
        """Compile the shaders of a draw.

        targets: buffer -> its type, and what it holds where nothing is drawn. mesh: None for a rectangle.
        Raises ShaderError where they do not compile.
        """
        self.device, self.targets, self.mesh = device, targets, mesh
        channels = {name: array.shape[1] for name, array in mesh.attributes.items()} if mesh else {}
        formats = [format_of(kind) for kind, _ in targets.values()]
        known = MeshInput(channels, mesh.later_wins) if mesh else None
        self.program = WgslProgram.compiled(device, pair, formats, known)

    def record(
        self,
        encoder: "GPUCommandEncoder",
        textures: "Mapping[str, GPUTexture]",
        uniforms: Mapping[str, Any],
        size: tuple[int, int],
    ) -> "dict[str, GPUTexture]":
        """Fresh textures of this size, by buffer, into which is drawn as soon as the encoder's commands are submitted.

        textures, uniforms: all that may be read, by the names of the stages. Raises ShaderError for any other name.
        """
        groups = self.program.groups(_in_wgsl(textures), _in_wgsl(uniforms))
        written = {name: target(self.device, size, format_of(kind), name) for name, (kind, _) in self.targets.items()}
        depth = {"depth_stencil_attachment": self._depth(size)} if self.mesh else {}
        one = encoder.begin_render_pass(color_attachments=self._attachments(written), **depth)
        one.set_pipeline(self.program.pipeline)
        for number, group in groups.items():
            one.set_bind_group(number, group)
        for slot, name in enumerate(self.program.attributes):
            one.set_vertex_buffer(slot, self._corners(name))
        one.draw(self.mesh.triangles.size if self.mesh else CORNERS)
        one.end()
        return written

    def _attachments(self, written: "Mapping[str, GPUTexture]") -> list[dict[str, Any]]:
        clears = {name: _color(background) for name, (_, background) in self.targets.items()}
        return [
            {"view": texture.create_view(), "load_op": "clear", "store_op": "store", "clear_value": clears[name]}
            for name, texture in written.items()
        ]

    def _depth(self, size: tuple[int, int]) -> dict[str, Any]:
        view = target(self.device, size, DEPTH).create_view()
        return {"view": view, "depth_load_op": "clear", "depth_store_op": "discard", "depth_clear_value": 1.0}

    def _corners(self, attribute: str) -> "GPUBuffer":
        """An attribute of each corner of each triangle: a corner that is not shared knows its triangle."""
        import wgpu

        assert self.mesh
        held = self.mesh.buffers
        if attribute not in held:
            corners = self.mesh.attributes[attribute][self.mesh.triangles.ravel()]
            data = np.ascontiguousarray(corners, np.float32)
            held[attribute] = self.device.create_buffer_with_data(data=data, usage=wgpu.BufferUsage.VERTEX)
        return held[attribute]


def _in_wgsl(named: Mapping[str, Any]) -> dict[str, Any]:
    return {WGSL.name(name): value for name, value in named.items()}


def _color(background: Any) -> tuple[float, ...]:
    """What a target is cleared to, a number or one for each channel, in four: those that it lacks are not read."""
    return tuple(map(float, np.resize(np.asarray(background, np.float64), 4)))
