"""`sss-ref validate`."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter
from rich.box import SIMPLE
from rich.table import Table

from sss_ref.cli.console import DIFFERS, announce_compilation, out, progress
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes, Execution
from sss_ref.errors import ShaderError

if TYPE_CHECKING:
    from sss_ref.validate.verdict import Report


def validate(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")],
    shaders: Annotated[
        Path | None,
        Parameter(help="A folder of GLSL files, each in the place of ours: camera.frag, camera.vert, blur.frag ..."),
    ] = None,
    /,
    *,
    run_glsl: Annotated[bool, Parameter(negative="", help="Draw the scene with shaders on this machine's OpenGL.")],
    changes: Changes = NO_CHANGES,
    execution: Execution = KERNELS,
) -> int:
    """Hold what shaders draw against the stages, one at a time, and name the first that is wrong.

    Every stage gets what the shaders drew before it, so an error counts where it is made. Exit code 1 if a stage is
    wrong.
    """
    from sss_ref.gl import draw
    from sss_ref.gl.shaders import shader_folder
    from sss_ref.rendering import render
    from sss_ref.scene.load import load_scene
    from sss_ref.validate.validation import validate as validate_buffers

    if not run_glsl:
        raise ShaderError("validate: expected --run-glsl, got none; add it")
    loaded = load_scene(scene, **changes.overrides())
    theirs = shader_folder(shaders, loaded.settings) if shaders else {}
    announce_compilation(execution)
    with progress("drawing") as show:
        drawn = draw(loaded, theirs)
        oracle = render(loaded, execution.interpreter, execution.threads, on_pass=lambda name: show(f"pass {name}"))
        show("comparing")
        found = validate_buffers(oracle, drawn)
    out.print(_table(found))
    if found.missing:
        out.print(f"not drawn: {', '.join(found.missing)}")
    out.print(found.summary, markup=False)
    for hypothesis in found.finding.hypotheses if found.finding else ():
        out.print(f"  explained on {hypothesis.share:.1%} of the pixels looked at: {hypothesis.text}", markup=False)
    return 0 if found.passed else DIFFERS


def _table(found: "Report") -> Table:
    from sss_ref.io.diff import ULP_CLASSES

    table = Table(box=SIMPLE, title="each stage, given what was drawn before it", title_justify="left")
    for name in ("pass", "stage", "buffer"):
        table.add_column(name, no_wrap=True)
    for name in ("pixels", "same bits", "in reach", f"{ULP_CLASSES[1]} ulp", *ULP_CLASSES[2:]):
        table.add_column(name, justify="right", no_wrap=True)
    for one in found.verdicts:
        share = [f"{count / one.compared:.2%}" if one.compared else "-" for count in (one.equal, one.within)]
        cells = [one.pass_name, one.stage, one.buffer, str(one.compared), *share, *map(str, one.ulps[1:])]
        table.add_row(*cells, style=None if one.passed else "red")
    return table
