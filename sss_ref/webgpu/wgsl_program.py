"""A vertex and a fragment shader, compiled for one draw, and what they are handed by name."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from sss_ref.errors import ShaderError
from sss_ref.errors.wording import told
from sss_ref.gl.shaders import ShaderPair
from sss_ref.interpret.shader.constants import packed
from sss_ref.webgpu.resources import SAMPLES, Resources, attributes_of, resources_of
from sss_ref.webgpu.textures import DEPTH

if TYPE_CHECKING:
    from wgpu import GPUBindGroup, GPUDevice, GPURenderPipeline, GPUTexture


@dataclass(frozen=True)
class MeshInput:
    """A mesh as far as shaders are compiled for it: its attributes, and which of two fragments at one depth counts.

    channels: attribute -> how many numbers. later_wins: whether the later one does, not the earlier.
    """

    channels: Mapping[str, int]
    later_wins: bool


@dataclass(frozen=True)
class WgslProgram:
    """Compiled shaders, with what both read, and the attributes of a vertex that are read, by buffer."""

    name: str
    device: "GPUDevice"
    pipeline: "GPURenderPipeline"
    resources: tuple[Resources, ...]
    attributes: tuple[str, ...]

    @classmethod
    def compiled(
        cls, device: "GPUDevice", pair: ShaderPair, formats: Sequence[str], mesh: MeshInput | None = None
    ) -> "WgslProgram":
        """The program that fills textures of these formats; mesh: None for a rectangle.

        Raises ShaderError with what the compiler says.
        """
        resources = tuple(resources_of(text, pair.name) for text in (pair.vertex, pair.fragment))
        locations = attributes_of(pair.vertex, mesh.channels) if mesh else {}
        buffers = [_buffer_layout(mesh.channels[name], at) for name, at in locations.items()] if mesh else []
        topology = {"topology": "triangle-list" if mesh else "triangle-strip", "cull_mode": "none"}

        def build() -> "GPURenderPipeline":
            vertex, fragment = (device.create_shader_module(code=text) for text in (pair.vertex, pair.fragment))
            return device.create_render_pipeline(
                layout=_layout(device, resources),
                vertex={"module": vertex, "entry_point": "main", "buffers": buffers},
                primitive=topology,
                depth_stencil=_depth_test(mesh) if mesh else None,
                fragment={
                    "module": fragment,
                    "entry_point": "main",
                    "targets": [{"format": each} for each in formats],
                },
            )

        return cls(pair.name, device, checked(build, pair.name), resources, tuple(locations))

    def groups(self, textures: "Mapping[str, GPUTexture]", uniforms: Mapping[str, Any]) -> "dict[int, GPUBindGroup]":
        """What both shaders are handed; raises ShaderError for names that neither of these has."""
        entries: dict[int, list[dict[str, Any]]] = {}
        for each in self.resources:
            own = entries.setdefault(each.group, [])
            for texture in each.textures:
                self._check([texture.name], textures)
                own.append({"binding": texture.binding, "resource": textures[texture.name].create_view()})
            if each.constants:
                self._check(each.constants.kinds, uniforms)
                own.append({"binding": each.constants.binding, "resource": {"buffer": self._constants(each, uniforms)}})
        return {
            group: self.device.create_bind_group(layout=self.pipeline.get_bind_group_layout(group), entries=own)
            for group, own in entries.items()
            if own
        }

    def _constants(self, resources: Resources, uniforms: Mapping[str, Any]) -> Any:
        import wgpu

        known = resources.constants
        assert known
        data = packed(uniforms, known.kinds, known.places)
        return self.device.create_buffer_with_data(data=data, usage=wgpu.BufferUsage.UNIFORM)

    def _check(self, names: Any, known: Mapping[str, Any]) -> None:
        for name in names:
            if name not in known:
                listed = ", ".join(sorted(known))
                expected = f"names of earlier buffers or uniforms ({listed})"
                raise ShaderError(told(self.name, expected, name, "rename it"))


def checked(build: "Callable[[], Any]", where: str) -> Any:
    """What a compiler makes; its refusal as a ShaderError."""
    import wgpu

    try:
        return build()
    except wgpu.GPUError as error:
        raise ShaderError(f"{where}: expected shaders that compile and fit each other, got {error}") from None


def _layout(device: "GPUDevice", resources: Sequence[Resources]) -> Any:
    """The bindings of all groups; a text says what it reads, and both shaders may read it."""
    import wgpu

    seen = wgpu.ShaderStage.VERTEX | wgpu.ShaderStage.FRAGMENT
    entries: dict[int, list[dict[str, Any]]] = {k: [] for k in range(1 + max(each.group for each in resources))}
    for each in resources:
        own = entries[each.group]
        for texture in each.textures:
            sampled = {"sample_type": SAMPLES[texture.texel], "view_dimension": "2d", "multisampled": False}
            own.append({"binding": texture.binding, "visibility": seen, "texture": sampled})
        if each.constants:
            own.append({"binding": each.constants.binding, "visibility": seen, "buffer": {"type": "uniform"}})
    layouts = [device.create_bind_group_layout(entries=own) for own in entries.values()]
    return device.create_pipeline_layout(bind_group_layouts=layouts)


def _buffer_layout(channels: int, location: int) -> dict[str, Any]:
    item = np.dtype(np.float32).itemsize
    attribute = {"format": f"float32x{channels}", "offset": 0, "shader_location": location}
    return {"array_stride": item * channels, "step_mode": "vertex", "attributes": [attribute]}


def _depth_test(mesh: MeshInput) -> dict[str, Any]:
    nearer = "less-equal" if mesh.later_wins else "less"
    return {"format": DEPTH, "depth_write_enabled": True, "depth_compare": nearer}
