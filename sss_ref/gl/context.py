"""An OpenGL context without a window."""

import os
import sys
from typing import TYPE_CHECKING, Any

from sss_ref.errors import ShaderError
from sss_ref.errors.wording import told

if TYPE_CHECKING:
    from moderngl import Context

MESA = "libegl1 libegl-mesa0 libgl1 libgl1-mesa-dri"  # Debian's packages of an OpenGL that needs no GPU
NEEDED, OLDEST = 400, 330  # versions: what we draw with, and the oldest that moderngl opens
CHOICE = "GALLIUM_DRIVER"  # of Mesa's drivers


def open_context() -> "Context":
    """A new context of OpenGL 4.0 or newer, to be released after use.

    Raises ShaderError where moderngl is not installed, or the machine has no OpenGL or an older one.
    """
    context = _opened(NEEDED)
    if context is None:
        raise ShaderError(_refusal())
    return context


def device_name() -> str:
    """What draws here, in its own words: renderer and version. Raises ShaderError as `open_context` does."""
    context = open_context()
    try:
        return _name(context)
    finally:
        context.release()


def _opened(version: int) -> "Context | None":
    """A context of this version or a newer one; None where there is none."""
    try:
        import moderngl
    except ImportError:
        raise ShaderError("gl: expected the package moderngl, got none; pip install 'sss_ref[gl]'") from None
    backend: Any = {"backend": "egl"} if sys.platform == "linux" else {}
    try:
        return moderngl.create_context(require=version, standalone=True, **backend)
    except Exception:  # what it raises differs between the platforms
        return None


def _refusal() -> str:
    """What is there in the place of OpenGL 4.0, and what to do about it."""
    older = _opened(OLDEST)
    if older is None:
        return told("gl", "OpenGL 4.0", "none", f"check the driver, or without a GPU install {MESA} (Debian)")
    name = _name(older)
    older.release()
    if CHOICE in os.environ:
        return told("gl", "OpenGL 4.0", name, f"unset {CHOICE}: Mesa's llvmpipe has what is needed")
    return told("gl", "OpenGL 4.0", name, "update the driver, or draw with LIBGL_ALWAYS_SOFTWARE=1")


def _name(context: "Context") -> str:
    return f"{context.info['GL_RENDERER']}, OpenGL {context.info['GL_VERSION']}"
