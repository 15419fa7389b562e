"""Sliders for a page without Python: pictures of each slider's range that are drawn beforehand.

A page cannot draw, so a slider there chooses among pictures, while all others stand at their first value. Drawing them
takes a while: it is done where `WANTED` is set in the environment, as the documentation does.
"""

import base64
import io
import os
from collections.abc import Callable, Mapping, Sequence
from html import escape

import numpy as np
from PIL import Image

WANTED = "SSS_REF_COURSE_FRAMES"
COUNT = 7  # pictures of a slider
Range = tuple[float, float, float, float]  # least, first, greatest value, step

PAGE = """<figure class="sliders">
{controls}
<img src="{shown}" alt="{names}">
<figcaption>{caption}</figcaption>
</figure>"""
CONTROL = """<label>{name}<input type="range" min="0" max="{last}" value="{first}" data-first="{first}"
 data-values="{values}" data-pictures="{pictures}"><output>{shown}</output></label>"""
ONE = "Drawn beforehand: the slider stops at each picture."
MANY = "Drawn beforehand: one slider at a time; in Jupyter they move together."


def wanted() -> bool:
    """Whether whoever runs a lesson wants its pictures drawn beforehand."""
    return bool(os.environ.get(WANTED))


def page(draw: Callable[[Mapping[str, float]], bytes], ranges: Mapping[str, Range]) -> str:
    """Sliders and their pictures as HTML, which the site's `sliders.js` moves.

    draw: parameter -> value, gives a PNG. ranges: parameter -> its range.
    """
    first = {name: start for name, (_, start, _, _) in ranges.items()}
    shown = draw(first)
    controls = []
    for name, numbers in ranges.items():
        values = stops(*numbers)
        pictures = [webp(shown if value == first[name] else draw(first | {name: value})) for value in values]
        controls.append(_control(name, values, first[name], pictures))
    caption = MANY if len(ranges) > 1 else ONE
    return PAGE.format(
        controls="\n".join(controls), shown=webp(shown), names=escape(", ".join(ranges)), caption=caption
    )


def stops(low: float, first: float, high: float, step: float) -> list[float]:
    """Where a slider stops: evenly from the least to the greatest value, on its steps; the nearest one is `first`."""
    values = [round(value / step) * step for value in np.linspace(low, high, COUNT).tolist()]
    nearest = min(range(len(values)), key=lambda index: abs(values[index] - first))
    return sorted({*values[:nearest], first, *values[nearest + 1 :]})


def webp(png: bytes) -> str:
    """A picture as the address of itself, small enough for a page that has dozens."""
    target = io.BytesIO()
    Image.open(io.BytesIO(png)).convert("RGB").save(target, "WEBP", quality=82)
    return "data:image/webp;base64," + base64.b64encode(target.getvalue()).decode()


def _control(name: str, values: Sequence[float], first: float, pictures: Sequence[str]) -> str:
    written = [f"{value:.4g}" for value in values]
    at = values.index(first)
    return CONTROL.format(
        name=escape(name), last=len(values) - 1, first=at, values=" ".join(written), pictures=" ".join(pictures),
        shown=written[at],
    )  # fmt: skip
