"""`sss-ref blame`."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sss_ref.cli.console import DIFFERS, out, progress
from sss_ref.cli.options import NO_CHANGES, Changes
from sss_ref.cli.shader_files import shaders_of

if TYPE_CHECKING:
    from sss_ref.blame.blaming import Suspicion
    from sss_ref.scene.scene import Scene


def blame(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")],
    shaders: Annotated[Path, Parameter(help="A folder of your shaders: camera.frag ...")],
    /,
    *,
    dump: Annotated[
        Path | None,
        Parameter(
            help="What your renderer drew with them: a folder of buffers or a mapping file. Without, this machine's "
            "OpenGL draws.",
            show_default=False,
        ),
    ] = None,
    profile: Annotated[
        str, Parameter(help="Accept what such a processor may give: ieee, vulkan, wgsl, gl, mediump or a TOML file.")
    ] = "vulkan",
    changes: Changes = NO_CHANGES,
) -> int:
    """Tell whose fault a wrong picture is: the shader, its translator or compiler, a setting, or an input.

    The source of the first wrong pass is drawn again on other stacks, from what was drawn before it. Exit code 1 if
    anything is wrong.
    """
    from sss_ref.blame.blaming import NOBODY
    from sss_ref.scene.load import load_scene

    loaded = load_scene(scene, **changes.overrides())
    with progress("drawing"):
        found = _suspicion(loaded, shaders, dump, profile).blame()
    for line in (*found.because, f"whose fault: {found.whose}"):
        out.print(line, markup=False)
    return 0 if found.whose == NOBODY else DIFFERS


def _suspicion(scene: "Scene", shaders: Path, dump: Path | None, profile: str) -> "Suspicion":
    """What was drawn, by whom, and who may draw it again."""
    from sss_ref.blame.blaming import Suspicion
    from sss_ref.blame.stacks import language_of, stacks_here
    from sss_ref.dump.read import read_dump
    from sss_ref.gl import device_name, draw
    from sss_ref.language.pipeline import REGISTERS
    from sss_ref.validation.accept.dumped import Drawing

    files = shaders_of(shaders, scene.settings)
    if dump:
        drawing = Drawing.read(read_dump(dump, scene))
    else:
        drawing = Drawing(draw(scene, files, keep=("all", REGISTERS)), device=device_name())
    return Suspicion(scene, drawing, files, stacks_here(language_of(files)), profile, ours=dump is None)
