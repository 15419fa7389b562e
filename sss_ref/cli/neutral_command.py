"""`sss-ref neutral`."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from sss_ref.cli.console import DIFFERS, out, progress
from sss_ref.cli.options import NO_CHANGES, Changes
from sss_ref.cli.shader_files import shaders_of


def neutral(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    shaders: Annotated[
        Path | None,
        Parameter(help="A folder of shaders (camera.frag ...), drawn by this machine's OpenGL.", show_default=False),
    ] = None,
    run_glsl: Annotated[bool, Parameter(negative="", help="Draw with OpenGL also without shaders of yours.")] = False,
    only: Annotated[
        tuple[str, ...], Parameter(negative="", help="Make this change only, by its name.", show_default=False)
    ] = (),
    changes: Changes = NO_CHANGES,
) -> int:
    """Change what must change nothing, and tell the first pixel that changed all the same.

    Two lights swapped, vertices in another order, everything twice as large, a larger picture and more: all buffers are
    compared bit for bit. Exit code 1 if one differs.
    """
    from sss_ref.neutral.trial import neutral as trials
    from sss_ref.scene.load import load_scene

    loaded = load_scene(scene, **changes.overrides())
    artist = None
    if shaders or run_glsl:
        from sss_ref.gl.shader_artist import ShaderArtist

        artist = ShaderArtist(shaders_of(shaders, loaded.settings))
    broken = 0
    with progress("drawing"):
        for trial in trials(loaded, artist, only):
            out.print(str(trial), markup=False)
            broken += bool(trial.broken)
    out.print(f"broken: {broken}" if broken else "neutral: nothing changed")
    return DIFFERS if broken else 0
