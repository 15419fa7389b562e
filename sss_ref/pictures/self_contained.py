"""Pages of HTML that need nothing but themselves: the whole of one, and pictures that lie in it."""

import base64
from html import escape
from io import BytesIO

import numpy as np

from sss_ref.pictures.page_style import PAGE_STYLE


def whole_page(title: str, style: str, body: str) -> str:
    """A page. title: as plain text. style: CSS, of what is its own. body: HTML."""
    head = f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{escape(title)}</title>'
    viewport = '<meta name="viewport" content="width=device-width, initial-scale=1">'
    return f"{head}{viewport}<style>{PAGE_STYLE}{style}</style>{body}</html>\n"


def data_url(pixels: np.ndarray) -> str:
    """A picture, uint8 (H, W, 3), row 0 at the bottom, as what an <img> shows."""
    from PIL import Image

    file = BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels[::-1])).save(file, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(file.getvalue()).decode()
