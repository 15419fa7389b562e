"""The JUnit file, read back: a suite a run, a case a buffer, and what a failure says."""

from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import parse

import numpy as np
import pytest

import sss_ref
from sss_ref.cli import main
from sss_ref.errors import DumpError
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.clock import Clock
from sss_ref.validation.report.junit import checked_junit_file, write_junit
from sss_ref.validation.report.report import Report
from sss_ref.validation.scope import FULL, VERDICTS_ALONE
from sss_ref.validation.stage_by_stage import judge

SMALL = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}


@pytest.fixture(scope="module")
def oracle():
    return sss_ref.render(sss_ref.load_scene("figure3_with", **SMALL), "arrays")


def read(report, path):
    """The suite's element, after the file was written."""
    (suite,) = parse(write_junit(report, path, "a <scene>")).getroot()
    return suite


def test_all_right(oracle, tmp_path):
    report = judge(oracle, Drawing(oracle.buffers), None, "vulkan", VERDICTS_ALONE, Clock())
    suite = read(report, tmp_path / "junit.xml")
    assert suite.get("name") == "sss_ref a <scene>"
    assert [suite.get(key) for key in ("tests", "failures", "errors", "skipped")] == [str(len(oracle.buffers)), *"000"]
    cases = [(case.get("classname"), case.get("name")) for case in suite.iter("testcase")]
    assert cases == [(f"{one.pass_name}.{one.stage}", one.buffer) for one in report.verdicts]
    assert ("camera.back_point", "thickness") in cases and suite.find(".//failure") is None
    assert float(suite.get("time")) == pytest.approx(sum(report.seconds.values()), abs=1e-3)


def test_a_failure_says_what_the_terminal_says(oracle, tmp_path):
    """Two stages are wrong: the first with all that is known, the other with its worst pixel; two were not given."""
    buffers = dict(oracle.buffers) | {name: oracle[name] * np.float32(1.5) for name in ("translucency", "scattered")}
    del buffers["thickness"], buffers["albedo"]
    report = judge(oracle, Drawing(buffers, device="a\x01b"), None, "vulkan", FULL, Clock())
    suite = read(report, tmp_path / "junit.xml")
    wrong = {one.buffer: one for one in report.verdicts if not one.passed}
    assert set(wrong) >= {"translucency", "scattered"}
    assert suite.get("failures") == str(len(wrong)) and suite.get("skipped") == "2"
    failures = {
        case.get("name"): case.find("failure") for case in suite.iter("testcase") if case.find("failure") is not None
    }
    assert set(failures) == set(wrong)
    first = failures["translucency"]
    assert first.get("message") == report.summary and report.explanations
    for line in (*report.explanations, *report.details, f"worst {wrong['translucency'].worst}"):
        assert line in first.text.splitlines()
    blurred = wrong["scattered"]
    assert failures["scattered"].get("message") == f"{blurred.failing} of {blurred.compared} pixels are out of reach"
    assert str(blurred.worst) in failures["scattered"].text
    skipped = {case.get("name") for case in suite.iter("testcase") if case.find("skipped") is not None}
    assert skipped == {"thickness", "albedo"}
    values = {each.get("name"): each.get("value") for each in suite.iter("property")}
    assert values == {"profile": "vulkan", "device": "a?b"}


def test_nothing_to_judge_is_an_error(tmp_path):
    suite = read(Report((), ("lit",)), tmp_path / "junit.xml")
    assert (tmp_path / "junit.xml").read_text().startswith("<?xml version='1.0' encoding='utf-8'?>\n<testsuites ")
    assert [suite.get(key) for key in ("tests", "failures", "errors", "skipped")] == ["2", "0", "1", "1"]
    assert suite.find(".//error").get("message") == "empty: no buffer to judge"


def test_a_buffer_without_pixels_to_judge_is_skipped(oracle, tmp_path):
    report = judge(oracle, Drawing(oracle.buffers), None, "vulkan", VERDICTS_ALONE, Clock())
    first, last = report.verdicts[0], replace(report.verdicts[-1], unbounded=report.verdicts[-1].compared)
    report = replace(report, verdicts=(first, last))
    assert report.passed and report.empty == ("image",) and not replace(report, verdicts=(last,)).judged
    suite = read(report, tmp_path / "junit.xml")
    assert [suite.get(key) for key in ("tests", "failures", "errors", "skipped")] == ["2", "0", "0", "1"]
    (case,) = (case for case in suite.iter("testcase") if case.find("skipped") is not None)
    assert (case.get("name"), case.find("skipped").get("message")) == ("image", "no pixel to judge")


def test_a_file_that_cannot_be_written(tmp_path):
    with pytest.raises(DumpError, match=r": expected a file to write, got a folder; name a file in it, such as"):
        checked_junit_file(tmp_path)
    with pytest.raises(DumpError, match=r"x\.xml: expected a file in a folder that is there, got no such folder; make"):
        checked_junit_file(tmp_path / "none" / "x.xml")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no file that is always full")
def test_what_keeps_it_from_being_written_is_told():
    with pytest.raises(DumpError, match=r"^/dev/full: .* can be written, got No space left on device; choose another$"):
        write_junit(Report((), ("lit",)), Path("/dev/full"), "a scene")


def test_on_the_command_line(oracle, tmp_path, capsys):
    folder = oracle.save(tmp_path / "out")
    size = [word for key in SMALL for word in ("--set", f"{key}=32")]
    path = tmp_path / "junit.xml"
    assert main(["validate", "figure3_with", str(folder), *size, "--junit", str(path)]) == 0
    assert parse(path).getroot().get("failures") == "0"
    assert capsys.readouterr().out.endswith(f"{path}\n")
    assert main(["validate", "figure3_with", str(folder), *size, "--junit", str(tmp_path / "no" / "j.xml")]) == 2
    assert capsys.readouterr().err.count("\n") == 1
