"""What `sss-ref witness` prints and its exit code; witnesses have tests of their own."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.cli import main
from sss_ref.language import vec3
from sss_ref.validation.witness.witness import DrawnValue


def found(outcome="fail", kind=vec3, reach=0.5, device="a [bold] device", **changes):
    """A witness as far as it is printed: 2 was drawn, 1 would be right."""
    count = 3 if kind is vec3 else 1
    got, expected, low, high = (np.full(count, value, np.float32) for value in (2.0, 1.0, 1.0 - reach, 1.0 + reach))
    drawn = DrawnValue("camera", "lit", (7, 5), device=device)
    situation = SimpleNamespace(stage=SimpleNamespace(name="phong"))
    numbers = {
        "got": got,
        "expected": expected,
        "allowed": (low, high),
        "reach": np.array([0.0] * (count - 1) + [reach]),
    }
    return SimpleNamespace(situation=situation, drawn=drawn, kind=kind, outcome=outcome, **{**numbers, **changes})


@pytest.fixture
def told(monkeypatch, capsys):
    """Runs the command on a witness; exit code and lines."""

    def run(witness, *words, other=""):
        monkeypatch.setattr(
            "sss_ref.validation.witness.witness_record.read_record", lambda file: SimpleNamespace(why=("since [1]",))
        )
        monkeypatch.setattr("sss_ref.validation.witness.recalling.recalled", lambda record, where: witness)
        standing = SimpleNamespace(of=lambda record, stage: SimpleNamespace(other=other))
        monkeypatch.setattr("sss_ref.validation.witness.recalling.Standing", standing)
        for language in ("", "_wgsl"):
            module = f"sss_ref.validation.witness.stand_alone{language}"
            monkeypatch.setattr(f"{module}.write_stand_alone{language}", lambda found, path: path)
            monkeypatch.setattr(f"{module}.stand_alone{language}", lambda found, language=language: f"text{language}")
        monkeypatch.setattr("sss_ref.gl.stand_alone_run.run_alone", lambda text: ran(text, True))
        monkeypatch.setattr("sss_ref.webgpu.witness_run.run_wgsl_alone", lambda text: ran(text, False))
        return main(["witness", "file", *words]), capsys.readouterr().out.splitlines()

    def ran(text, right):
        return SimpleNamespace(device=f"[red] runs {text}", right=right)

    return run


STAGE = "stage phong of pass camera, pixel 7,5 of lit"


def test_a_wrong_pixel(told):
    assert told(found()) == (
        1,
        [
            STAGE,
            "drawn by a [bold] device: (2, 2, 2)",
            "the reference has (1, 1, 1); right is ([0.5, 1.5], [0.5, 1.5], [0.5, 1.5])",
            "  since [1]",
            "wrong: lit is out of reach",
        ],
    )


@pytest.mark.parametrize("outcome", ["certain", "ambiguous", "undefined", "unbounded"])
def test_a_right_one(outcome, told):
    code, lines = told(found(outcome, float, reach=0.0, device=None))
    assert (code, lines[1:3]) == (
        0,
        ["drawn by a device that is not given: 2", "the reference has 1; nothing else is right"],
    )
    assert lines[-1] == "right: lit is in reach"


def test_only_what_has_no_reach_at_all_is_exact(told):
    """One component of three has some; and one may reach as far as 1."""
    assert "right is" in told(found(reach=0.25))[1][2]
    assert "right is [0, 2]" in told(found(kind=float, reach=1.0))[1][2]


@pytest.mark.parametrize(("outcome", "word"), [("fail", "wrong"), ("certain", "right")])
def test_a_stage_that_is_another_decides_nothing(outcome, word, told):
    code, lines = told(found(outcome), other="the [rules] are others")
    assert code == 2
    assert lines[-1] == f"other: the [rules] are others; by the stage here it is {word}"


def test_shaders_are_written_and_run(told):
    written = ["--glsl", "a[bold].frag", "--wgsl", "b[bold].wgsl"]
    assert told(found(), *written, "--run-glsl", "--run-wgsl")[1][4:-1] == [
        "a[bold].frag: green where the stage is right",
        "b[bold].wgsl: green where the stage is right",
        "[red] runs text: the stage is right here",
        "[red] runs text_wgsl: the stage is wrong here",
    ]
    assert told(found(), "--glsl", str(Path("x")))[1][4:-1] == ["x: green where the stage is right"]
    assert told(found(), "--run-wgsl")[1][4:-1] == ["[red] runs text_wgsl: the stage is wrong here"]
    assert told(found(), "--run-glsl")[1][4:-1] == ["[red] runs text: the stage is right here"]
