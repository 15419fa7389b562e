"""A scene drawn by OpenGL with the shaders that its stages translate to; needs the extra `gl`, loaded when drawing."""

from sss_ref.gl.context import device_name
from sss_ref.gl.drawing import draw

__all__ = [
    "device_name",
    "draw",
]
