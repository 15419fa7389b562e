"""A scene drawn by a browser: a page for WebGL 2 that offers what each buffer holds, and one that judges each stage."""

from sss_ref.webgl.browser import draw
from sss_ref.webgl.content import page
from sss_ref.webgl.judge_page import judge_page, reduced

__all__ = [
    "draw",
    "judge_page",
    "page",
    "reduced",
]
