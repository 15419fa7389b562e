"""`sss-ref validate`."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter
from rich.box import SIMPLE
from rich.table import Table

from sss_ref.cli.console import DIFFERS, announce_compilation, err, out, progress
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes, Execution
from sss_ref.errors import DumpError

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np

    from sss_ref.scene.load import Scene
    from sss_ref.validation.verdict import Report

Given = tuple["Mapping[str, np.ndarray]", "Mapping[str, str]"]  # buffers, and what their textures held


def validate(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")],
    dump: Annotated[
        Path | None,
        Parameter(
            help="A folder of buffers or a mapping file; with `--run-glsl` a folder of shaders (camera.frag ...)."
        ),
    ] = None,
    /,
    *,
    run_glsl: Annotated[bool, Parameter(negative="", help="Draw the scene on this machine's OpenGL instead.")] = False,
    origin: Annotated[
        Literal["top", "bottom"] | None,
        Parameter(help="The row that the dump's files begin with; NPY: bottom, pictures: top.", show_default=False),
    ] = None,
    region: Annotated[str | None, Parameter(help="Judge these pixels only: X,Y,W,H.", show_default=False)] = None,
    exclude: Annotated[
        Path | None, Parameter(help="A mask (PNG or NPY) of pixels not to judge.", show_default=False)
    ] = None,
    profile: Annotated[
        str, Parameter(help="Accept what such a processor may give: ieee, vulkan, gl, mediump or a TOML file.")
    ] = "vulkan",
    report: Annotated[
        Path | None, Parameter(help="A folder for report.html and report.json.", show_default=False)
    ] = None,
    changes: Changes = NO_CHANGES,
    execution: Execution = KERNELS,
) -> int:
    """Hold what a GPU drew against the stages, one at a time, and name the first that is wrong.

    Every stage gets what was drawn before it, so an error counts where it is made. Exit code 1 if a stage is wrong.
    """
    from sss_ref.rendering import render
    from sss_ref.scene.load import load_scene
    from sss_ref.validation.report import write_report
    from sss_ref.validation.stage_by_stage import validate as validate_buffers

    loaded = load_scene(scene, **changes.overrides())
    announce_compilation(execution)
    with progress("reading") as show:
        buffers, stored = _drawn(loaded, dump) if run_glsl else _dumped(loaded, dump, origin)
        only = _judged_pixels(loaded, region, exclude)
        oracle = render(loaded, execution.interpreter, execution.threads, on_pass=lambda name: show(f"pass {name}"))
        show("comparing")
        found = validate_buffers(oracle, buffers, stored, only, profile)
    out.print(_table(found))
    for one in (one for one in found.verdicts if one.ambiguous or one.unbounded):
        out.print(f"{one.buffer}: {one.ambiguous} pixels may be one of several values, {one.unbounded} are unbounded")
    if found.missing:
        out.print(f"not given: {', '.join(found.missing)}")
    for line in (found.summary, *(f"  {text}" for text in found.explanations)):
        out.print(line, markup=False)
    if report:
        out.print(f"{write_report(found, report, f'{scene}: is it right?')}", markup=False)
    return 0 if found.passed else DIFFERS


def _drawn(scene: "Scene", shaders: Path | None) -> Given:
    from sss_ref.gl import draw
    from sss_ref.gl.shaders import shader_folder

    return draw(scene, shader_folder(shaders, scene.settings) if shaders else {}), {}


def _dumped(scene: "Scene", dump: Path | None, origin: Literal["top", "bottom"] | None) -> Given:
    from sss_ref.io.dump.read import read_dump

    if dump is None:
        raise DumpError("validate: expected a folder of buffers, a mapping file, or --run-glsl, got none; give one")
    found = read_dump(dump, scene, origin)
    for note in (*found.notes, *(f"{one.name}: {note}" for one in found.buffers.values() for note in one.notes)):
        err.print(f"[yellow]note:[/] {note}", highlight=False)
    buffers = {name: one.data for name, one in found.buffers.items()}
    return buffers, {name: one.storage for name, one in found.buffers.items()}


def _judged_pixels(scene: "Scene", region: str | None, exclude: Path | None) -> "np.ndarray | None":
    """Bool (H, W) of the camera's size; None for all."""
    import numpy as np

    from sss_ref.io.dump.selection import parsed_region, read_exclusion

    width, height = scene.settings.camera.width, scene.settings.camera.height
    if region is None and exclude is None:
        return None
    chosen = np.zeros((height, width), bool)
    chosen[parsed_region(region, width, height).slices if region else ...] = True
    return chosen & ~read_exclusion(exclude, width, height) if exclude else chosen


def _table(found: "Report") -> Table:
    from sss_ref.io.diff import ULP_CLASSES

    table = Table(box=SIMPLE, title="each stage, given what was drawn before it", title_justify="left")
    for name in ("pass", "stage", "buffer"):
        table.add_column(name, no_wrap=True)
    for name in ("pixels", "same bits", "in reach", "chained", f"{ULP_CLASSES[1]} ulp", *ULP_CLASSES[2:]):
        table.add_column(name, justify="right", no_wrap=True)
    for one in found.verdicts:
        share = [f"{count / one.compared:.2%}" if one.compared else "-" for count in (one.equal, one.within)]
        whole = f"{one.chained / one.compared:.2%}" if one.compared and one.chained is not None else "-"
        cells = [one.pass_name, one.stage, one.buffer, str(one.compared), *share, whole, *map(str, one.ulps[1:])]
        table.add_row(*cells, style="yellow" if one.inherits else None if one.passed else "red")
    return table
