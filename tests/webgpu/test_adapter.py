"""What draws here, and what is said where nothing does."""

import sys

import pytest
from lavapipe import LAVAPIPE, needs_lavapipe

from sss_ref.errors import ShaderError
from sss_ref.webgpu import adapter_name


def test_without_the_package_the_extra_is_told(monkeypatch):
    monkeypatch.setitem(sys.modules, "wgpu", None)
    with pytest.raises(ShaderError, match=r"^webgpu: expected the package wgpu, got none; pip install 'sss_ref\[web"):
        adapter_name()


@needs_lavapipe
def test_an_adapter_is_found_by_words_of_its_name():
    assert adapter_name(LAVAPIPE.upper()).endswith(", Vulkan")
    with pytest.raises(ShaderError, match=r"^webgpu: expected an adapter named 'nonesuch', got .*llvmpipe.*; take "):
        adapter_name("nonesuch")


@needs_lavapipe
def test_without_an_adapter_debians_packages_are_told(monkeypatch):
    import wgpu

    def none(**_):
        raise RuntimeError

    monkeypatch.setattr(wgpu.gpu, "request_adapter_sync", none)
    with pytest.raises(ShaderError, match=r"expected an adapter, got none; .* libvulkan1 mesa-vulkan-drivers \(Deb"):
        adapter_name()
