"""A scene drawn by a browser: a page for WebGL 2, which draws every pass and offers what each buffer holds."""

from sss_ref.webgl.browser import draw
from sss_ref.webgl.content import page

__all__ = [
    "draw",
    "page",
]
