"""Mesa's software OpenGL, whose arithmetic is IEEE's: what can be compared in bits is compared on it alone."""

import os

import pytest

from sss_ref.errors import ShaderError
from sss_ref.gl.context import open_context

os.environ.setdefault("EGL_PLATFORM", "surfaceless")
os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")


def renderer():
    """What draws here; empty where nothing does."""
    try:
        context = open_context()
    except ShaderError:
        return ""
    name = context.info["GL_RENDERER"]
    context.release()
    return name


needs_mesa = pytest.mark.skipif("llvmpipe" not in renderer(), reason="no Mesa llvmpipe, or no moderngl, is installed")
