"""A report as plain data, for programs: what docs/how_to/validate.md describes as report.json."""

import math
from dataclasses import asdict
from typing import Any

from sss_ref.explanation.rows import Row
from sss_ref.explanation.values import shown
from sss_ref.results.diff import ULP_CLASSES
from sss_ref.validation.report.report import Report
from sss_ref.validation.verdict.outcomes import OUTCOMES
from sss_ref.validation.verdict.verdict import Verdict, WrongPixel
from sss_ref.validation.verdict.widths import WIDTH_CLASSES


def as_json(report: Report) -> dict[str, Any]:
    """The report as dictionaries, lists, texts and numbers; what JSON has no number for (infinity) is null."""
    section = report.finding.section if report.finding else None
    return {
        "passed": report.passed,
        "empty": list(report.empty),
        "summary": report.summary,
        "profile": report.profile,
        "device": report.device,
        "only": report.only,
        "details": report.details,
        "explanations": [asdict(each) for each in (report.finding.hypotheses if report.finding else ())],
        "not_tried": report.finding.not_tried if report.finding else "",
        "missing": list(report.missing),
        "outcomes": list(OUTCOMES),
        "ulp_classes": list(ULP_CLASSES),
        "width_classes": list(WIDTH_CLASSES),
        "buffers": [_buffer(verdict) for verdict in report.verdicts],
        "worst_lines": [_line(row) for row in (section.rows if section else ())],
        "power": [asdict(each) for each in report.power],
        "likeness": [asdict(each) for each in report.likeness],
        "seconds": {name: round(seconds, 3) for name, seconds in report.seconds.items()},
    }


def _buffer(verdict: Verdict) -> dict[str, Any]:
    return {
        "pass": verdict.pass_name,
        "stage": verdict.stage,
        "buffer": verdict.buffer,
        "passed": verdict.passed,
        "empty": verdict.empty,
        "inherits": verdict.inherits,
        "pixels": verdict.compared,
        "same_bits": verdict.equal,
        "within_chained": verdict.chained,
        "outcomes": list(verdict.outcomes),
        "bounded": verdict.bounded,
        "ulps": list(verdict.ulps),
        "widths": list(verdict.widths.counts),
        "width_of_95_percent": _finite(verdict.widths.most),
        "share_let_pass": verdict.passing,
        "narrowing": list(verdict.narrowing),
        "first": _pixel(verdict.first),
        "worst": _pixel(verdict.worst),
        "clusters": asdict(verdict.clusters) if verdict.clusters else None,
        "suspects": list(verdict.suspects),
        "background": asdict(verdict.background) if verdict.background else None,
    }


def _pixel(pixel: WrongPixel | None) -> dict[str, Any] | None:
    if pixel is None:
        return None
    return asdict(pixel) | {"ulps": _finite(pixel.ulps), "widths": _finite(pixel.widths)}


def _line(row: Row) -> dict[str, str | None]:
    low, high = map(shown, row.bounds) if row.bounds else (None, None)
    return {"text": row.text, "value": row.value, "low": low, "high": high}


def _finite(number: float) -> float | None:
    return number if math.isfinite(number) else None
