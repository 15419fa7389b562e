"""`sss-ref import`."""

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sss_ref.cli.console import DIFFERS, announce_compilation, err, out, progress
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes, Execution
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import made_folder
from sss_ref.errors.wording import told

if TYPE_CHECKING:
    from sss_ref.capture.recognized import Recognized


def import_(
    source: Annotated[
        Path, Parameter(help="A folder of pictures, whatever their names, or a RenderDoc capture (.rdc).")
    ],
    scene: Annotated[
        str | None,
        Parameter(
            help="What they show: a scene file, a bundle, or the name of a shipped scene. Without it the pictures of a "
            "capture are only written, and listed.",
            show_default=False,
        ),
    ] = None,
    /,
    *,
    output: Annotated[
        Path | None,
        Parameter(
            alias="-o",
            help="The folder for mapping.toml, and for a capture's pictures; that of the source if not given.",
        ),
    ] = None,
    changes: Changes = NO_CHANGES,
    execution: Execution = KERNELS,
) -> int:
    """Tell by what is in pictures which buffers they are, and write a mapping file that says so.

    Exit code 1 if a picture might be several buffers, or several one: such are asked for and never guessed.
    """
    from sss_ref.capture.recognized import recognized
    from sss_ref.capture.renderdoc_file import is_capture
    from sss_ref.rendering.fold import render
    from sss_ref.scene.load import load_scene

    from_capture = is_capture(source)
    target = output or (source.with_suffix("") if from_capture else source)
    if scene is None:
        return _listed(source, target)
    loaded = load_scene(scene, **changes.overrides())
    announce_compilation(execution)
    with progress("rendering") as show:
        oracle = render(loaded, execution.interpreter, execution.threads, on_pass=lambda name: show(f"pass {name}"))
        show("comparing")
        found = recognized(source, oracle, made_folder(target, DumpError) if from_capture else None)
    path = found.write(made_folder(target, DumpError))
    for line in found.lines():
        out.print(line, markup=False)
    tell_doubts(found)
    out.print(f"{path}: sss-ref validate {scene} {path} judges them", markup=False)
    return DIFFERS if found.placed.questions else 0


def _listed(source: Path, target: Path) -> int:
    """Write the pictures of a capture, and list them."""
    from sss_ref.capture.renderdoc_file import captured, is_capture, listing

    if not is_capture(source):
        raise DumpError(told("import", "a scene to hold the pictures against", "none", "give it after the folder"))
    pictures, notes = captured(source, made_folder(target, DumpError))
    for line in listing(pictures):
        out.print(line, markup=False)
    print_notes(notes)
    out.print(f"{target}: {len(pictures)} pictures", markup=False)
    return 0


def tell_doubts(found: "Recognized") -> None:
    """Say what is to be looked at, on standard error."""
    print_notes(found.doubts())


def print_notes(notes: Iterable[str]) -> None:
    """Lines on standard error."""
    for line in notes:
        err.print("[yellow]note:[/]", end=" ")
        err.print(line, markup=False)
