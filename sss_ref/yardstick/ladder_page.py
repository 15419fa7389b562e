"""A ladder as one page of HTML that needs nothing else."""

from collections.abc import Iterable
from html import escape

from sss_ref.pictures.self_contained import data_url, whole_page
from sss_ref.yardstick.color_difference import MISSING, has_color_difference
from sss_ref.yardstick.ladder import By, Ladder
from sss_ref.yardstick.ladder_pictures import (
    SPAN,
    colour_bar,
    exposed,
    region_colour,
    region_map,
    signed,
)
from sss_ref.yardstick.ladder_style import LADDER_STYLE
from sss_ref.yardstick.ladder_table import GPU, NOISE, OVERALL, rows
from sss_ref.yardstick.regions import SAID
from sss_ref.yardstick.rungs import Rung

BESIDE = (NOISE, GPU)
HOTTEST = 0.5  # the mean error with the deepest colour
SAYS = (
    "The error of a pixel is the sum over red, green and blue of what lies between the picture and the truth, over the "
    "truth's sum, or over a twentieth of white's where it is darker. mean: of all pixels; 95 %: so many are no farther "
    "off; bias: all light of the picture over the truth's; rms: of a channel, less the truth's noise, over its mean; "
    "dE: CIEDE2000, both pictures with one exposure. Nothing can be said to be nearer than the noise of the truth."
)


def as_html(ladder: Ladder) -> str:
    """The page: tables, the rows of pictures, and where on the body what lies."""
    title = f"{ladder.of.name}: how far from the truth?"
    parts = [
        f"<h1>{escape(title)}</h1>{_facts(ladder)}",
        _notes(ladder),
        f"<h2>How far off</h2>{_overall(ladder)}<p class='soft'>{escape(SAYS)}</p>",
        f"<h2>Where: the mean error in each region</h2>{_by_region(ladder)}",
        _where(ladder),
        f"<h2>Picture, truth, and what lies between</h2>{_bar()}<div class='rows'>{_rows(ladder)}</div>",
    ]
    return whole_page(title, LADDER_STYLE, "".join(parts))


def _facts(ladder: Ladder) -> str:
    height, width = ladder.masks["everywhere"].shape
    unit = ladder.of.given.settings.mm_per_unit
    facts = (
        f"medium {ladder.of.medium}",
        f"{unit:g} mm a unit",
        f"border {ladder.of.border}",
        f"{width} x {height} pixels",
        f"{ladder.radiance.samples} samples a pixel, {ladder.radiance.lost} lost",
        f"diffusion length {ladder.regions.length:.2f} mm",
    )
    return f'<p class="facts">{"".join(f"<span>{escape(fact)}</span>" for fact in facts)}</p>'


def _notes(ladder: Ladder) -> str:
    notes = [f"Left out of all pictures, as the truth has none: {', '.join(ladder.of.left_out)}."]
    found = notes if ladder.of.left_out else []
    return "".join(
        f'<p class="soft">{escape(note)}</p>' for note in (*found, *([MISSING] * (not has_color_difference())))
    )


def _overall(ladder: Ladder) -> str:
    shown = (
        _row(name, [*cells[: len(OVERALL)], cells[-1]], "beside" * (name in BESIDE)) for name, *cells in rows(ladder)
    )
    return _table(["", *OVERALL, "ms of one processor"], shown)


def _by_region(ladder: Ladder) -> str:
    names = list(ladder.masks)
    shown = [_heat(NOISE, ladder.noise, "beside")]
    if ladder.gpu is not None:
        shown.append(_heat(GPU, ladder.gpu, "beside"))
    shown += [_heat(rung.name, ladder.deviations[rung.name]) for rung in ladder.rungs]
    return _table(["", *names], shown)


def _table(head: Iterable[str], lines: Iterable[str]) -> str:
    cells = "".join(f"<th>{escape(name)}</th>" for name in head)
    return f'<div class="scroll"><table><thead><tr>{cells}</tr></thead><tbody>{"".join(lines)}</tbody></table></div>'


def _row(name: str, cells: Iterable[str], kind: str = "") -> str:
    return f'<tr class="{kind}"><td>{escape(name)}</td>{"".join(f"<td>{cell}</td>" for cell in cells)}</tr>'


def _heat(name: str, found: By, kind: str = "") -> str:
    """A row of mean errors, the deeper coloured the larger."""
    cells = (
        f'<td style="--share: {min(one.mean / HOTTEST, 1) * 0.6:.2f}">{one.mean:.1%}</td>' for one in found.values()
    )
    return f'<tr class="{kind}"><td>{escape(name)}</td>{"".join(cells)}</tr>'


def _where(ladder: Ladder) -> str:
    items = "".join(_region(name, int(mask.sum())) for name, mask in ladder.masks.items())
    shown = _figure(data_url(region_map(ladder)), "the regions; of several the last in the list")
    return f'<div class="where">{shown}<ul>{items}</ul></div>'


def _region(name: str, pixels: int) -> str:
    swatch = f'<i style="background:{region_colour(name)}"></i>'
    return f"<li>{swatch}<b>{name}</b> ({pixels} pixels): {SAID[name]}</li>"


def _bar() -> str:
    bar = data_url(colour_bar(256, 1))
    dark, bright = f"{SPAN:.0%} of white too dark", "too bright"
    return f'<p class="bar soft"><span>{dark}</span><img alt="" src="{bar}"><span>{bright}</span></p>'


def _rows(ladder: Ladder) -> str:
    truth = data_url(exposed(ladder.truth.mean, ladder.truth))
    return "".join(_pictures(ladder, rung, truth) for rung in ladder.rungs)


def _pictures(ladder: Ladder, rung: Rung, truth: str) -> str:
    own = data_url(exposed(rung.image, ladder.truth))
    apart = data_url(signed(rung.image, ladder.truth, ladder.masks["everywhere"]))
    figures = (_figure(own, rung.method), _figure(truth, "truth"), _figure(apart, "difference"))
    return f'<section class="row"><h3>{escape(rung.name)}</h3><div>{"".join(figures)}</div></section>'


def _figure(url: str, caption: str) -> str:
    return f'<figure><img alt="{escape(caption)}" src="{url}"><figcaption>{escape(caption)}</figcaption></figure>'
