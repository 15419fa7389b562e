"""What is drawn into and read: textures of WebGPU, which has none of three channels, row 0 at the bottom."""

from typing import TYPE_CHECKING, Any

import numpy as np

from sss_ref.language.layout import CHANNELS, dtype_of

if TYPE_CHECKING:
    from wgpu import GPUDevice, GPUTexture

FORMATS = {  # kind of number, channels -> WebGPU's name
    ("f", 1): "r32float",
    ("f", 2): "rg32float",
    ("f", 4): "rgba32float",
    ("i", 1): "r32sint",
    ("u", 1): "r8uint",
}
ALIGNED = 256  # bytes: rows of a texture that is read back begin so far apart
DEPTH = "depth32float"


def channels_in(kind: Any) -> int:
    """The channels of a texture for a buffer of a type."""
    return 4 if CHANNELS[kind] == 3 else CHANNELS[kind]


def format_of(kind: Any) -> str:
    """The format of a texture for a buffer of a type."""
    return FORMATS[dtype_of(kind).kind, channels_in(kind)]


def target(device: "GPUDevice", size: tuple[int, int], texture_format: str, label: str = "") -> "GPUTexture":
    """An empty texture to draw into, and to read. label: what messages and captures call it."""
    import wgpu

    usage = wgpu.TextureUsage
    kept = 0 if texture_format == DEPTH else usage.TEXTURE_BINDING | usage.COPY_SRC
    usage_here = usage.RENDER_ATTACHMENT | kept
    return device.create_texture(label=label, size=(*size, 1), format=texture_format, usage=usage_here)


def uploaded(device: "GPUDevice", data: np.ndarray) -> "GPUTexture":
    """A texture of an array (H, W) or (H, W, C), float32, int32 or uint8."""
    import wgpu

    height, width, channels = (*data.shape, 1)[:3]
    stored = np.concatenate([data, data[..., :1]], axis=-1) if channels == 3 else data
    texture_format = FORMATS[data.dtype.kind, 4 if channels == 3 else channels]
    usage = wgpu.TextureUsage.TEXTURE_BINDING | wgpu.TextureUsage.COPY_DST
    texture = device.create_texture(size=(width, height, 1), format=texture_format, usage=usage)
    layout = {"bytes_per_row": stored.nbytes // height, "rows_per_image": height}
    device.queue.write_texture({"texture": texture}, np.ascontiguousarray(stored), layout, (width, height, 1))
    return texture


def downloaded(device: "GPUDevice", texture: "GPUTexture", kind: Any) -> np.ndarray:
    """The buffer of a type that a texture holds: (H, W), or (H, W, C) for vectors."""
    width, height, _ = texture.size
    channels, dtype = channels_in(kind), dtype_of(kind)
    row = width * channels * dtype.itemsize
    layout = {"bytes_per_row": -(-row // ALIGNED) * ALIGNED, "rows_per_image": height}
    read = np.frombuffer(device.queue.read_texture({"texture": texture}, layout, (width, height, 1)), np.uint8)
    rows = read.reshape(height, -1)[:, :row].copy().view(dtype).reshape(height, width, channels)
    return (rows[..., 0] if CHANNELS[kind] == 1 else rows[..., : CHANNELS[kind]]).copy()
