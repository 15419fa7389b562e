"""A page that needs nothing else: what stands in it comes out as it was."""

import base64
from io import BytesIO

import numpy as np
from PIL import Image

from sss_ref.pictures.page_style import PAGE_STYLE
from sss_ref.pictures.self_contained import data_url, whole_page


def test_a_picture_lies_in_its_address_with_the_bottom_row_last():
    pixels = np.arange(2 * 3 * 3, dtype=np.uint8).reshape(2, 3, 3)
    kind, _, data = data_url(pixels).partition(",")
    assert kind == "data:image/png;base64"
    assert np.array_equal(np.asarray(Image.open(BytesIO(base64.b64decode(data)))), pixels[::-1])


def test_a_title_is_text_and_a_body_is_html():
    page = whole_page("a < b", "p { margin: 0 }", "<p>what it says</p>")
    assert (
        "<title>a &lt; b</title>" in page
        and "p { margin: 0 }</style><p>what it says</p></html>" in page
        and PAGE_STYLE in page
    )
