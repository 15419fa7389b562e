"""The question itself: is this what a right implementation draws, and if not, where does it go wrong."""

from dataclasses import replace
from functools import cache
from importlib import import_module
from pkgutil import iter_modules

import numpy as np

import sss_ref.passes
from sss_ref.errors import SceneError
from sss_ref.explanation.explain import StageTrace
from sss_ref.explanation.rows import Detail, Section, section_of
from sss_ref.interpret.profile import Profile
from sss_ref.interpret.trace import scalar, trace
from sss_ref.interpret.work import Work
from sss_ref.language import Stage
from sss_ref.methods.catalogue import method_of_scene
from sss_ref.rendering import render
from sss_ref.result import Result
from sss_ref.scene.load import Scene
from sss_ref.validation.chained import Bounds, chained
from sss_ref.validation.hypotheses import hypotheses
from sss_ref.validation.profile_file import profile_of
from sss_ref.validation.rebased import (
    RASTERIZER,
    Buffers,
    Check,
    Judgement,
    Stored,
    checks,
    rebased,
    walk,
    work_of,
)
from sss_ref.validation.storage import STEPS, step_of
from sss_ref.validation.verdict import Finding, Report, Verdict, judged

DEFAULT_PROFILE = "vulkan"


def validate(
    scene: Scene | Result,
    buffers: Buffers,
    stored: Stored | None = None,
    only: np.ndarray | None = None,
    profile: Profile | str = DEFAULT_PROFILE,
    explain: bool = True,
) -> Report:
    """Hold the buffers of another implementation against the stages, one stage at a time.

    scene: what was drawn, or its rendering with all buffers. buffers: name -> array as in `Result`, (H, W) or
    (H, W, C), row 0 at the bottom, float32, int32 or uint8; any of the method's, the more the nearer the culprit.
    stored: buffer -> what its texture holds where that is less than float32: "float16", "unorm8", "unorm16", "srgb8".
    only: bool (H, W) of the camera's size, the pixels of its buffers that are judged.
    profile: the processor that may have drawn them, by name ("ieee", "vulkan", "gl", "mediump"), as a TOML file or as a
    Profile; accepted is what it may give. explain: whether to look for what would explain a failure.
    Raises SceneError where a buffer is not one of the scene, or not of its type and size.
    """
    oracle = scene if isinstance(scene, Result) else render(scene)
    _check_buffers(oracle, buffers)
    how = Judgement(
        profile_of(profile) if isinstance(profile, str) else profile,
        {name: storage for name, storage in (stored or {}).items() if storage in STEPS},
    )
    verdicts, wrong, bounds = [], None, chained(oracle, how.profile)
    for check in checks(oracle, buffers, how):
        if only is not None and check.where.shape == only.shape:
            check = replace(check, where=check.where & only)
        verdicts.append(replace(judged(check), chained=_within_bounds(check, bounds, how)))
        if wrong is None and not verdicts[-1].passed:
            wrong = check, verdicts[-1]
    there = {verdict.buffer for verdict in verdicts}
    missing = tuple(name for name in oracle.buffers if name not in there)
    return Report(tuple(verdicts), missing, _finding(oracle, buffers, how, *wrong) if wrong and explain else None)


def _within_bounds(check: Check, bounds: Bounds, how: Judgement) -> int | None:
    """How many compared pixels lie within the chained bounds; None of what the rasterizer writes, which has none."""
    if check.stage == RASTERIZER:
        return None
    low, high = (np.atleast_3d(end)[check.where].astype(np.float64) for end in bounds[check.buffer])
    got = np.atleast_3d(check.got)[check.where].astype(np.float64)
    rounding = step_of(how.stored.get(check.buffer, ""), got)
    return int(((got >= low - rounding) & (got <= high + rounding)).all(axis=-1).sum())


def assert_valid(
    scene: Scene | Result, buffers: Buffers, stored: Stored | None = None, profile: Profile | str = DEFAULT_PROFILE
) -> None:
    """For tests: raise AssertionError, with the report's summary and what would explain it, unless all is right.

    scene, buffers, stored, profile: as in `validate`.
    """
    report = validate(scene, buffers, stored, profile=profile)
    assert report.passed, "\n".join([report.summary, *report.explanations])


def _check_buffers(oracle: Result, buffers: Buffers) -> None:
    for name, buffer in buffers.items():
        if name not in oracle.buffers:
            raise SceneError(f"buffers: expected names of {', '.join(oracle.buffers)}, got {name!r}")
        ours = oracle[name]
        if (buffer.shape, buffer.dtype) != (ours.shape, ours.dtype):
            form = f"{ours.dtype} {ours.shape}"
            raise SceneError(f"buffers: expected {name} as {form}, got {buffer.dtype} {buffer.shape}; convert it")


def _finding(oracle: Result, buffers: Buffers, how: Judgement, check: Check, verdict: Verdict) -> Finding:
    """Look closer at what is wrong."""
    rendering = rebased(oracle, buffers)
    scene = oracle.scene
    (one,) = (each for each in method_of_scene(scene).passes if each.name == check.pass_name)
    work = work_of(rendering, one)
    found = hypotheses(check, work, buffers, how, _all_stages()) if check.where.any() else []
    return Finding(check, tuple(found), _worst_section(verdict, work, buffers, how))


def _worst_section(verdict: Verdict, work: Work, buffers: Buffers, how: Judgement) -> Section | None:
    """The stage at the worst pixel, with what was dumped before it."""
    pixel = verdict.worst_pixel
    if pixel is None or verdict.stage not in {stage.name for stage in work.one.stages}:
        return None
    at = np.array([pixel[1]]), np.array([pixel[0]])
    step = next(step for step in walk(work, at, buffers, how) if verdict.buffer in step.results)
    inputs = [scalar(value) for value in step.inputs]
    steps, writes = trace(step.stage, inputs)
    traced = StageTrace(step.stage, dict(zip(step.stage.reads.values(), inputs, strict=True)), steps, writes)
    return section_of(traced, Detail(depth=1, glsl=True))


@cache
def _all_stages() -> dict[str, Stage]:
    """Every stage of the package by name."""
    modules = [import_module(f"sss_ref.passes.{each.name}") for each in iter_modules(sss_ref.passes.__path__)]
    return {value.name: value for module in modules for value in vars(module).values() if isinstance(value, Stage)}
