"""`sss-ref init`: a scene file to start from."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import out


def init(
    mesh: Annotated[str, Parameter(help="A mesh file, or the name of a shipped mesh.")],
    /,
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The scene file to write.")] = Path("scene.toml"),
    force: Annotated[bool, Parameter(negative="", help="Replace the scene file if there is one.")] = False,
) -> int:
    """Write a scene file for a mesh, with comments: framed, lit from the front and from behind, its unit guessed."""
    from sss_ref.scene.first_scene import write_first_scene

    write_first_scene(mesh, output, replace=force)
    out.print(f"{escape(str(output))}: sss-ref render {escape(str(output))} shows it")
    return 0
