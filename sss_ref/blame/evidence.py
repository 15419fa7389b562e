"""How the shaders of a wrong pass come out on stacks, beside our own."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from sss_ref.blame.stacks import Stack, language_of
from sss_ref.gl.shaders import Files
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language.pipeline import Pass
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.scope import VERDICTS_ALONE
from sss_ref.validation.stage_by_stage import validate

OURS: Mapping[str, Files] = {}


@dataclass(frozen=True)
class OtherDrawing:
    """How the shaders of a pass came out on a stack.

    wrong: the first of its stages that is out of reach, or "". ours: whether our own shaders come out wrong there too.
    drew: whether it is the stack that drew what is judged.
    """

    stack: str
    wrong: str
    ours: bool = False
    drew: bool = False

    def __str__(self) -> str:
        """As part of a sentence."""
        return f"{self.wrong} is wrong on {self.stack}" if self.wrong else f"right on {self.stack}"


@dataclass(frozen=True)
class Bench:
    """A pass that is to be drawn by others, reading what was drawn before it.

    oracle: the rendering of the scene. drawing: what was drawn. profile: of the processors, as `validate` takes it.
    """

    oracle: Result
    drawing: Drawing
    this_pass: Pass
    profile: Profile | str

    def others(self, stacks: Iterable[Stack], shaders: Mapping[str, Files]) -> list[OtherDrawing]:
        """How these shaders come out on all stacks that take them and draw our own right, and on the one that drew."""
        language = language_of(shaders)
        tried = (self._tried(each, shaders) for each in stacks if each.language == language)
        return [each for each in tried if each.drew or not each.ours]

    def _tried(self, stack: Stack, shaders: Mapping[str, Files]) -> OtherDrawing:
        drew = bool(self.drawing.device) and str(self.drawing.device).lower() in stack.name.lower()
        ours = bool(self.wrong_on(stack, OURS))
        return OtherDrawing(stack.name, self.wrong_on(stack, shaders), ours, drew)

    def wrong_on(self, stack: Stack, shaders: Mapping[str, Files]) -> str:
        """The first stage of the pass that these shaders get wrong on a stack, or ""."""
        scene, name = self.oracle.scene, self.this_pass.name
        read = {each: self._read(each) for each in self.this_pass.needs if each in scene.method.outputs}
        own = {name: shaders[name]} if name in shaders else OURS
        written = stack.draw(scene, self.this_pass, read, own)
        profile = stack.profile or self.profile
        report = validate(self.oracle, {**read, **written}, profile=profile, explain=VERDICTS_ALONE)
        return next((each.stage for each in report.verdicts if each.failed and each.buffer in written), "")

    def _read(self, name: str) -> np.ndarray:
        """What stands in a buffer that the pass reads: what was drawn, else the reference's."""
        return self.drawing.buffers.get(name, self.oracle[name])
