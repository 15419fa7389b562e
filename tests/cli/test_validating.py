"""What `sss-ref validate` judges, writes and prints, and its exit code; nothing is drawn or judged here."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.cli import main, validating
from sss_ref.validation.scope import FULL, QUICK


def report(**changes):
    """What came out, as far as the command asks."""
    whole = {"judged": True, "passed": True, "finding": None, "nothing": "no pixel at all"}
    return SimpleNamespace(**{**whole, **changes})


class Validated:
    """Runs the command with the rooms below replaced by what tells how it was called."""

    def __init__(self, monkeypatch):
        self.seen, self.came = {}, report()
        settings = SimpleNamespace(camera=SimpleNamespace(width=4, height=3))
        rooms = {
            "scene.load.load_scene": lambda name: SimpleNamespace(settings=settings),
            "rendering.fold.render": lambda scene, interpreter, threads, on_pass: "oracle",
            "validation.stage_by_stage.judge": self.judge,
            "validation.report.metrics.require_packages": lambda: None,
            "validation.report.metrics.likeness": lambda oracle, buffers: ["alike"],
            "validation.report.report_page.write_report": lambda found, folder, title: f"{folder}/[{title}]",
            "validation.report.junit.checked_junit_file": lambda path: None,
            "validation.report.junit.write_junit": lambda found, path, scene: f"{path} of {scene}",
            "validation.witness.recording.recorded": lambda witness: witness,
            "validation.witness.witness_record.write_record": lambda record, path: path,
            "dump.read.read_dump": self.read_dump,
            "capture.recognized.recognized": self.recognized,
            "gl.draw": self.drawn_by("gl"),
            "gl.device_name": lambda: "GL",
            "webgpu.draw": self.drawn_by("webgpu"),
            "webgpu.adapter_name": lambda: "GPU",
            "cache.compiled.is_cold": lambda: False,
        }
        for name, stand_in in rooms.items():
            monkeypatch.setattr(f"sss_ref.{name}", stand_in)
        monkeypatch.setattr(
            validating, "replace", lambda found, likeness: SimpleNamespace(**vars(found), said=likeness)
        )
        monkeypatch.setattr(validating, "print_report", lambda found: self.seen.update(printed=found))
        monkeypatch.setattr(validating, "shaders_of", lambda folder, settings: folder)
        self.read = SimpleNamespace(read=lambda dump: SimpleNamespace(what=dump.what, device=None, buffers={}))
        self.drawn = lambda buffers, device: SimpleNamespace(what=buffers, device=device, buffers={})
        self.monkeypatch = monkeypatch

    def __call__(self, *words, came=None):
        self.seen.clear()
        self.came = came or report()
        kind = self.drawn if {"--run-glsl", "--run-wgsl"} & {*words} else self.read
        self.monkeypatch.setattr("sss_ref.validation.accept.dumped.Drawing", kind)
        return main(["validate", "wedge", *words])

    def judge(self, oracle, drawing, only, profile, scope, clock):
        self.seen.update(what=drawing.what, device=drawing.device, only=only, profile=profile, scope=scope)
        self.seen["phases"] = list(clock.seconds)
        return self.came

    def read_dump(self, path, scene, origin):
        one = SimpleNamespace(name="lit", notes=["[bold] bytes"])
        return SimpleNamespace(what=("read", path, origin), notes=["all"], buffers={"lit": one})

    def recognized(self, path, oracle, extracted):
        dump = SimpleNamespace(what=("recognized", path, extracted is not None), notes=(), buffers={})
        return SimpleNamespace(doubts=lambda: ["is it?"], dump=lambda: dump)

    def drawn_by(self, whose):
        return lambda scene, shaders, keep: (whose, shaders)


@pytest.fixture
def validated(monkeypatch):
    return Validated(monkeypatch)


DUMP = Path("dump")


@pytest.mark.parametrize(
    ("words", "what", "device", "profile"),
    [
        (["dump"], ("read", DUMP, None), None, "vulkan"),
        (["dump", "--origin", "top", "--profile", "gl"], ("read", DUMP, "top"), None, "gl"),
        (["dump", "--auto"], ("recognized", DUMP, False), None, "vulkan"),
        (["a.rdc"], ("recognized", Path("a.rdc"), True), None, "vulkan"),
        (["a.rdc", "--auto"], ("recognized", Path("a.rdc"), True), None, "vulkan"),
        (["--run-glsl"], ("gl", None), "GL", "vulkan"),
        (["dump", "--run-glsl"], ("gl", DUMP), "GL", "vulkan"),
        (["a.rdc", "--run-glsl"], ("gl", Path("a.rdc")), "GL", "vulkan"),
        (["--run-wgsl"], ("webgpu", None), "GPU", "wgsl"),
        (["dump", "--run-wgsl", "--profile", "ieee"], ("webgpu", DUMP), "GPU", "ieee"),
    ],
)
def test_what_is_judged_and_by_which_profile(words, what, device, profile, validated):
    assert validated(*words) == 0
    seen = validated.seen
    assert (seen["what"], seen["device"], seen["profile"]) == (what, device, profile)
    assert seen["only"] is None
    assert ("recognising" in seen["phases"]) == (what[0] == "recognized")


@pytest.mark.parametrize(
    ("words", "power"),
    [([], False), (["--report", "r"], True), (["--report", "r", "--quick"], False), (["--power"], True)],
)
def test_how_small_an_error_would_be_seen_is_for_a_report(words, power, validated):
    assert validated("dump", "--only", "phong", *words) == 0
    scope, usual = validated.seen["scope"], QUICK if "--quick" in words else FULL
    assert (scope.stage, scope.power, scope.seconds) == ("phong", power, usual.seconds)


@pytest.mark.parametrize(("passed", "code"), [(True, 0), (False, 1)])
def test_the_exit_code_is_that_of_the_verdict(passed, code, validated):
    came = report(passed=passed)
    assert validated("dump", came=came) == code
    assert validated.seen["printed"] is came


@pytest.mark.parametrize(("words", "where"), [(["dump[1]"], "dump[1]"), (["--run-glsl"], "--run-glsl")])
def test_what_judges_nothing_is_an_error_and_no_report(words, where, validated, capsys):
    assert validated(*words, came=report(judged=False, passed=False)) == 2
    line = f"error: {where}: expected a buffer with pixels to judge, got no pixel at all; give other"
    assert line in capsys.readouterr().err and "printed" not in validated.seen


def test_files_are_told_as_they_are_named(validated, capsys):
    assert validated("dump", "--report", "r[1]", "--junit", "j[bold].xml", "--metrics") == 0
    assert capsys.readouterr().out == "r[1]/[wedge: is it right?]\nj[bold].xml of wedge\n"
    assert validated.seen["printed"].said == ("alike",)


@pytest.mark.parametrize(
    ("finding", "line"),
    [
        (None, "w[b] not written: no stage is wrong"),
        (
            SimpleNamespace(witness=None),
            "w[b] not written: only a pixel that a stage computes can be cut down to it",
        ),
        (SimpleNamespace(witness="pixel"), "w[b]: judge it with sss-ref witness"),
    ],
)
def test_a_witness_is_written_where_there_is_one(finding, line, validated, capsys):
    validated("dump", "--witness", "w[b]", came=report(finding=finding))
    assert capsys.readouterr().out == f"{line}\n"


def test_notes_on_a_dump_come_before_the_verdict(validated, capsys):
    validated("dump")
    assert capsys.readouterr().err == "note: all\nnote: lit: [bold] bytes\n"
    validated("dump", "--auto")
    assert capsys.readouterr().err == "note: is it?\n"


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ([], "validate: expected a folder of buffers, a mapping file, --run-glsl or --run-wgsl, got none; give one"),
        (["--auto"], "validate: expected a folder of buffers, a mapping file, --run-glsl or --run-wgsl, got none"),
        (["--run-glsl", "--run-wgsl"], "validate: expected one of --run-glsl and --run-wgsl, got both; give one"),
    ],
)
def test_something_is_to_be_judged(words, line, validated, capsys):
    assert validated(*words) == 2
    assert line in " ".join(capsys.readouterr().err.split())


REGION = np.array([[0, 0, 0, 0], [0, 1, 1, 0], [0, 1, 1, 0]], bool)  # X,Y,W,H = 1,1,2,2
MASK = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]], bool)


@pytest.mark.parametrize(
    ("words", "only"),
    [
        (["--region", "1,1,2,2"], REGION),
        (["--exclude", "{mask}"], ~MASK),
        (["--region", "1,1,2,2", "--exclude", "{mask}"], REGION & ~MASK),
    ],
)
def test_some_pixels_are_judged_alone(words, only, validated, tmp_path):
    np.save(tmp_path / "mask.npy", MASK)
    assert validated("dump", *(word.format(mask=tmp_path / "mask.npy") for word in words)) == 0
    np.testing.assert_array_equal(validated.seen["only"], only)
    assert validated.seen["only"].dtype == bool
