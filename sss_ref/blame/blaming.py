"""Whose fault it is that a picture is wrong: what was found out, held together.

1. The shader's source, drawn by stacks that draw ours right, from what was drawn before it: wrong there as well, it is
   the source's fault. Wrong on some of them alone, it is a compiler's.
2. Else the source is right, and the explanations of `validate` tell more: a state of the draw or a format, or a laxer
   profile that what was drawn passes under, is a setting; other numbers, matrices or meshes are inputs.
3. What nothing of that explains, from a right source and right inputs, is the fault of translator or compiler.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import get_origin

from sss_ref.blame.evidence import Bench, OtherDrawing
from sss_ref.blame.stacks import Stack
from sss_ref.gl.shaders import Files
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language.pipeline import Pass
from sss_ref.language.types import Texture
from sss_ref.rendering.fold import render
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.cause.hypothesis import FITTED, NUMBER, STAGE, STATE, Hypothesis
from sss_ref.validation.clock import Clock
from sss_ref.validation.report.report import Report
from sss_ref.validation.scope import SECONDS, VERDICTS_ALONE, Scope
from sss_ref.validation.stage_by_stage import judge
from sss_ref.validation.verdict.verdict import Verdict

NOBODY, SHADER, COMPILER, SETTING, INPUT = "nobody", "shader", "translator or compiler", "setting", "input"
UNKNOWN = "shader or compiler"  # without the source
LAXER: Mapping[str, Profile] = {
    "4 subpixel bits": Profile(subpixel_bits=4),
    "positions cut off and not rounded": Profile(snap="any"),
    "a depth buffer of 16 bits": Profile(depth_format="D16"),
    "a depth buffer of 24 bits": Profile(depth_format="D24"),
    "a reversed depth buffer": Profile(reversed_depth=True),
}

ANOTHER_STAGE = "it computes "  # how `validate` tells that a stage gives what another one does
FRACTION = re.compile(r"\d\.(?!5 )\d+ pixels too far")  # a picture that lies off so is no viewport's, but a matrix's


@dataclass(frozen=True)
class Blame:
    """The outcome.

    whose: NOBODY, SHADER, COMPILER, SETTING, INPUT or UNKNOWN. because: why, in sentences.
    report: the verdicts.
    """

    whose: str
    because: tuple[str, ...]
    report: Report

    def __str__(self) -> str:
        """In a line."""
        return f"{self.whose}: {'; '.join(self.because)}"


@dataclass(frozen=True)
class Suspicion:
    """A wrong picture, and whose fault it may be.

    shaders: pass -> the files that it was drawn with, as `sss_ref.gl.draw` takes them; none where they are not known.
    stacks: on which they are drawn again. here: whether it was drawn on one of these.
    """

    scene: Scene
    drawing: Drawing
    shaders: Mapping[str, Files]
    stacks: Sequence[Stack]
    profile: Profile | str = "vulkan"
    seconds: float = SECONDS
    here: bool = False

    def blame(self) -> Blame:
        """Whose fault it is. Raises SceneError as `validate` does, and ShaderError where a shader does not compile."""
        oracle = render(self.scene)
        scope = Scope(seconds=self.seconds, power=False)
        report = judge(oracle, self.drawing, None, self.profile, scope, Clock())
        wrong = report.culprit
        if wrong is None:
            return Blame(NOBODY, (report.summary,), report)
        this_pass = self.scene.method[wrong.pass_name]
        others = self._others(Bench(oracle, self.drawing, this_pass, self.profile))
        whose, because = self._found(oracle, report, wrong, others)
        untried = report.finding.not_tried if report.finding else ""
        told = (report.summary, *map(str, others), because, untried)
        return Blame(whose, tuple(filter(None, told)), report)

    def _others(self, bench: Bench) -> list[OtherDrawing]:
        """The source of the wrong pass on other stacks."""
        return bench.others(self.stacks, self.shaders) if bench.this_pass.name in self.shaders else []

    def _found(self, oracle: Result, report: Report, wrong: Verdict, others: Sequence[OtherDrawing]) -> tuple[str, str]:
        """Whose fault, and why."""
        apart = {bool(each.wrong) for each in others}
        if apart == {True}:
            return SHADER, f"the source of pass {wrong.pass_name} gives something else wherever it is drawn"
        if apart == {True, False}:
            return COMPILER, "the same source comes out otherwise on one stack than on another"
        for whose, because in (*self._settings(oracle, report, wrong), *self._inputs(report, wrong)):
            return whose, because
        if not others and self.here:
            return COMPILER, "our own shaders come out wrong here as well"
        if not others:
            return UNKNOWN, f"the source of pass {wrong.pass_name} was not drawn again"
        return COMPILER, f"the source is right, and no setting or input explains what stage {wrong.stage} gives"

    def _settings(self, oracle: Result, report: Report, wrong: Verdict) -> Iterator[tuple[str, str]]:
        """A state of the draw, a format, a clear value, or a rasterizer of another kind."""
        if wrong.background and not wrong.failing:
            yield SETTING, f"in {wrong.buffer}, {wrong.background}"
        for each in _explanations(report)[:1]:
            if each.rank == STATE or (each.rank == NUMBER and not self._named(each.text)):
                yield INPUT if self._is_of_a_matrix(each.text) else SETTING, each.text
        if wrong.stage == RASTERIZER:
            for says, profile in LAXER.items():
                if judge(oracle, self.drawing, None, profile, VERDICTS_ALONE, Clock()).passed:
                    yield SETTING, f"right for a processor with {says}"

    def _is_of_a_matrix(self, text: str) -> bool:
        """Whether a state of the draw, in words, is one that a matrix gives it: a jitter, or other planes."""
        return FRACTION.search(text) is not None or self._named(text.partition(" ")[0])

    def _named(self, text: str) -> bool:
        """Whether words name a uniform; a viewport's size, a number too, is none."""
        return not self.scene.uniforms.keys().isdisjoint(text.split())

    def _is_given(self, each: Hypothesis, report: Report, wrong: Verdict) -> bool:
        """Whether an explanation is of what a stage was given: a number that nobody else has right, or a kernel.

        What a right source draws as another reading of the paper would is given another kernel, or other constants.
        """
        numbers = each.rank in (NUMBER, FITTED)
        other_reading = each.rank == STAGE and not each.text.startswith(ANOTHER_STAGE)
        return other_reading or (numbers and not right_elsewhere(self.scene, each.text, report, wrong))

    def _inputs(self, report: Report, wrong: Verdict) -> Iterator[tuple[str, str]]:
        """Other numbers, and where nothing explains it other meshes and pictures."""
        found, this_pass = _explanations(report), self.scene.method[wrong.pass_name]
        for each in found[:1]:
            if self._is_given(each, report, wrong):
                yield INPUT, each.text
        if not found and reads_asset(self.scene, this_pass, wrong.stage):
            yield INPUT, f"stage {wrong.stage} reads the mesh or a picture, and no mistake in it explains what it gives"


def _explanations(report: Report) -> Sequence[Hypothesis]:
    return report.finding.hypotheses if report.finding else ()


def right_elsewhere(scene: Scene, text: str, report: Report, wrong: Verdict) -> bool:
    """Whether a number that would explain a wrong stage is read by others too, and all of them are right."""
    read = {
        (each.name, stage.name)
        for each in scene.method.passes
        for stage in each.stages
        if stage.name != wrong.stage and set(stage.reads.values()) & set(text.split())
    }
    others = [each for each in report.verdicts if (each.pass_name, each.stage) in read and not each.empty]
    return bool(others) and all(each.passed for each in others)


def reads_asset(scene: Scene, this_pass: Pass, name: str) -> bool:
    """Whether a stage, or the rasterizer, reads what comes from a mesh or a picture."""
    if name == RASTERIZER:
        return True
    stage = next(each for each in this_pass.stages if each.name == name)
    kinds = {stage.reads[own]: kind for own, kind in stage.parameters.items()}
    pictures = {read for read, kind in kinds.items() if get_origin(kind) is Texture} - set(scene.method.values)
    return bool(pictures | (set(this_pass.draw.varyings) & set(kinds)))
