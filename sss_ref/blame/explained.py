"""What the explanations of `validate` say of settings and inputs, where the source of a wrong pass is right."""

from collections.abc import Iterator, Mapping, Sequence
from typing import get_origin

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language.pipeline import Pass
from sss_ref.language.types import Texture
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.cause.hypothesis import INPUT, SETTING, SOURCE, Hypothesis
from sss_ref.validation.clock import Clock
from sss_ref.validation.report.report import Report
from sss_ref.validation.scope import VERDICTS_ALONE
from sss_ref.validation.stage_by_stage import judge

LAXER: Mapping[str, Profile] = {
    "4 subpixel bits": Profile(subpixel_bits=4),
    "positions cut off and not rounded": Profile(snap="any"),
    "a depth buffer of 16 bits": Profile(depth_format="D16"),
    "a depth buffer of 24 bits": Profile(depth_format="D24"),
    "a reversed depth buffer": Profile(reversed_depth=True),
}
Told = Iterator[tuple[str, str]]  # SETTING or INPUT, and why


def explained(
    oracle: Result, drawing: Drawing, report: Report, profile: Profile | str, *, compiled_right: bool
) -> Told:
    """Settings and inputs that explain a wrong picture, the most telling first.

    compiled_right: whether the compiler that made it is known to be right. Explanations by another source mean nothing
    then; else the first of all explanations has to be of a setting or an input, and a number one that is not read and
    right elsewhere: a compiler's mistakes look like other numbers too.
    """
    wrong = report.culprit
    assert wrong is not None
    if wrong.background and not wrong.failing:
        yield SETTING, f"in {wrong.buffer}, {wrong.background}"
    hypotheses = report.finding.hypotheses if report.finding else ()
    meant = [each for each in hypotheses if each.blames != SOURCE] if compiled_right else hypotheses[:1]
    for each in meant:
        if each.blames == SETTING or (
            each.blames == INPUT and (compiled_right or not right_elsewhere(oracle.scene, each, report))
        ):
            yield each.blames, each.text
    if wrong.stage == RASTERIZER:
        yield from _laxer(oracle, drawing)
        yield from _blended(oracle.scene.method[wrong.pass_name], report)
    if not hypotheses and reads_asset(oracle.scene.method[wrong.pass_name], wrong.stage, oracle.scene):
        yield INPUT, f"stage {wrong.stage} reads the mesh or a picture, and no mistake in it explains what it gives"


def _laxer(oracle: Result, drawing: Drawing) -> Told:
    """Rasterizers of another kind under which the picture passes."""
    for says, profile in LAXER.items():
        if judge(oracle, drawing, None, profile, VERDICTS_ALONE, Clock()).passed:
            yield SETTING, f"right for a processor with {says}"


def _blended(this_pass: Pass, report: Report) -> Told:
    """A wrong depth of the right triangles, in which a wrong mesh or matrix would show too."""
    wrong = report.culprit
    seen = next((each for each in report.verdicts if each.buffer == this_pass.draw.triangle), None)
    if wrong and wrong.buffer == this_pass.draw.depth and seen is not None and seen.passed:
        yield SETTING, f"{seen.buffer} is right and {wrong.buffer} is no matrix's: the draw may be blended"


def right_elsewhere(scene: Scene, each: Hypothesis, report: Report) -> bool:
    """Whether what would explain a wrong stage is read by others of its pass too, and all of them are right.

    Those of another pass mean nothing: a program has uniforms and bindings of its own.
    """
    wrong = report.culprit
    assert wrong is not None
    readers = {
        stage.name
        for stage in scene.method[wrong.pass_name].stages
        if stage.name != wrong.stage and set(stage.reads.values()) & set(each.names)
    }
    others = [one for one in report.verdicts if one.pass_name == wrong.pass_name and one.stage in readers]
    judged: Sequence[bool] = [one.passed for one in others if not one.empty]
    return bool(judged) and all(judged)


def reads_asset(this_pass: Pass, name: str, scene: Scene) -> bool:
    """Whether a stage, or the rasterizer, reads what comes from a mesh or a picture."""
    if name == RASTERIZER:
        return True
    stage = next(each for each in this_pass.stages if each.name == name)
    kinds = {stage.reads[own]: kind for own, kind in stage.parameters.items()}
    pictures = {read for read, kind in kinds.items() if get_origin(kind) is Texture} - set(scene.method.values)
    return bool(pictures | (set(this_pass.draw.varyings) & set(kinds)))
