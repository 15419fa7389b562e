"""A device of WebGPU without a window."""

from typing import TYPE_CHECKING

from sss_ref.errors import ShaderError
from sss_ref.errors.wording import told

if TYPE_CHECKING:
    from wgpu import GPUAdapter, GPUDevice

MESA = "libvulkan1 mesa-vulkan-drivers"  # Debian's packages of a Vulkan that needs no GPU


def open_device(words: str = "") -> "GPUDevice":
    """A device with all that its adapter has; words: as `adapter_name` takes them, and raises the same."""
    adapter = _adapter(words)
    return adapter.request_device_sync(required_limits=adapter.limits)


def adapter_name(words: str = "") -> str:
    """What draws here, in its own words: device, driver and API.

    words: some of these, for a machine that has several; without, the fastest.
    Raises ShaderError where wgpu is not installed, or there is no adapter or none of that name.
    """
    return _name(_adapter(words))


def _adapter(words: str) -> "GPUAdapter":
    try:
        import wgpu
    except ImportError:
        raise ShaderError("webgpu: expected the package wgpu, got none; pip install 'sss_ref[webgpu]'") from None
    if words:
        found = {_name(each): each for each in wgpu.gpu.enumerate_adapters_sync()}
        named = [adapter for name, adapter in found.items() if words.lower() in name.lower()]
        if not named:
            listed = "; ".join(found) or "none"
            raise ShaderError(told("webgpu", f"an adapter named {words!r}", listed, "take words of one of these"))
        return named[0]
    try:
        return wgpu.gpu.request_adapter_sync(power_preference="high-performance")
    except Exception:  # what it raises differs between versions
        raise ShaderError(
            told("webgpu", "an adapter", "none", f"check the driver, or without a GPU install {MESA} (Debian)")
        ) from None


def _name(adapter: "GPUAdapter") -> str:
    info = adapter.info
    return f"{info['device']}, {info['description']}, {info['backend_type']}"
