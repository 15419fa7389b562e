"""A report as JUnit XML, which systems for continuous integration show: a suite a run, a test case a buffer."""

import re
from pathlib import Path
from xml.etree.ElementTree import Element, ElementTree, SubElement, indent

from sss_ref.errors import DumpError
from sss_ref.errors.whole_file import whole_file
from sss_ref.errors.wording import told
from sss_ref.validation.report.report import Report
from sss_ref.validation.verdict.verdict import Verdict

NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # XML 1.0, production 2


def checked_junit_file(path: Path) -> Path:
    """The path of a file to write, if there can be one. Raises DumpError."""
    if path.is_dir():
        raise DumpError(told(str(path), "a file to write", "a folder", "name a file in it, such as junit.xml"))
    if not path.parent.is_dir():
        raise DumpError(told(str(path), "a file in a folder that is there", "no such folder", "make it"))
    return path


def write_junit(report: Report, path: Path, scene: str) -> Path:
    """Write the file; returns its path. scene: what was drawn, in the suite's name. Raises DumpError."""
    tree = ElementTree(_suites(report, scene))
    indent(tree)
    try:
        with whole_file(checked_junit_file(path)) as hidden:
            tree.write(hidden, encoding="utf-8", xml_declaration=True)
    except OSError as error:
        came = error.strerror or "none"
        raise DumpError(told(str(path), "a file that can be written", came, "choose another")) from None
    return path


def _suites(report: Report, scene: str) -> Element:
    failures, errors = sum(one.failed for one in report.verdicts), int(not report.judged)
    cases, skipped = len(report.verdicts) + len(report.missing) + errors, len(report.missing) + len(report.empty)
    counts = {"tests": str(cases), "failures": str(failures), "errors": str(errors), "skipped": str(skipped)}
    counts["time"] = f"{sum(report.seconds.values()):.3f}"
    root = Element("testsuites", counts)
    suite = SubElement(root, "testsuite", {"name": _plain(f"sss_ref {scene}"), **counts})
    properties = SubElement(suite, "properties")
    for name, value in (("profile", report.profile), ("device", report.device or "not given")):
        SubElement(properties, "property", name=name, value=_plain(value))
    for verdict in report.verdicts:
        _add_verdict(suite, report, verdict)
    for name in report.missing:
        SubElement(_case(suite, "not_given", name), "skipped", message="not given")
    if not report.judged:
        SubElement(_case(suite, "validate", "buffers"), "error", message=_plain(report.summary))
    return root


def _case(suite: Element, group: str, name: str) -> Element:
    return SubElement(suite, "testcase", classname=group, name=name, time="0")


def _add_verdict(suite: Element, report: Report, verdict: Verdict) -> None:
    """A case, named after its pass, stage and buffer; of the first wrong one the failure tells all that is known."""
    case = _case(suite, f"{verdict.pass_name}.{verdict.stage}", verdict.buffer)
    if verdict.empty:
        SubElement(case, "skipped", message="no pixel to judge")
    if not verdict.failed:
        return
    if verdict is report.culprit:
        sentence, more = report.summary, [*report.explanations, *report.details]
    else:
        sentence, more = f"{verdict.failing} of {verdict.compared} pixels are out of reach", []
    worst = [f"worst {verdict.worst}"] if verdict.worst else []
    failure = SubElement(case, "failure", message=_plain(sentence), type=verdict.stage)
    failure.text = _plain("\n".join([sentence, *more, *worst]))


def _plain(text: str) -> str:
    """A text without the characters that XML cannot hold, which a mapping file's device may have."""
    return NO_XML.sub("?", text)
