"""How the course draws: one style, a few kinds of picture, and sliders that redraw one.

Arrays have row 0 at the bottom, as everywhere in the package, and so do the pictures.
"""

import base64
import io
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from IPython.display import HTML
from ipywidgets import FloatSlider, Image, Layout, VBox
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

from sss_ref.course import frames
from sss_ref.explanation.explain import Explanation
from sss_ref.explanation.page import html
from sss_ref.explanation.rows import sections
from sss_ref.language import vec3
from sss_ref.pictures.png_file import srgb8
from sss_ref.pictures.tiles import RAMP, hashed_colours, uv_colours

INK, FAINT = "#22262e", "#9aa0aa"
BLUE, TEAL, GREEN, AMBER, RED = "#3b5fae", "#1f8a94", "#4e9f50", "#d99522", "#c6483b"
CHANNELS = (RED, GREEN, BLUE)  # of red, green and blue light
NO_VALUE = "#e9eaee"  # where nothing is drawn
RISING = ListedColormap(RAMP / 255).with_extremes(bad=NO_VALUE)  # from low to high values, as on overview.png
SIGNED = plt.get_cmap("RdBu_r").with_extremes(bad=NO_VALUE)  # white is no difference

plt.rcParams.update(
    {
        "figure.dpi": 110,
        "figure.constrained_layout.use": True,
        "font.size": 10,
        "text.color": INK,
        "axes.edgecolor": FAINT,
        "axes.labelcolor": INK,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.titlelocation": "left",
        "axes.titlesize": 10.5,
        "image.origin": "lower",
        "legend.frameon": False,
        "lines.linewidth": 1.8,
        "xtick.color": INK,
        "ytick.color": INK,
    }
)


def row(count: int, height: float = 3.3, width: float | None = None) -> tuple[Figure, list[Axes]]:
    """A figure of `count` axes beside each other, each `height` x `width` inches (as wide as high unless given)."""
    figure, axes = plt.subplots(1, count, figsize=(count * (width or height), height), squeeze=False)
    return figure, list(axes[0])


def picture(axes: Axes, image: np.ndarray, title: str, encode: Callable[[np.ndarray], np.ndarray] = srgb8) -> None:
    """A linear RGB image (H, W, 3) of any float type, encoded for a screen."""
    axes.imshow(encode(image.astype(np.float32)))
    bare(axes, title)


def values(
    axes: Axes,
    field: np.ndarray,
    title: str,
    unit: str,
    where: np.ndarray | None = None,
    limits: tuple[float, float] | None = None,
) -> None:
    """A number for every pixel (H, W) with its colour bar; `where` is not 0: the pixels that have one."""
    shown = np.ma.masked_array(field, np.zeros(field.shape, bool) if where is None else where == 0)
    low, high = limits or (shown.min(), shown.max())
    drawn = axes.imshow(shown, cmap=RISING, vmin=low, vmax=high)
    plt.colorbar(drawn, ax=axes, label=unit, shrink=0.75)
    bare(axes, title)


def difference(axes: Axes, field: np.ndarray, title: str, unit: str, where: np.ndarray, limit: float) -> None:
    """A signed number for every pixel (H, W): blue below, red above 0."""
    shown = np.ma.masked_array(field, where == 0)
    drawn = axes.imshow(shown, cmap=SIGNED, vmin=-limit, vmax=limit)
    plt.colorbar(drawn, ax=axes, label=unit, shrink=0.75)
    bare(axes, title)


def samples(axes: Axes, count: np.ndarray, outline: Sequence[tuple[int, int]], title: str) -> None:
    """How often each sample of a small grid (H, W) is drawn, 0, 1 or 2 times, and the outline of what is drawn."""
    axes.imshow(count, cmap=ListedColormap(["white", "#cfe0ee", "#e9b3a6"]), vmin=0, vmax=2)
    rows, columns = np.indices(count.shape)
    axes.scatter(columns, rows, s=5, c=np.where(count.ravel() > 0, INK, FAINT), linewidths=0)
    axes.plot(*zip(*outline, outline[0], strict=True), color=BLUE, linewidth=1.4)
    bare(axes, title)


def triangles(axes: Axes, index: np.ndarray, title: str) -> None:
    """Which triangle each pixel (H, W) sees, every one in a colour of its own; -1: none."""
    axes.imshow(np.where(index[..., None] >= 0, hashed_colours(index), np.uint8(234)))
    bare(axes, title)


def directions(axes: Axes, vectors: np.ndarray, title: str, where: np.ndarray) -> None:
    """A unit vector for every pixel (H, W, 3) as the colour (v + 1)/2."""
    axes.imshow(np.where(where[..., None] != 0, (vectors + 1) / 2, 0.92))
    bare(axes, title)


def texture_coordinates(axes: Axes, uv: np.ndarray, title: str, where: np.ndarray) -> None:
    """A texture coordinate for every pixel (H, W, 2) as red and green."""
    axes.imshow(np.where(where[..., None] != 0, uv_colours(uv), np.uint8(234)))
    bare(axes, title)


def taps(axes: Axes, offsets: np.ndarray, weights: np.ndarray, title: str, color: str) -> None:
    """The taps of a kernel as circles: at their offsets (N, 2) in pixels, areas as their weights (N,)."""
    axes.scatter(offsets[:, 0], offsets[:, 1], s=1800 * weights, color=color, alpha=0.45, edgecolors=color)
    axes.scatter(offsets[:, 0], offsets[:, 1], s=3, color=INK)
    axes.set(title=title, xlim=(-8, 8), ylim=(-8, 8), aspect="equal", xlabel="pixels", ylabel="pixels")
    axes.set(xticks=range(-8, 9, 4), yticks=range(-8, 9, 4))
    axes.grid(color=NO_VALUE)
    axes.set_axisbelow(True)


def centres(axes: Axes, shift: np.ndarray, title: str) -> None:
    """Where a blur moves the centre of each colour: shift (2, 3), x and y in pixels of red, green and blue."""
    axes.axhline(0, color=FAINT, linewidth=0.8)
    axes.axvline(0, color=FAINT, linewidth=0.8)
    axes.scatter(shift[0], shift[1], c=CHANNELS, s=60)
    axes.set(title=title, xlim=(-0.3, 0.3), ylim=(-0.3, 0.3), aspect="equal")
    axes.set(xlabel="pixels to the right", ylabel="pixels up")


def ways_through_a_disk(light: vec3, entry: vec3, fragment: vec3) -> None:
    """Light that goes from a point into the unit disk at `entry` and leaves it at `fragment`, seen from above."""
    _, (axes,) = row(1, 3.0, 6.6)
    axes.add_patch(Circle((0, 0), 1, color=NO_VALUE))
    axes.plot([0 * entry.x + light.x, entry.x], [0 * entry.y + light.y, entry.y], color=AMBER, linewidth=1)
    axes.plot([entry.x, fragment.x], [entry.y, fragment.y], color=RED, linewidth=1.6)
    axes.scatter(light.x, light.y, s=90, color=AMBER)
    for text, place in (("$L$", (light.x, 0.15)), ("$E$", (-0.95, 0.75)), ("$P$", (0.75, 0.95))):
        axes.annotate(text, place, ha="center", fontsize=12)
    axes.set(aspect="equal", xlim=(-3.3, 1.4), ylim=(-1.15, 1.25))
    bare(axes, "Amber: the stored distance $t$. Red: the thickness $d$.")


def layout(axes: Axes, uvs: np.ndarray, triangles: np.ndarray, title: str) -> None:
    """The triangles (T, 3) of a mesh where its texture coordinates (V, 2) put them."""
    axes.add_collection(PolyCollection(uvs[triangles], facecolors="#dbe6f0", edgecolors=BLUE, linewidths=0.1))
    axes.add_patch(Rectangle((0, 0), 1, 1, fill=False, edgecolor=FAINT))
    axes.set(title=title, aspect="equal", xlim=(-0.02, 1.02), ylim=(-0.02, 1.02), xlabel="u", ylabel="v")


def spreads(samples: Mapping[str, np.ndarray], title: str, x_label: str) -> None:
    """Histograms of several sets of positive numbers, each relative to its own median, on a logarithmic axis."""
    _, (axes,) = row(1, 2.9, 6.6)
    bins = np.geomspace(0.25, 8, 90).tolist()
    for (name, numbers), color in zip(samples.items(), (BLUE, AMBER), strict=False):
        share = np.full(len(numbers), 100 / len(numbers))
        axes.hist(numbers / np.median(numbers), bins, weights=share, color=color, alpha=0.6, label=name)
    axes.set(title=title, xlabel=x_label, ylabel="% of the pixels", xscale="log")
    axes.set_xticks([0.25, 0.5, 1, 2, 4, 8], labels=["1/4", "1/2", "1", "2", "4", "8"])
    axes.minorticks_off()
    axes.legend()


def curves(
    labels: tuple[str, str, str],
    x: np.ndarray,
    lines: Mapping[str, np.ndarray],
    colors: Sequence[str] = (BLUE, AMBER, TEAL, RED, GREEN),
) -> Axes:
    """Curves over one x, each with its name; labels: title, what x is and what the curves are, with units."""
    _, (axes,) = row(1, 3.3, 6.6)
    title, x_label, y_label = labels
    axes.set(title=title, xlabel=x_label, ylabel=y_label)
    axes.grid(color=NO_VALUE)
    for (name, y), color in zip(lines.items(), colors, strict=False):
        axes.plot(x, y, color=color, label=name)
    if len(lines) > 1:
        axes.legend()
    return axes


def number_line(numbers: np.ndarray, title: str) -> None:
    """Numbers as strokes on their line."""
    _, (axes,) = row(1, 0.9, 6.6)
    axes.vlines(numbers, 0, 1, color=BLUE, linewidth=1.2)
    axes.set(title=title, yticks=[], ylim=(0, 1.1))
    axes.spines["left"].set_visible(False)


def bands(axes: Axes, x: np.ndarray, reach: Mapping[str, tuple[np.ndarray, np.ndarray]], title: str) -> None:
    """How far below and above the oracle values may lie: name -> (low, high) in ULP, the widest first."""
    for (name, (low, high)), color in zip(reach.items(), ("#f0d9a8", "#8fa6d6", RED), strict=True):
        axes.fill_between(x, low, high, color=color, linewidth=1.2, label=name, step="mid")
    axes.set(title=title, xlabel="column of the picture", ylabel="ULP from the oracle")
    axes.set(yscale="symlog", ylim=(-1e6, 1e6), yticks=[-1e5, -1e3, -10, 0, 10, 1e3, 1e5])
    axes.legend(loc="upper right", ncols=3)


def shares(names: Sequence[str], lines: Mapping[str, Sequence[float]], title: str) -> None:
    """Two shares (0 to 1) of each named buffer as bars in percent, the first buffer on top."""
    _, (axes,) = row(1, 0.17 * len(names) + 0.7, 6.6)
    places = np.arange(len(names))
    for (label, share), color, shift in zip(lines.items(), (AMBER, RED), (-0.2, 0.2), strict=True):
        axes.barh(places + shift, 100 * np.asarray(share), 0.4, color=color, label=label)
    axes.set(title=title)
    axes.set_yticks(places, labels=names)
    axes.invert_yaxis()
    axes.legend()


def mark(axes: Axes, pixel: tuple[int, int]) -> None:
    """A ring around a pixel (column, row)."""
    axes.plot(*pixel, marker="o", markersize=13, markerfacecolor="none", markeredgecolor="white", markeredgewidth=3.2)
    axes.plot(*pixel, marker="o", markersize=13, markerfacecolor="none", markeredgecolor=RED, markeredgewidth=1.6)


def explained(explanation: Explanation, stage: str) -> HTML:
    """The part of an explanation that belongs to one stage, as a notebook shows it."""
    return HTML(html(sections(explanation.passes, stage)))


def bare(axes: Axes, title: str) -> None:
    """Axes without ticks and frame, for what is a picture."""
    axes.set(title=title, xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


class Sliders:
    """A figure with a slider for each of its parameters, drawn anew while one moves.

    draw: called with the parameters by name; gives a figure. ranges: name -> (least, first, greatest value).
    A notebook shows the sliders where widgets run; where they do not, the figure for the first values, and says so, or
    sliders over pictures that are drawn beforehand (`sss_ref.course.frames`).
    """

    def __init__(self, draw: Callable[..., Figure], **ranges: tuple[float, float, float]) -> None:
        self.draw = draw
        self.controls = {name: _slider(name, *limits) for name, limits in ranges.items()}
        self.shown = Image(format="png", layout=Layout(max_width="100%"))
        for control in self.controls.values():
            control.observe(lambda change: self.redraw(), "value")
        self.redraw()

    def redraw(self) -> None:
        """Draw the figure for the values that the sliders have now."""
        self.shown.value = self.png({name: control.value for name, control in self.controls.items()})

    def png(self, values: Mapping[str, float]) -> bytes:
        """The figure for these values as the bytes of a PNG file."""
        return png_of(self.draw(**values))

    def page(self) -> str:
        """What a page without widgets shows."""
        if frames.wanted():
            ranges = {name: (each.min, each.value, each.max, each.step) for name, each in self.controls.items()}
            return frames.page(self.png, ranges)
        caption = f"In Jupyter, with sliders for {', '.join(self.controls)}."
        png = base64.b64encode(self.shown.value).decode()
        return f'<figure><img src="data:image/png;base64,{png}"><figcaption>{caption}</figcaption></figure>'

    def _repr_mimebundle_(self, **options: Any) -> dict[str, Any]:
        """The widgets, and for readers without them the picture, as a page and alone."""
        left = Layout(align_items="flex-start")  # or the picture would be stretched
        widgets: dict[str, Any] = VBox([*self.controls.values(), self.shown], layout=left)._repr_mimebundle_(**options)
        return widgets | {"text/html": self.page(), "image/png": base64.b64encode(self.shown.value).decode()}


def png_of(figure: Figure) -> bytes:
    """A figure as the bytes of a PNG file; closes it, so that it is not shown a second time."""
    target = io.BytesIO()
    figure.savefig(target, format="png")
    plt.close(figure)
    return target.getvalue()


def _slider(name: str, low: float, first: float, high: float) -> FloatSlider:
    step = 10.0 ** math.floor(math.log10((high - low) / 100))  # a power of ten, so that `first` lies on a step
    return FloatSlider(value=first, min=low, max=high, step=step, description=name, layout=Layout(width="28em"))
