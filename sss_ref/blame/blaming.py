"""Whose fault it is that a picture is wrong: what was found out, held together.

What is known of the source comes first, as stacks draw it (`evidence`), and decides between shader and compiler. Where
all of them draw it right, the explanations of `validate` tell settings from inputs (`explained`); that the stack which
drew the picture is one of them rules its compiler out. docs/how_to/validate.md has the table that this follows.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sss_ref.blame.evidence import Bench, OtherDrawing
from sss_ref.blame.explained import explained
from sss_ref.blame.stacks import Stack
from sss_ref.gl.shaders import Files
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.rendering.fold import render
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause import hypothesis
from sss_ref.validation.clock import Clock
from sss_ref.validation.report.report import Report
from sss_ref.validation.scope import SECONDS, VERDICTS_ALONE, Scope
from sss_ref.validation.stage_by_stage import judge
from sss_ref.validation.verdict.verdict import Verdict

NOBODY, SHADER, COMPILER = "nobody", "shader", "translator or compiler"
SETTING, INPUT = hypothesis.SETTING, hypothesis.INPUT
UNKNOWN = "shader or compiler"  # without the source


@dataclass(frozen=True)
class Blame:
    """The outcome.

    whose: NOBODY, SHADER, COMPILER, SETTING, INPUT or UNKNOWN. because: why, in sentences.
    report: the verdicts; with explanations where the source does not tell.
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

    drawing: whose `device` has words of the name of that of the stacks which drew it, if one did.
    shaders: pass -> the files that it was drawn with, as `sss_ref.gl.draw` takes them; none where they are not known.
    stacks: on which they are drawn again. ours: whether our own shaders drew the passes without files.
    """

    scene: Scene
    drawing: Drawing
    shaders: Mapping[str, Files]
    stacks: Sequence[Stack]
    profile: Profile | str = "vulkan"
    seconds: float = SECONDS
    ours: bool = False

    def blame(self) -> Blame:
        """Whose fault it is. Raises SceneError as `validate` does, and ShaderError where a shader does not compile."""
        oracle = render(self.scene)
        report = self._judged(oracle, VERDICTS_ALONE)
        wrong = report.culprit
        if wrong is None:
            return Blame(NOBODY, (report.summary,), report)
        others = self._others(Bench(oracle, self.drawing, self.scene.method[wrong.pass_name], self.profile))
        found = _by_source(wrong, others)
        if found is None:
            report = self._judged(oracle, Scope(seconds=self.seconds, power=False))
            found = self._by_explanation(oracle, report, others)
        whose, because = found
        untried = report.finding.not_tried if report.finding else ""
        told = (report.summary, *map(str, others), because, untried)
        return Blame(whose, tuple(filter(None, told)), report)

    def _judged(self, oracle: Result, scope: Scope) -> Report:
        return judge(oracle, self.drawing, None, self.profile, scope, Clock())

    def _others(self, bench: Bench) -> list[OtherDrawing]:
        """The source of the wrong pass on the stacks."""
        is_known = self.ours or bench.this_pass.name in self.shaders
        return bench.others(self.stacks, self.shaders) if is_known else []

    def _by_explanation(self, oracle: Result, report: Report, others: Sequence[OtherDrawing]) -> tuple[str, str]:
        """Whose fault it is where no stack draws the source wrong, and why."""
        wrong = report.culprit
        assert wrong is not None
        drew = next((each.stack for each in others if each.drew), None)
        for whose, because in explained(oracle, self.drawing, report, self.profile, compiled_right=drew is not None):
            return whose, because
        if drew is not None:
            return INPUT, f"{drew} draws the source right from what is right, so something else was given"
        if not others:
            return UNKNOWN, f"the source of pass {wrong.pass_name} was not drawn again"
        return COMPILER, f"the source is right, and no setting or input explains what stage {wrong.stage} gives"


def _by_source(wrong: Verdict, others: Sequence[OtherDrawing]) -> tuple[str, str] | None:
    """Whose fault it is by the source alone, and why; None where every stack draws it right, or none does it."""
    apart = {bool(each.wrong) for each in others if not each.ours}
    if apart == {True}:
        return SHADER, f"the source of pass {wrong.pass_name} gives something else wherever it is drawn"
    if apart == {True, False}:
        return COMPILER, "the same source comes out otherwise on one stack than on another"
    for each in others:
        if each.wrong:
            return COMPILER, f"our own shaders come out wrong on {each.stack} as well, which drew it"
    return None
