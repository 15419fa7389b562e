import sys
from types import SimpleNamespace

import pytest

from sss_ref.errors import ShaderError
from sss_ref.gl.context import open_context


def test_without_moderngl_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "moderngl", None)
    with pytest.raises(
        ShaderError, match=r"^gl: expected the package moderngl, got none; pip install 'sss_ref\[gl\]'$"
    ):
        open_context()


def test_without_opengl_the_packages_are_named(monkeypatch):
    def refuse(**_):
        raise RuntimeError("no display")

    monkeypatch.setitem(sys.modules, "moderngl", SimpleNamespace(create_context=refuse))
    with pytest.raises(ShaderError, match=r"^gl: expected OpenGL 4\.0, got no display; .* install libegl1 "):
        open_context()
