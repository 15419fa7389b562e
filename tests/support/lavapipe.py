"""WebGPU on Mesa's lavapipe, a Vulkan that needs no GPU and is the same wherever it is installed."""

import pytest

from sss_ref.errors import ShaderError
from sss_ref.webgpu import adapter_name

LAVAPIPE = "vulkan"  # of llvmpipe's two APIs the one that is not OpenGL


def adapter():
    """What draws here; empty where nothing does."""
    try:
        return adapter_name(LAVAPIPE)
    except ShaderError:
        return ""


needs_lavapipe = pytest.mark.skipif(
    "llvmpipe" not in adapter(), reason="no lavapipe (Debian: mesa-vulkan-drivers), or no wgpu (pip), is installed"
)
