"""The command line: `sss-ref render`, `verify`, `diff`, `explain` and so on. Nothing is computed here."""

from cyclopts import App, CycloptsError

from sss_ref.cli.batch_commands import batch, turntable
from sss_ref.cli.blame_command import blame
from sss_ref.cli.comparing import diff, verify
from sss_ref.cli.console import BAD_INPUT, Stream, complain, err
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
    `import` asks for something or an item of `batch` failed, or 2 for bad input, where nothing was judged, and where
    the system has no more memory or place. Raises SystemExit where nobody reads on (141) or the run is stopped (130).
    """
    try:
        return app(tokens, exit_on_error=False, console=Stream(), error_console=err) or 0
    except SssRefError as error:
        return complain(str(error))
    except CycloptsError:
        return BAD_INPUT  # cyclopts has printed it
    except MemoryError:
        return complain(
            "memory: expected enough for what was asked, got no more; ask for a smaller size or less at once"
        )
    except ImportError as error:
        return complain(f"{error.name}: expected a library that loads, got a refusal; install it again or free memory")
    except OSError as error:  # whatever no room has foreseen: a full disk below standard output, a limit of the system
        where, came = error.filename or "sss-ref", error.strerror or "a refusal"
        return complain(f"{where}: expected a system that goes on, got {came}; see to that and run it again")
