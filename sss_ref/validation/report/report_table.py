"""The tables of the page: the buffers with their outcomes, and what the run would have seen."""

from collections.abc import Iterable, Sequence
from html import escape
from itertools import groupby

from sss_ref.results.diff import ULP_CLASSES
from sss_ref.validation.cause.power import Power
from sss_ref.validation.report.report import Report
from sss_ref.validation.report.report_pictures import css_colour, legend
from sss_ref.validation.verdict.outcomes import OUTCOMES
from sss_ref.validation.verdict.verdict import Verdict
from sss_ref.validation.verdict.widths import WIDTH_CLASSES, compact

BAR, BARS = 110, 16  # width of a bar of outcomes, height of a histogram, in CSS pixels
LEAST = 2  # height of a class that holds anything at all
HEADS = ("buffer", "outcome", "pixels", "same bits", *OUTCOMES, "outside", "chained", "widths", "95 %", "ulp off")


def buffer_table(verdicts: Sequence[Verdict]) -> str:
    """A row for every buffer, grouped by passes."""
    head = "".join(f"<th>{escape(name)}</th>" for name in HEADS)
    body = "".join(_pass_rows(name, group) for name, group in groupby(verdicts, lambda verdict: verdict.pass_name))
    table = f'<table class="buffers"><thead><tr>{head}</tr></thead>{body}</table>'
    return f'<div class="scroll">{table}</div>{legend()}{_classes()}'


def power_table(report: Report) -> str:
    """A row for every stage whose numbers or source were tried."""
    rows = "".join(map(_power_row, report.power))
    head = "<tr><th>stage</th><th>smallest relative error that would be seen</th><th>mistakes seen</th></tr>"
    return f'<table class="power">{head}{rows}</table>'


def _pass_rows(name: str, verdicts: Iterable[Verdict]) -> str:
    head = f'<tr class="pass"><th colspan="{len(HEADS)}">pass {escape(name)}</th></tr>'
    return f"<tbody>{head}{''.join(map(_row, verdicts))}</tbody>"


def _row(verdict: Verdict) -> str:
    counted = zip(verdict.outcomes, verdict.estimated, strict=True)
    counts = [f"{'~' if about else ''}{count:,}" if count else "·" for count, about in counted]
    same, whole = (_share(count, verdict.compared) for count in (verdict.equal, verdict.chained))
    widths, ulps = _histogram(verdict.widths.counts, WIDTH_CLASSES), _histogram(verdict.ulps, ULP_CLASSES)
    name = f"{escape(verdict.buffer)}<small>{escape(verdict.stage)}</small>"
    compared, most = f"{verdict.compared:,}", compact(verdict.widths.most)
    outside = f"{verdict.background.wrong:,}" if verdict.background else "·"
    texts = [name, _outcome_bar(verdict), compared, same, *counts, outside, whole, widths, most, ulps]
    kinds = (("inherits", verdict.inherits), ("fail", verdict.failed), ("empty", verdict.empty))
    kind = "".join(f' class="{name}"' for name, holds in kinds if holds)
    return f"<tr{kind}>{''.join(f'<td>{text}</td>' for text in texts)}</tr>"


def _share(count: int | None, total: int) -> str:
    return "·" if count is None or not total else f"{count / total:.2%}"


def _outcome_bar(verdict: Verdict) -> str:
    """A bar whose parts are as wide as the shares of the outcomes, none that is there thinner than two pixels."""
    there = [(name, count) for name, count in zip(OUTCOMES, verdict.outcomes, strict=True) if count]
    parts = (
        f'<i title="{name} {count}" style="flex:{count} 0 {LEAST}px;background:{css_colour(name)}"></i>'
        for name, count in there
    )
    return f'<span class="bar" style="width:{BAR}px">{"".join(parts)}</span>'


def _histogram(counts: Sequence[int], classes: Sequence[str]) -> str:
    """A column for each class."""
    most, columns = max(*counts, 1), []
    for k, count in enumerate(counts):
        height = max(LEAST, BARS * count / most) if count else 0
        column = f'<rect x="{9 * k}" y="{BARS - height:.1f}" width="8" height="{height:.1f}"/>'
        columns.append(f'{column}<rect class="base" x="{9 * k}" y="{BARS}" width="8" height="1"/>')
    told = ", ".join(f"{name}: {count}" for name, count in zip(classes, counts, strict=True) if count)
    size = f'width="{9 * len(classes)}" height="{BARS + 1}"'
    return f'<svg class="histogram" {size} role="img"><title>{escape(told)}</title>{"".join(columns)}</svg>'


def _classes() -> str:
    """What the columns of the two histograms stand for."""
    widths, ulps = (escape(", ".join(classes)) for classes in (WIDTH_CLASSES, ULP_CLASSES))
    most = "95 %: the width that so many of the values have at most"
    about = "~: estimated from a sample, where values are the exact ones"
    return f'<p class="soft">Widths of the intervals, in ulp: {widths}; {most}. Ulp off: {ulps}. {about}.</p>'


def _power_row(power: Power) -> str:
    numbers = "".join(
        f'<span class="number{" blind" if each.change is None else ""}">{escape(str(each))}</span>'
        for each in power.numbers
    )
    unseen = "".join(f"<div>not: <code>{escape(text)}</code></div>" for text in power.unseen)
    unseen += "".join(f"<div>no difference here: {escape(text)}</div>" for text in power.hidden)
    seen = f"{power.seen} of {power.mistakes}" if power.mistakes else "·"
    return f"<tr><td>{escape(power.stage)}</td><td>{numbers}</td><td>{seen}{unseen}</td></tr>"
