"""`sss-ref validate`."""

from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import DIFFERS, announce_compilation, err, out, progress
from sss_ref.cli.import_command import tell_doubts
from sss_ref.cli.options import KERNELS, NO_CHANGES, NO_HASTE, Changes, Execution, Haste
from sss_ref.cli.shader_files import shaders_of
from sss_ref.cli.verdicts import print_report
from sss_ref.errors import DumpError, ShaderError
from sss_ref.errors.wording import told

if TYPE_CHECKING:
    import numpy as np

    from sss_ref.dump.read import Dump
    from sss_ref.rendering.result import Result
    from sss_ref.scene.scene import Scene
    from sss_ref.validation.accept.dumped import Drawing
    from sss_ref.validation.report.report import Report

RUN_GLSL, RUN_WGSL = "--run-glsl", "--run-wgsl"
USUAL = {"": "vulkan", RUN_GLSL: "vulkan", RUN_WGSL: "wgsl"}  # what draws -> the profile


def validate(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")],
    dump: Annotated[
        Path | None,
        Parameter(
            help="A folder of buffers, a mapping file or a RenderDoc capture; with `--run-glsl` or `--run-wgsl` a "
            "folder of shaders (camera.frag ...)."
        ),
    ] = None,
    /,
    *,
    run_glsl: Annotated[bool, Parameter(negative="", help="Draw the scene on this machine's OpenGL instead.")] = False,
    run_wgsl: Annotated[bool, Parameter(negative="", help="Draw the scene on this machine's WebGPU instead.")] = False,
    auto: Annotated[
        bool, Parameter(negative="", help="Tell by what is in the files which buffers they are, not by their names.")
    ] = False,
    origin: Annotated[
        Literal["top", "bottom"] | None,
        Parameter(help="The row that the dump's files begin with; NPY: bottom, pictures: top.", show_default=False),
    ] = None,
    region: Annotated[str | None, Parameter(help="Judge these pixels only: X,Y,W,H.", show_default=False)] = None,
    exclude: Annotated[
        Path | None, Parameter(help="A mask (PNG or NPY) of pixels not to judge.", show_default=False)
    ] = None,
    profile: Annotated[
        str | None,
        Parameter(
            help="Accept what such a processor may give: ieee, vulkan, wgsl, gl, mediump or a TOML file; vulkan unless "
            "given, with `--run-wgsl` wgsl.",
            show_default=False,
        ),
    ] = None,
    report: Annotated[
        Path | None, Parameter(help="A folder for report.html and report.json.", show_default=False)
    ] = None,
    junit: Annotated[
        Path | None, Parameter(help="A file for the verdicts as JUnit XML, a test case a buffer.", show_default=False)
    ] = None,
    witness: Annotated[
        Path | None,
        Parameter(help="A file for the worst pixel, cut down to its stage: see `witness`.", show_default=False),
    ] = None,
    metrics: Annotated[bool, Parameter(negative="", help="Tell also what SSIM and FLIP say of the pictures.")] = False,
    haste: Haste = NO_HASTE,
    changes: Changes = NO_CHANGES,
    execution: Execution = KERNELS,
) -> int:
    """Hold what a GPU drew against the stages, one at a time, and name the first that is wrong.

    Every stage gets what was drawn before it, so an error counts where it is made. Exit code 1 if a stage is wrong, 2
    if nothing could be judged.
    """
    from sss_ref.capture.renderdoc_file import is_capture
    from sss_ref.rendering.fold import render
    from sss_ref.scene.load import load_scene
    from sss_ref.validation.clock import Clock
    from sss_ref.validation.report.metrics import likeness, require_packages
    from sss_ref.validation.stage_by_stage import judge

    if junit:
        from sss_ref.validation.report.junit import checked_junit_file, write_junit

        checked_junit_file(junit)
    shown_by = _chosen(run_glsl, run_wgsl)
    by_content = auto or (is_capture(dump) and not shown_by)
    loaded = load_scene(scene, **changes.overrides())
    if metrics:
        require_packages()
    announce_compilation(execution)
    with progress("reading") as show:
        clock = Clock(show)
        with clock.phase("reading"):
            drawing = None if by_content else _read(loaded, dump, origin, shown_by)
            only = _judged_pixels(loaded, region, exclude)
        with clock.phase("rendering"):
            oracle = render(loaded, execution.interpreter, execution.threads, on_pass=lambda name: show(f"pass {name}"))
        if drawing is None:
            with clock.phase("recognising"):
                drawing = _recognized(oracle, dump)
        found = judge(oracle, drawing, only, profile or USUAL[shown_by], haste.scope(report is not None), clock)
        if metrics:
            with clock.phase("metrics"):
                found = replace(found, likeness=tuple(likeness(oracle, drawing.buffers)))
    if found.judged:
        print_report(found)
    if report:
        from sss_ref.validation.report.report_page import write_report

        out.print(f"{write_report(found, report, f'{scene}: is it right?')}", markup=False)
    if junit:
        out.print(f"{write_junit(found, junit, scene)}", markup=False)
    if witness:
        out.print(_written_witness(found, witness), markup=False)
    if not found.judged:
        raise DumpError(_nothing_judged(found, shown_by or str(dump)))
    return 0 if found.passed else DIFFERS


def _written_witness(found: "Report", path: Path) -> str:
    """Write the witness, if there is one; what came of it, in words."""
    from sss_ref.validation.witness.recording import recorded
    from sss_ref.validation.witness.witness_record import write_record

    if found.finding is None:
        return f"{path} not written: no stage is wrong"
    if found.finding.witness is None:
        return f"{path} not written: only a pixel that a stage computes can be cut down to it"
    return f"{write_record(recorded(found.finding.witness), path)}: judge it with sss-ref witness"


def _nothing_judged(found: "Report", where: str) -> str:
    return told(where, "a buffer with pixels to judge", found.nothing, "give other buffers, or more, or another view")


def _chosen(run_glsl: bool, run_wgsl: bool) -> str:
    """The option that says what draws, empty for none. Raises ShaderError for both."""
    if run_glsl and run_wgsl:
        raise ShaderError(told("validate", f"one of {RUN_GLSL} and {RUN_WGSL}", "both", "give one"))
    return RUN_GLSL if run_glsl else RUN_WGSL if run_wgsl else ""


def _read(scene: "Scene", given: Path | None, origin: Literal["top", "bottom"] | None, shown_by: str) -> "Drawing":
    """What is to be judged: dumped, or drawn here."""
    return _shown(scene, given, shown_by) if shown_by else _dumped(scene, given, origin)


def _shown(scene: "Scene", shaders: Path | None, shown_by: str) -> "Drawing":
    """What this machine draws, with the shaders of a folder if one is given."""
    from sss_ref import gl, webgpu
    from sss_ref.language.pipeline import REGISTERS
    from sss_ref.validation.accept.dumped import Drawing

    draw, device = (gl.draw, gl.device_name) if shown_by == RUN_GLSL else (webgpu.draw, webgpu.adapter_name)
    buffers = draw(scene, shaders_of(shaders, scene.settings), keep=("all", REGISTERS))
    return Drawing(buffers, device=device())


def _dumped(scene: "Scene", dump: Path | None, origin: Literal["top", "bottom"] | None) -> "Drawing":
    from sss_ref.dump.read import read_dump

    return _told(read_dump(_given(dump), scene, origin))


def _recognized(oracle: "Result", dump: Path | None) -> "Drawing":
    """The buffers that pictures without telling names are."""
    from sss_ref.capture.recognized import recognized
    from sss_ref.capture.renderdoc_file import is_capture

    with TemporaryDirectory() as folder:
        found = recognized(_given(dump), oracle, Path(folder) if is_capture(dump) else None)
        tell_doubts(found)
        return _told(found.dump())


def _given(dump: Path | None) -> Path:
    if dump is None:
        expected = f"a folder of buffers, a mapping file, {RUN_GLSL} or {RUN_WGSL}"
        raise DumpError(told("validate", expected, "none", "give one"))
    return dump


def _told(found: "Dump") -> "Drawing":
    """A dump as what drew it, after its notes are told."""
    from sss_ref.validation.accept.dumped import Drawing

    for note in (*found.notes, *(f"{one.name}: {note}" for one in found.buffers.values() for note in one.notes)):
        err.print(f"[yellow]note:[/] {escape(note)}")
    return Drawing.read(found)


def _judged_pixels(scene: "Scene", region: str | None, exclude: Path | None) -> "np.ndarray | None":
    """Bool (H, W) of the camera's size; None for all."""
    import numpy as np

    from sss_ref.dump.selection import parsed_region, read_exclusion

    width, height = scene.settings.camera.width, scene.settings.camera.height
    if region is None and exclude is None:
        return None
    chosen = np.zeros((height, width), bool)
    chosen[parsed_region(region, width, height).slices if region else ...] = True
    return chosen & ~read_exclusion(exclude, width, height) if exclude else chosen
