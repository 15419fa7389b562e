"""A report as files: one HTML page that needs nothing else, and JSON for programs."""

import json
from collections.abc import Iterable
from html import escape
from pathlib import Path

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_texts
from sss_ref.explanation.page import html as explained
from sss_ref.pictures.self_contained import whole_page
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.report.report import Report
from sss_ref.validation.report.report_data import as_json
from sss_ref.validation.report.report_pictures import legend, pictures
from sss_ref.validation.report.report_style import REPORT_STYLE
from sss_ref.validation.report.report_table import buffer_table, power_table


def write_report(report: Report, folder: Path, title: str) -> Path:
    """Write a report as report.html and report.json into a folder, which is made if need be; returns the page's path.

    title: what was judged, for the page's heading. Raises DumpError for a folder that cannot be written.
    """
    data = json.dumps(as_json(report), indent=1) + "\n"
    write_texts(folder, {"report.json": data, "report.html": as_html(report, title)}, DumpError)
    return folder / "report.html"


def as_html(report: Report, title: str) -> str:
    """The report as a page."""
    found = report.finding
    parts = [
        f"<h1>{escape(title)}</h1>{_circumstances(report)}",
        f'<p class="verdict {"passed" if report.passed else "failed"}">{escape(report.summary)}</p>',
        _list(report.details),
        _section("What would explain it", _list(report.explanations)),
        _section(f"{found.check.stage}: {found.check.buffer}", _pictures(found.check)) if found else "",
        _section("Each stage, given what was drawn before it", buffer_table(report.verdicts)),
        f'<p class="soft">Not given: {escape(", ".join(report.missing))}.</p>' if report.missing else "",
        _section("The worst pixel, as it should have been", _worst(report)),
        _section("What this run would see", power_table(report) if report.power else ""),
        _section("What metrics of pictures say", _list(map(str, report.likeness))),
        _section("Where the time went", _chips(_times(report))),
    ]
    return whole_page(title, REPORT_STYLE, "".join(parts))


def _section(heading: str, content: str) -> str:
    """A headed part of the page; nothing where there is nothing to say."""
    return f"<h2>{escape(heading)}</h2>{content}" if content else ""


def _list(lines: Iterable[str]) -> str:
    items = "".join(f"<li>{escape(line)}</li>" for line in lines)
    return f"<ul>{items}</ul>" if items else ""


def _chips(facts: Iterable[str]) -> str:
    return f'<p class="facts">{"".join(f"<span>{escape(fact)}</span>" for fact in facts)}</p>'


def _circumstances(report: Report) -> str:
    """What was judged, as what, and how long that took."""
    facts = [f"profile {report.profile}", report.device or "device not given", f"{len(report.verdicts)} buffers"]
    facts.append(f"{sum(report.seconds.values()):.1f} s")
    return _chips(facts)


def _pictures(check: Check) -> str:
    figures = "".join(
        f'<figure><img alt="{escape(caption)}" src="{url}"><figcaption>{escape(caption)}</figcaption></figure>'
        for caption, url in pictures(check)
    )
    return f'<div class="pictures">{figures}</div>{legend()}'


def _worst(report: Report) -> str:
    found, wrong = report.finding, report.culprit
    if found is None or found.section is None or wrong is None:
        return ""
    return f"<p>What was drawn {escape(str(wrong.worst))}.</p>{explained([found.section])}"


def _times(report: Report) -> list[str]:
    return [f"{name} {seconds:.2f} s" for name, seconds in report.seconds.items()]
