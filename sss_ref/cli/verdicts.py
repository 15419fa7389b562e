"""What `sss-ref validate` prints."""

from typing import TYPE_CHECKING

from rich.box import SIMPLE
from rich.table import Table
from rich.text import Text

from sss_ref.cli.console import out

if TYPE_CHECKING:
    from sss_ref.explanation.rows import Section
    from sss_ref.validation.report.report import Report
    from sss_ref.validation.verdict.verdict import Verdict


def print_report(found: "Report") -> None:
    """Print the verdicts and the stage at the worst pixel as tables, then what else is known, and the outcome last."""
    out.print(f"profile {found.profile}, {found.device or 'device not given'}", markup=False)
    out.print(_table(found))
    if found.finding and found.finding.section:
        out.print(_worst_pixel(found.finding.section))
    for heading, lines in (
        ("smallest relative error that this run would see", found.sensitivity),
        ("metrics of pictures, which decide nothing", list(map(str, found.likeness))),
    ):
        _print_list(heading, lines)
    if found.missing:
        out.print(f"not given: {', '.join(found.missing)}")
    times = ", ".join(f"{name} {seconds:.1f} s" for name, seconds in found.seconds.items())
    out.print(f"time: {times}")
    for line in (found.summary, *(f"  {text}" for text in (*found.details, *found.explanations))):
        out.print(line, markup=False)


def _print_list(heading: str, lines: list[str]) -> None:
    for line in [f"{heading}:", *(f"  {line}" for line in lines)] if lines else []:
        out.print(line, markup=False)


def _table(found: "Report") -> Table:
    from sss_ref.validation.verdict.outcomes import OUTCOMES

    table = Table(box=SIMPLE, title="each stage, given what was drawn before it", title_justify="left")
    for name in ("pass", "stage", "buffer"):
        table.add_column(name, no_wrap=True)
    for name in ("pixels", "same bits", *OUTCOMES, "outside", "chained", "width"):
        table.add_column(name, justify="right", no_wrap=True)
    for one in found.verdicts:
        table.add_row(*_cells(one), style=_style(one))
    table.caption = "width: of the interval in which a value is right, in ulp; of 95 % of the values at most so much"
    if any(map(any, (one.estimated for one in found.verdicts))):
        table.caption += "; ~: estimated"
    table.caption_justify = "left"
    return table


def _style(one: "Verdict") -> str | None:
    styles = (("yellow", one.inherits), ("red", one.failed), ("dim", one.empty))
    return next((style for style, holds in styles if holds), None)


def _worst_pixel(section: "Section") -> Table:
    """What a stage reads and its lines, without the calls in them and the turns of loops, which the page has."""
    table = Table(box=SIMPLE, title=f"stage {section.title} at the worst pixel", title_justify="left")
    for name in ("", "value", "may be"):
        table.add_column(name)
    for row in section.rows:
        if row.depth == 0 and row.kind != "turn":
            cells = (Text(cell) for cell in (row.text, row.value, row.may_be))  # square brackets are no markup
            table.add_row(*cells, style={"read": "dim", "got": "red"}.get(row.kind))
    return table


def _cells(one: "Verdict") -> list[str]:
    from sss_ref.validation.verdict.widths import compact

    total = one.compared
    same, whole = (f"{count / total:.2%}" if count is not None and total else "-" for count in (one.equal, one.chained))
    counted = zip(one.outcomes, one.estimated, strict=True)
    shown = [f"{'~' if about else ''}{count}" if count else "-" for count, about in counted]
    outside = str(one.background.wrong) if one.background else "-"
    return [one.pass_name, one.stage, one.buffer, str(total), same, *shown, outside, whole, compact(one.widths.most)]
