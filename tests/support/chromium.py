"""Chromium with SwiftShader, which needs no GPU; its rasterizer has four subpixel bits."""

import shutil

import pytest

from sss_ref.webgl.browser import BROWSERS

SUBPIXEL_BITS = 4
needs_chromium = pytest.mark.skipif(
    not any(map(shutil.which, BROWSERS)), reason="no Chromium is installed (Debian: chromium)"
)
