"""Every kind of figure of the course, once, of a few numbers each; as a program it prints what is on them.

python tests/support/small_figures.py > tests/course/figures.txt
"""

from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
from drawn_figure import told
from matplotlib import pyplot
from matplotlib.figure import Figure

from sss_ref.course import diffusion_figures, figures
from sss_ref.language import vec3

FIELD = np.array([[1.0, 2.0], [3.0, 5.0]])
WHERE = np.array([[1, 0], [1, 1]])
LINE = np.array([1.0, 2.0, 4.0])
CORNERS = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
WAYS = [np.array([[0.0, 0, 0], [1, 0, 1], [1, 0, -1]]), np.array([[0.0, 0, 0], [0, 0, 1]])]
WALKED = SimpleNamespace(
    radii=np.arange(49) / 8, counts=np.repeat([1, 2, 0, 9], [16, 16, 16, 1]), tally=SimpleNamespace(photons=100)
)
LAW = SimpleNamespace(thickness=np.array([1.0, 2.0]), share=np.array([0.5, 0.25]), error=np.array([0.1, 0.2]))


def on_axes(draw: Callable[..., object], *given: object) -> Callable[[], object]:
    """A figure of one pair of axes, on which something is drawn."""
    return lambda: draw(figures.row(1)[1][0], *given)


FIGURES: dict[str, Callable[[], object]] = {
    "row": lambda: figures.row(2, 2.0, 5.0),
    "picture": on_axes(figures.picture, np.float32([[[0.5, 0, 1]]]), "a picture"),
    "values": on_axes(figures.values, FIELD, "values", "mm", WHERE),
    "values between limits": on_axes(figures.values, FIELD, "values", "mm", None, (0, 9)),
    "difference": on_axes(figures.difference, FIELD, "difference", "mm", WHERE, 4.0),
    "samples": on_axes(figures.samples, np.array([[0, 1], [2, 1]]), [(0, 0), (1, 0), (1, 1)], "samples"),
    "triangles": on_axes(figures.triangles, np.array([[-1, 0], [1, 2]]), "triangles"),
    "directions": on_axes(figures.directions, np.array([[[-1.0, 0, 1], [0, 1, 0]]]), "directions", WHERE[:1]),
    "texture_coordinates": on_axes(figures.texture_coordinates, np.array([[[0.5, 1], [0, 0]]]), "uv", WHERE[:1]),
    "taps": on_axes(figures.taps, np.array([[0.0, 0], [3, -2]]), np.array([0.75, 0.25]), "taps", figures.BLUE),
    "centres": on_axes(figures.centres, np.array([[0.1, 0, 0.2], [-0.1, 0.05, 0]]), "centres"),
    "ways_through_a_disk": lambda: figures.ways_through_a_disk(
        vec3(-3.0, 0.25, 0.0), vec3(-0.75, 0.5, 0.0), vec3(0.5, 0.75, 0.0)
    ),
    "layout": on_axes(figures.layout, CORNERS, np.array([[0, 1, 2]]), "layout"),
    "spreads": lambda: figures.spreads({"a": LINE, "b": LINE[:2]}, "spreads", "times the median"),
    "curves": lambda: figures.curves(("curves", "x, mm", "y, mm"), LINE, {"a": LINE, "b": 2 * LINE}),
    "one curve": lambda: figures.curves(("curve", "x", "y"), LINE, {"a": LINE}),
    "number_line": lambda: figures.number_line(LINE, "numbers"),
    "bands": on_axes(
        figures.bands, LINE, {name: (-k * LINE, k * LINE) for name, k in (("a", 100), ("b", 10), ("c", 1))}, "bands"
    ),
    "shares": lambda: figures.shares(["x", "y"], {"first": [0.5, 1.0], "second": [0.25, 0.0]}, "shares"),
    "mark": on_axes(figures.mark, (3, 4)),
    "paths": on_axes(diffusion_figures.paths, WAYS, 4.0),
    "profile": on_axes(diffusion_figures.profile, WALKED, figures.BLUE, "walked"),
    "stairs": on_axes(diffusion_figures.stairs, np.array([2.0, 0, 1]), np.array([1.0, 2, 1]), figures.RED),
    "transmittance": on_axes(diffusion_figures.transmittance, [LAW] * 3, [LAW.share] * 3, "through slabs"),
    "bars": lambda: diffusion_figures.bars({"first": 3.0, "second": 1.0}, "bars", "delta E", 0.5),
    "bars without noise": lambda: diffusion_figures.bars({"first": 3.0}, "bars", "delta E"),
}


def figure_of(name: str) -> Figure:
    """One of them, drawn."""
    pyplot.close("all")
    FIGURES[name]()
    return pyplot.gcf()


def text() -> str:
    """What is on each of them, under its name."""
    return "\n".join(line for name in FIGURES for line in (f"[{name}]", *told(figure_of(name)), ""))


if __name__ == "__main__":
    pyplot.switch_backend("agg")
    print(text(), end="")
