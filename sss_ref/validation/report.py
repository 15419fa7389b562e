"""A report as files: one HTML page that needs nothing else, and JSON for programs."""

import base64
import json
from html import escape
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.explanation.page import html as explained
from sss_ref.io import tiles
from sss_ref.io.diff import ULP_CLASSES
from sss_ref.validation.passages import within
from sss_ref.validation.rebased import Check
from sss_ref.validation.verdict import Finding, Report, Verdict

MAP_WIDTH = 370  # pixels of a picture in the page
RIGHT, WRONG, NOT_COMPARED = (54, 104, 84), (236, 82, 62), (28, 30, 36)

STYLE = """
:root { color-scheme: light dark; --soft: #8a8f98; --line: #8884; --good: #2f8f5b; --bad: #d1442f; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 1180px; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin: 0; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
.verdict { border-left: 6px solid var(--good); padding: .6rem 1rem; margin: 1rem 0; background: #8881; }
.verdict.fail { border-color: var(--bad); } .soft { color: var(--soft); }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; } figure { margin: 0; } figcaption { color: var(--soft); }
img { max-width: 100%; image-rendering: pixelated; border-radius: 4px; }
.scroll { overflow-x: auto; } table.buffers { border-collapse: collapse; font-variant-numeric: tabular-nums; }
table.buffers td, table.buffers th { padding: 2px 12px 2px 0; text-align: right; white-space: nowrap; }
table.buffers td:nth-child(-n+3), table.buffers th:nth-child(-n+3) { text-align: left; }
table.buffers tr { border-bottom: 1px solid var(--line); } tr.fail td { color: var(--bad); font-weight: 600; }
tr.inherits td { color: #b07a1e; }
"""


def write_report(report: Report, folder: Path, title: str) -> Path:
    """Write a report as report.html and report.json into a folder, which is made if need be; returns the page's path.

    title: what was judged, for the page's heading. Raises DumpError for a folder that cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "report.json").write_text(json.dumps(as_json(report), indent=1) + "\n", encoding="utf-8")
        (folder / "report.html").write_text(as_html(report, title), encoding="utf-8")
    except OSError as error:
        reason = error.strerror or error
        raise DumpError(f"{folder}: expected a folder to write the report to, got {reason}; choose another") from None
    return folder / "report.html"


def as_json(report: Report) -> dict[str, Any]:
    """The report as plain data."""
    return {
        "passed": report.passed,
        "summary": report.summary,
        "explanations": [
            {"text": each.text, "share": each.share} for each in (report.finding.hypotheses if report.finding else ())
        ],
        "missing": list(report.missing),
        "ulp_classes": list(ULP_CLASSES),
        "buffers": [
            {
                "pass": one.pass_name,
                "stage": one.stage,
                "buffer": one.buffer,
                "passed": one.passed,
                "pixels": one.compared,
                "same_bits": one.equal,
                "within_reach": one.within,
                "within_chained": one.chained,
                "inherits": one.inherits,
                "ambiguous": one.ambiguous,
                "unbounded": one.unbounded,
                "ulps": list(one.ulps),
                "worst": one.worst,
                "worst_pixel": one.worst_pixel,
            }
            for one in report.verdicts
        ],
    }


def as_html(report: Report, title: str) -> str:
    """The report as a page."""
    found = report.finding
    parts = [
        f"<h1>{escape(title)}</h1>",
        f'<p class="verdict{"" if report.passed else " fail"}">{escape(report.summary)}</p>',
        _explanations(report),
        _pictures(found.check) if found else "",
        _table(report),
        f'<p class="soft">Not given: {escape(", ".join(report.missing))}.</p>' if report.missing else "",
        _worst(found) if found else "",
    ]
    head = f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{escape(title)}</title>'
    viewport = '<meta name="viewport" content="width=device-width, initial-scale=1">'
    return f"{head}{viewport}<style>{STYLE}</style>{''.join(parts)}</html>\n"


def _explanations(report: Report) -> str:
    items = "".join(f"<li>{escape(text)}</li>" for text in report.explanations)
    heading = "<h2>What would explain it</h2>" if items else ""
    return f"{heading}<ul>{items}</ul>" if items else ""


def _pictures(check: Check) -> str:
    """The buffer as it is, as it should be, and where they differ."""
    on = check.where
    shown = {
        f"{check.buffer} as drawn": tiles.picture(check.buffer, np.nan_to_num(check.got), on),
        "as its stage makes it of what was drawn before": tiles.picture(check.buffer, check.expected, on),
        "red: out of reach; green: right; dark: not compared": _map(check),
    }
    figures = "".join(
        f'<figure><img alt="{escape(text)}" src="{_png(pixels)}"><figcaption>{escape(text)}</figcaption></figure>'
        for text, pixels in shown.items()
    )
    return f'<h2>{escape(check.stage)}: {escape(check.buffer)}</h2><div class="pictures">{figures}</div>'


def _map(check: Check) -> np.ndarray:
    pixels = np.empty((*check.where.shape, 3), np.uint8)
    pixels[...] = NOT_COMPARED
    right = within(check, check.got, check.expected)
    pixels[check.where & right] = RIGHT
    pixels[check.where & ~right] = WRONG
    return pixels


def _png(pixels: np.ndarray) -> str:
    """A data URL; row 0 is at the bottom."""
    from PIL import Image

    image = Image.fromarray(np.ascontiguousarray(pixels[::-1]))
    scale = MAP_WIDTH / image.width
    image = image.resize((MAP_WIDTH, max(1, round(image.height * scale))), Image.Resampling.NEAREST)
    buffer = BytesIO()
    image.save(buffer, "PNG")
    return "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode()


def _table(report: Report) -> str:
    names = [
        "pass",
        "stage",
        "buffer",
        "pixels",
        "same bits",
        "in reach",
        "chained",
        f"{ULP_CLASSES[1]} ulp",
        *ULP_CLASSES[2:],
    ]
    head = "".join(f"<th>{escape(name)}</th>" for name in names)
    rows = "".join(map(_row, report.verdicts))
    heading = "<h2>Each stage, given what was drawn before it</h2>"
    return f'{heading}<div class="scroll"><table class="buffers"><tr>{head}</tr>{rows}</table></div>'


def _row(one: Verdict) -> str:
    shares = [f"{count / one.compared:.3%}" if one.compared else "-" for count in (one.equal, one.within)]
    whole = f"{one.chained / one.compared:.3%}" if one.compared and one.chained is not None else "-"
    cells = [one.pass_name, one.stage, one.buffer, str(one.compared), *shares, whole, *map(str, one.ulps[1:])]
    kind = ' class="inherits"' if one.inherits else "" if one.passed else ' class="fail"'
    return f"<tr{kind}>{''.join(f'<td>{escape(cell)}</td>' for cell in cells)}</tr>"


def _worst(found: Finding) -> str:
    if found.section is None:
        return ""
    return f"<h2>The worst pixel, as it should have been</h2>{explained([found.section])}"
