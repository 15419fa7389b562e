"""The command line: `sss-ref render`, `verify`, `diff`, `explain` and so on. Nothing is computed here."""

from cyclopts import App, CycloptsError
from rich.markup import escape

from sss_ref.cli.batch_commands import batch, turntable
from sss_ref.cli.blame_command import blame
from sss_ref.cli.comparing import diff, verify
from sss_ref.cli.console import BAD_INPUT, err
from sss_ref.cli.course_commands import course, grade
from sss_ref.cli.explaining import explain
from sss_ref.cli.fit_command import fit
from sss_ref.cli.import_command import import_
from sss_ref.cli.listing import info, scenes
from sss_ref.cli.measure_command import measure
from sss_ref.cli.neutral_command import neutral
from sss_ref.cli.render_commands import render, warmup
from sss_ref.cli.shader_commands import bundle, glsl, webgl
from sss_ref.cli.starting import init
from sss_ref.cli.truth_commands import truth
from sss_ref.cli.validating import validate
from sss_ref.cli.view_command import view
from sss_ref.cli.witness_command import witness
from sss_ref.errors import SssRefError

MAPPING = "Print a mapping file to edit, with every buffer of a scene; its help explains every key."
PURPOSE = "The CPU reference for real-time subsurface scattering."


def _version() -> str:
    from sss_ref.results.manifest import package_version

    return package_version()


app = App(name="sss-ref", help=PURPOSE, version=_version, result_action="return_value")
for command in (
    init,
    render,
    view,
    batch,
    turntable,
    verify,
    diff,
    explain,
    glsl,
    bundle,
    webgl,
    validate,
    witness,
    neutral,
    blame,
    truth,
    fit,
    course,
    grade,
    measure,
    info,
    scenes,
    warmup,
):
    app.command(command)
app.command(import_, name="import")
app.command("sss_ref.cli.mapping_command:mapping", name="mapping", help=MAPPING)  # loaded when asked for


def main(tokens: list[str] | None = None) -> int:
    """Run the command line; returns the exit code.

    0, or 1 where `verify`, `diff`, `validate`, `witness`, `neutral` or `blame` finds a difference,
    `import` asks for something or an item of `batch` failed, or 2 for bad input, and where nothing was judged.
    """
    try:
        return app(tokens, exit_on_error=False, error_console=err) or 0
    except SssRefError as error:
        err.print(f"[red]error:[/] {escape(str(error))}")
        return BAD_INPUT
    except CycloptsError:
        return BAD_INPUT  # cyclopts has printed it
