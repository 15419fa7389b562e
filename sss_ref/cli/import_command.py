"""`sss-ref import`."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sss_ref.cli.console import DIFFERS, announce_compilation, err, out, progress
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes, Execution

if TYPE_CHECKING:
    from sss_ref.capture.recognized import Recognized


def import_(
    source: Annotated[Path, Parameter(help="A folder of pictures, whatever their names.")],
    scene: Annotated[str, Parameter(help="What they show: a scene file, a bundle, or the name of a shipped scene.")],
    /,
    *,
    output: Annotated[
        Path | None, Parameter(alias="-o", help="The folder for mapping.toml; the source's own if not given.")
    ] = None,
    changes: Changes = NO_CHANGES,
    execution: Execution = KERNELS,
) -> int:
    """Tell by what is in pictures which buffers they are, and write a mapping file that says so.

    Exit code 1 if a picture might be several buffers, or several one: such are asked for and never guessed.
    """
    from sss_ref.capture.recognized import recognized
    from sss_ref.rendering.fold import render
    from sss_ref.scene.load import load_scene

    loaded = load_scene(scene, **changes.overrides())
    announce_compilation(execution)
    with progress("rendering") as show:
        oracle = render(loaded, execution.interpreter, execution.threads, on_pass=lambda name: show(f"pass {name}"))
        show("comparing")
        found = recognized(source, oracle)
    target = output or source
    target.mkdir(parents=True, exist_ok=True)
    path = found.write(target)
    for line in found.lines():
        out.print(line, markup=False)
    tell_doubts(found)
    out.print(f"{path}: sss-ref validate {scene} {path} judges them", markup=False)
    return DIFFERS if found.placed.questions else 0


def tell_doubts(found: "Recognized") -> None:
    """Say what is to be looked at, on standard error."""
    for line in found.doubts():
        err.print("[yellow]note:[/]", end=" ")
        err.print(line, markup=False)
