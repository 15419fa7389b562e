"""The WGSL of a witness, run on this machine's WebGPU."""

from typing import TYPE_CHECKING

import numpy as np

from sss_ref.gl.stand_alone_run import ShaderVerdict
from sss_ref.validation.witness.stand_alone_wgsl import FRAGMENT, VERTEX
from sss_ref.webgpu.adapter import adapter_name, open_device
from sss_ref.webgpu.textures import ALIGNED, target
from sss_ref.webgpu.wgsl_program import checked

if TYPE_CHECKING:
    from wgpu import GPUDevice, GPUTexture

FORMATS = ("rgba8unorm", "rgba32uint")  # of the verdict, and of the bits


def run_wgsl_alone(text: str, adapter: str = "") -> ShaderVerdict:
    """Run the shaders that `stand_alone_wgsl` gives for one pixel; adapter: as `sss_ref.webgpu.draw` takes it.

    Raises ShaderError where there is no such adapter, or they do not compile.
    """
    device = open_device(adapter)
    try:
        verdict, bits = (target(device, (1, 1), each) for each in FORMATS)
        _draw(device, text, [verdict, bits])
        green = _texel(device, verdict, np.uint8)[1] == np.iinfo(np.uint8).max
        return ShaderVerdict(bool(green), _texel(device, bits, np.uint32), adapter_name(adapter))
    finally:
        device.destroy()


def _draw(device: "GPUDevice", text: str, targets: "list[GPUTexture]") -> None:
    """Draw as the first comment of the file says."""

    def build() -> object:
        module = device.create_shader_module(code=text)
        fragment = {"module": module, "entry_point": FRAGMENT, "targets": [{"format": each} for each in FORMATS]}
        vertex = {"module": module, "entry_point": VERTEX}
        return device.create_render_pipeline(layout="auto", vertex=vertex, primitive={}, fragment=fragment)

    encoder = device.create_command_encoder()
    attached = [{"view": each.create_view(), "load_op": "clear", "store_op": "store"} for each in targets]
    one = encoder.begin_render_pass(color_attachments=attached)
    one.set_pipeline(checked(build, "witness"))
    one.draw(3)
    one.end()
    device.queue.submit([encoder.finish()])


def _texel(device: "GPUDevice", texture: "GPUTexture", dtype: type) -> np.ndarray:
    """The four numbers of the only texel."""
    layout = {"bytes_per_row": ALIGNED, "rows_per_image": 1}
    return np.frombuffer(device.queue.read_texture({"texture": texture}, layout, (1, 1, 1)), dtype)[:4]
