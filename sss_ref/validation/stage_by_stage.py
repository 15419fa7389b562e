"""The question itself: is this what a right implementation draws, and if not, where does it go wrong."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import chain
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from sss_ref.dump.read import read_dump
from sss_ref.errors import SceneError
from sss_ref.errors.wording import nearest, told
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.methods.stages import all_stages
from sss_ref.raster.viewport import FINEST
from sss_ref.rendering.fold import render
from sss_ref.rendering.result import Result
from sss_ref.scene.load import load_scene
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.chained import within_bounds
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.dumped import Buffers, Drawing, Stored
from sss_ref.validation.accept.rebased import RASTERIZER, Check, checks, last_round
from sss_ref.validation.accept.sparing import SAMPLE, Sparing
from sss_ref.validation.accept.walk import run_stage
from sss_ref.validation.clock import Clock, Limit
from sss_ref.validation.profile_file import profile_of
from sss_ref.validation.report.report import Finding, Report
from sss_ref.validation.scope import FULL, VERDICTS_ALONE, Scope
from sss_ref.validation.verdict.clusters import Whereabouts
from sss_ref.validation.verdict.suspects import narrowing, suspects
from sss_ref.validation.verdict.verdict import Verdict, judged

if TYPE_CHECKING:
    from sss_ref.explanation.rows import Section
    from sss_ref.validation.cause.power import Power
    from sss_ref.validation.witness.witness import Witness

DEFAULT_PROFILE = "vulkan"


def validate(
    scene: Scene | Result | str | PathLike[str],
    buffers: Buffers | str | PathLike[str],
    stored: Stored | None = None,
    only: np.ndarray | None = None,
    profile: Profile | str = DEFAULT_PROFILE,
    explain: bool | Scope = True,
) -> Report:
    """Hold the buffers of another implementation against the stages, one stage at a time.

    scene: what was drawn, as a scene, a bundle or what else `load_scene` takes, or its rendering with all buffers.
    buffers: a folder or mapping file that `read_dump` reads, or name -> array as in `Result`, (H, W) or (H, W, C), row
    0 at the bottom, float32, int32 or uint8; any of the method's, registers and taps too. The more there are, the
    nearer the culprit.
    stored: buffer -> what its texture holds where that is less than float32: "float16", "unorm8", "unorm16", "srgb8";
    of a buffer that was not dumped too, and of a picture among the uniforms (`albedo_map`).
    only: bool (H, W) of the camera's size, the pixels of its buffers that are judged.
    profile: the processor that may have drawn them, by name ("ieee", "vulkan", "wgsl", "gl", "mediump"), as a TOML
    file or as a Profile; accepted is what it may give. explain: whether to look for what would explain a failure, and
    for how small an error would have been seen; or a `Scope`, which may also choose a single stage.
    Raises SceneError where a buffer is not one of the scene, or not of its type and size, and for an unknown stage, and
    DumpError as `read_dump` does.
    """
    clock = Clock()
    with clock.phase("rendering"):
        oracle = _oracle(scene)
    scope = explain if isinstance(explain, Scope) else FULL if explain else VERDICTS_ALONE
    return judge(oracle, _drawing(oracle.scene, buffers, stored or {}), only, profile, scope, clock)


def _oracle(scene: Scene | Result | str | PathLike[str]) -> Result:
    """The rendering itself, or that of a scene."""
    if isinstance(scene, Result):
        return scene
    return render(scene if isinstance(scene, Scene) else load_scene(scene))


def _drawing(scene: Scene, buffers: Buffers | str | PathLike[str], stored: Stored) -> Drawing:
    """What was drawn; storages that the caller gives come before those of the files."""
    if isinstance(buffers, Mapping):
        return Drawing(buffers, stored)
    found = Drawing.read(read_dump(Path(buffers), scene))
    return replace(found, stored={**found.stored, **stored})


def judge(
    oracle: Result,
    drawing: Drawing,
    only: np.ndarray | None,
    profile: Profile | str,
    scope: Scope,
    clock: Clock,
) -> Report:
    """As `validate`, of what is known of a drawing, with the time it takes. Raises SceneError as it does."""
    _check_buffers(oracle, drawing.buffers)
    _check_something_is_drawn(oracle, only)
    _check_stage(oracle, scope)
    kind = profile_of(profile) if isinstance(profile, str) else profile
    oracle = _snapped_alike(oracle, kind)
    case = Case(oracle, _near_to_far(oracle, drawing.coarse) if kind.reversed_depth else drawing.coarse, kind)
    verdicts, finding, compared = [], None, {}
    for check, verdict in _verdicts(case, only, scope.stage, clock):
        verdicts.append(verdict)
        compared[check.buffer] = check
        if scope.causes and finding is None and verdict.failed:
            with clock.phase("hypotheses"):
                finding = _finding(case, check, verdict, scope.seconds)
    with clock.phase("chained"):
        within = within_bounds(case, compared.values())
    missing = tuple(name for name in oracle.scene.method.outputs if name not in drawing.buffers)
    with clock.phase("power"):
        where = {name: check.where for name, check in compared.items()}
        sight = _sight(case, where) if scope.power else ()
    name = profile if isinstance(profile, str) else "a profile of its own"
    whole = tuple(replace(each, chained=within[each.buffer]) for each in verdicts)
    return Report(whole, missing, finding, sight, (), name, drawing.device, clock.seconds, scope.stage)


def _verdicts(case: Case, only: np.ndarray | None, stage: str | None, clock: Clock) -> Iterator[tuple[Check, Verdict]]:
    """Every buffer in stage order, or those of one stage, judged on the chosen pixels."""
    buffers, method = case.drawing.buffers, case.oracle.scene.method
    whereabouts, todo = Whereabouts(case.oracle, buffers), checks(case, stage, Sparing(SAMPLE, only))
    while True:
        with clock.phase("rebased"):
            check = next(todo, None)
            if check is None:
                return
            clock.tell(f"stage {check.stage}: {check.buffer}")
            if only is not None and check.where.shape == only.shape:
                check = check.only_at(only)
            verdict = judged(check, whereabouts)
            if verdict.failed:
                doubtful = suspects(method, check.pass_name, check.buffer, buffers)
                verdict = replace(verdict, suspects=doubtful)
            elif verdict.loose:
                verdict = replace(verdict, narrowing=narrowing(method, check.pass_name, check.buffer, buffers))
        yield check, verdict


def _snapped_alike(oracle: Result, profile: Profile) -> Result:
    """The rendering with as many bits as an exact processor snaps to; others are judged by all that they may draw."""
    if not profile.draws_exactly or profile.subpixel_bits == FINEST:
        return oracle
    return render(oracle.scene, subpixel_bits=profile.subpixel_bits)


def _near_to_far(oracle: Result, drawing: Drawing) -> Drawing:
    """The drawing with depths that grow with the distance, of one in which they fall."""
    depths = {each.draw.depth for each in oracle.scene.method.passes} & set(drawing.buffers)
    turned = {name: np.float32(1) - drawing.buffers[name] for name in depths}
    return replace(drawing, buffers={**drawing.buffers, **turned})


def assert_valid(
    scene: Scene | Result | str | PathLike[str],
    buffers: Buffers | str | PathLike[str],
    stored: Stored | None = None,
    profile: Profile | str = DEFAULT_PROFILE,
) -> None:
    """For tests: raise AssertionError, with the report's summary and what would explain it, unless all is right.

    scene, buffers, stored, profile: as in `validate`.
    """
    __tracebackhide__ = True  # pytest shows the line that called it
    report = validate(scene, buffers, stored, profile=profile, explain=Scope(power=False))
    if not report.passed:
        raise AssertionError("\n".join([report.summary, *report.details, *report.explanations]))


def _check_buffers(oracle: Result, buffers: Buffers) -> None:
    forms = oracle.scene.forms
    for name, buffer in buffers.items():
        if name not in forms:
            raise SceneError(f"buffers: expected names of {', '.join(forms)}, got {name!r}")
        form = forms[name]
        if (buffer.shape, buffer.dtype) != (form.shape, form.dtype):
            expected = f"{form.dtype} {form.shape}"
            raise SceneError(f"buffers: expected {name} as {expected}, got {buffer.dtype} {buffer.shape}; convert it")


def _check_something_is_drawn(oracle: Result, only: np.ndarray | None) -> None:
    """Raise SceneError where a blank picture would be right, and so would prove nothing."""
    shown = oracle["coverage"] != 0
    if not (shown if only is None else shown & only).any():
        where, expected = oracle.scene.settings.mesh.path, "a mesh that covers some of the pixels judged"
        raise SceneError(told(where, expected, "none", "change the view or the region; a blank picture proves nothing"))


def _check_stage(oracle: Result, scope: Scope) -> None:
    """Raise SceneError for a stage that none of the passes has."""
    of_passes = {each.name: [stage.name for stage in each.stages] for each in oracle.scene.method.passes}
    stages = {RASTERIZER, *chain(*of_passes.values())}
    if scope.stage is not None and scope.stage not in stages:
        own = of_passes.get(scope.stage)
        remedy = f"write a stage of this pass: {', '.join(own)}" if own else nearest(scope.stage, stages)
        raise SceneError(told("only", "a stage of the method", scope.stage, remedy))


def _sight(case: Case, judged: Mapping[str, np.ndarray]) -> tuple["Power", ...]:
    """How small an error would be seen. judged: buffer -> its compared pixels, bool (H, W)."""
    from sss_ref.validation.cause.power import power

    return tuple(power(case, judged))


def _finding(case: Case, check: Check, verdict: Verdict, seconds: float) -> Finding:
    """Look closer at what is wrong, with all that this takes, which a right dump does not."""
    from sss_ref.validation.cause.hypotheses import hypotheses
    from sss_ref.validation.cause.puzzle import Puzzle

    drawn = last_round(case, case.oracle.scene.method[check.pass_name])
    worst = verdict.worst if check.stage != RASTERIZER else None
    section, witness = _at_worst(check, worst.at, drawn) if worst else (None, None)
    if not check.where.any():
        return Finding(check, (), section, witness)
    limit = Limit(seconds)
    found = hypotheses(Puzzle(case, check.where_bounded, drawn, all_stages(), limit))
    return Finding(check, tuple(found), section, witness, limit.told)


def _at_worst(check: Check, pixel: tuple[int, int], drawn: DrawnPass) -> "tuple[Section, Witness]":
    """The stage at the worst pixel (column, row), line by line and cut down to it."""
    from sss_ref.validation.report.worst_pixel import worst_pixel
    from sss_ref.validation.witness.cutting import cut_down

    run = run_stage(drawn, (np.array([pixel[1]]), np.array([pixel[0]])), check.buffer)
    return worst_pixel(check, pixel, run, drawn.profile), cut_down(check, pixel, run, drawn)
