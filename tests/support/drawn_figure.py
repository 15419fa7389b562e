"""What a figure of matplotlib holds, in words: its axes, and of everything on them where it is and how it looks."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib import collections, colors, lines, patches, ticker
from matplotlib.axes import Axes
from matplotlib.figure import Figure


def told(figure: Figure) -> list[str]:
    """A line for the figure, for each of its axes and for everything on those."""
    first = f"{numbers(figure.get_size_inches())} inches at {figure.dpi:g}, {type(figure.get_layout_engine()).__name__}"
    return [first, *(line for axes in figure.axes for line in (_of_bar if _is_bar(axes) else _of_axes)(axes))]


def numbers(values: Any) -> str:
    """Numbers of any shape, each to five digits."""
    return " ".join(f"{round(value, 9) + 0:.5g}" for value in np.ma.filled(np.ma.asarray(values, float), np.nan).flat)


def _is_bar(axes: Axes) -> bool:
    return axes.get_label() == "<colorbar>"


def _of_bar(axes: Axes) -> Iterator[str]:
    """A bar of colours: what it shows, and how much of the picture beside it is as high."""
    yield f"bar: {axes.get_ylabel()!r} {numbers(axes.get_ylim())}, {axes._colorbar_info['shrink']} of the height"


def _of_axes(axes: Axes) -> Iterator[str]:
    yield f"axes: {axes.get_title('left')!r} {axes.get_xlabel()!r} {axes.get_ylabel()!r}, aspect {axes.get_aspect()}"
    yield f"  x {axes.get_xscale()} {numbers(axes.get_xlim())}, y {axes.get_yscale()} {numbers(axes.get_ylim())}"
    sides = [name for name, spine in axes.spines.items() if spine.get_visible()]
    grid = [axis.get_tick_params().get("gridOn", False) for axis in (axes.xaxis, axes.yaxis)]
    yield f"  lines {sides}, grid {grid} below {axes.get_axisbelow()}"
    for axis in (axes.xaxis, axes.yaxis):
        if isinstance(axis.get_major_locator(), ticker.FixedLocator):
            minor = len(axis.get_minorticklocs())
            yield f"  {axis.axis_name} at {numbers(axis.get_ticklocs())}, between them {minor}, {_names(axis)}"
    for image in axes.images:
        yield f"  image {numbers(image.get_array())}, {numbers(image.get_clim())}"
    for each in (*axes.lines, *axes.patches, *axes.collections, *axes.texts):
        yield from _look(each)
    if legend := axes.get_legend():
        words = [each.get_text() for each in legend.get_texts()]
        yield f"  legend {words}, columns {legend._ncols}, frame {legend.get_frame_on()}"


def _names(axis: Any) -> list[str]:
    is_chosen = isinstance(axis.get_major_formatter(), ticker.FixedFormatter | ticker.FuncFormatter)
    return [label.get_text() for label in axis.get_ticklabels()] if is_chosen else []


def _look(artist: Any) -> Iterator[str]:
    """Nothing of an area without height, as an empty bar of a histogram is."""
    name = "" if artist.get_label().startswith("_") else repr(artist.get_label())
    look = f"{name} opaque {artist.get_alpha()}, "
    if isinstance(artist, lines.Line2D):
        mark = f"{artist.get_marker()} {artist.get_markersize():g} {artist.get_markeredgewidth():g}"
        inks = [artist.get_color(), artist.get_markeredgecolor()]
        yield f"  line {look}{numbers(artist.get_xydata())}, {artist.get_linewidth():g}, {mark}, {inked(inks)}"
    elif isinstance(artist, patches.Patch):
        low, high = artist.axes.transData.inverted().transform(artist.get_extents())
        inks = [artist.get_facecolor(), artist.get_edgecolor()]
        if abs(high - low).min() > 1e-6:
            yield f"  area {look}{numbers([low, high])}, {artist.get_linewidth():g}, {inked(inks)}"
    elif isinstance(artist, collections.PathCollection):
        inks = [*artist.get_facecolors(), *artist.get_edgecolors()]
        sizes, widths = numbers(artist.get_sizes()), numbers(artist.get_linewidths())
        yield f"  dots {look}{numbers(artist.get_offsets())}, {sizes}, {widths}, {inked(inks)}"
    elif isinstance(artist, collections.Collection):
        corners = numbers([corner for path in artist.get_paths() for corner in path.vertices])
        inks = [*artist.get_facecolors(), *artist.get_edgecolors()]
        yield f"  areas {look}{corners}, {numbers(artist.get_linewidths())}, {inked(inks)}"
    else:
        arrow = getattr(artist, "arrow_patch", None)
        shaft = f", arrow {arrow.get_linewidth():g} {inked([arrow.get_edgecolor()])}" if arrow else ""
        where = numbers([*artist.get_position(), *getattr(artist, "xy", ())])
        yield f"  words {artist.get_text()!r} at {where}, {artist.get_fontsize():g}, {artist.get_ha()}{shaft}"


def inked(inks: Any) -> str:
    """Colours as sRGB with opacity, in hexadecimals."""
    return " ".join(colors.to_hex(ink, keep_alpha=True) for ink in inks)
