"""A folder of a user's shaders, as the commands that draw with them take it."""

from pathlib import Path
from typing import TYPE_CHECKING

from rich.markup import escape

from sss_ref.cli.console import err

if TYPE_CHECKING:
    from sss_ref.scene_file.settings import SceneFile


def shaders_of(folder: Path | None, settings: "SceneFile") -> dict[str, list[Path]]:
    """The shaders of a folder by their pass, after a line says what of it is not read; without a folder none.

    Raises ShaderError as `shader_folder` does.
    """
    from sss_ref.gl.shaders import passed_over, shader_folder

    if folder is None:
        return {}
    files = shader_folder(folder, settings)
    others = passed_over(folder, files)
    if others:
        listed = ", ".join(f"{name} ({why})" for name, why in others.items())
        err.print(f"[yellow]note:[/] {escape(str(folder))}: not read: {escape(listed)}")
    return files
