"""A scene drawn by WebGPU with the WGSL that its stages translate to; needs the extra `webgpu`, loaded when drawing."""

from sss_ref.webgpu.adapter import adapter_name
from sss_ref.webgpu.painting import draw

__all__ = [
    "adapter_name",
    "draw",
]
