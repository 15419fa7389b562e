"""An OpenGL context without a window."""

import sys
from typing import TYPE_CHECKING, Any

from sss_ref.errors import ShaderError

if TYPE_CHECKING:
    from moderngl import Context

MESA = "libegl1 libegl-mesa0 libgl1 libgl1-mesa-dri"  # Debian's packages of an OpenGL that needs no GPU


def open_context() -> "Context":
    """A new context of OpenGL 4.0 or newer, to be released after use.

    Raises ShaderError where moderngl is not installed or the machine has no OpenGL.
    """
    try:
        import moderngl
    except ImportError:
        raise ShaderError("gl: expected the package moderngl, got none; pip install 'sss_ref[gl]'") from None
    backend: Any = {"backend": "egl"} if sys.platform == "linux" else {}
    try:
        return moderngl.create_context(require=400, standalone=True, **backend)
    except Exception as error:  # what it raises differs between the platforms
        raise ShaderError(f"gl: expected OpenGL 4.0, got {error}; without a GPU install {MESA} (Debian)") from None


def device_name() -> str:
    """What draws here, in its own words: renderer and version. Raises ShaderError as `open_context` does."""
    context = open_context()
    try:
        return f"{context.info['GL_RENDERER']}, OpenGL {context.info['GL_VERSION']}"
    finally:
        context.release()
