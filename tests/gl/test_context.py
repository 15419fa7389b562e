import os
import subprocess
import sys
from types import SimpleNamespace

import pytest
from opengl import needs_mesa

from sss_ref.errors import ShaderError
from sss_ref.gl.context import device_name, open_context

OLD = {"GL_RENDERER": "an old one", "GL_VERSION": "3.3 (Core Profile)"}


def test_without_moderngl_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "moderngl", None)
    with pytest.raises(
        ShaderError, match=r"^gl: expected the package moderngl, got none; pip install 'sss_ref\[gl\]'$"
    ):
        open_context()


def test_without_opengl_the_packages_are_named(monkeypatch):
    """The library's own words, which differ between platforms, are not repeated."""

    def refuse(**_):
        raise RuntimeError("no display")

    monkeypatch.setitem(sys.modules, "moderngl", SimpleNamespace(create_context=refuse))
    with pytest.raises(ShaderError, match=r"^gl: expected OpenGL 4\.0, got none; .* install libegl1 "):
        open_context()


@pytest.mark.parametrize(
    ("driver", "remedy"),
    [
        ("softpipe", "unset GALLIUM_DRIVER: Mesa's llvmpipe has what is needed"),
        (None, "update the driver, or draw with LIBGL_ALWAYS_SOFTWARE=1"),
    ],
)
def test_an_older_opengl_is_named(monkeypatch, driver, remedy):
    released, asked = [], []

    def create(require, standalone, **more):
        asked.append(require)
        assert standalone and more == ({"backend": "egl"} if sys.platform == "linux" else {})
        if require > 330:
            raise RuntimeError
        return SimpleNamespace(info=OLD, release=lambda: released.append(require))

    monkeypatch.setitem(sys.modules, "moderngl", SimpleNamespace(create_context=create))
    monkeypatch.delenv("GALLIUM_DRIVER", raising=False)
    if driver:
        monkeypatch.setenv("GALLIUM_DRIVER", driver)
    with pytest.raises(ShaderError) as error:
        open_context()
    assert str(error.value) == f"gl: expected OpenGL 4.0, got an old one, OpenGL 3.3 (Core Profile); {remedy}"
    assert asked == [400, 330] and released == [330]


@needs_mesa
def test_softpipe_is_told_from_no_opengl():
    command = [sys.executable, "-m", "sss_ref.cli", "validate", "wedge", "--run-glsl"]
    environment = os.environ | {"GALLIUM_DRIVER": "softpipe"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    (line,) = [line for line in done.stderr.splitlines() if line.startswith("error:")]
    assert done.returncode == 2 and line.startswith("error: gl: expected OpenGL 4.0, got softpipe, OpenGL 3.3")


@needs_mesa
def test_the_device_says_its_name_and_version():
    assert device_name().startswith("llvmpipe") and ", OpenGL 4." in device_name()
